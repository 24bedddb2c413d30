# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""GeodesicCentre: centre, diameter, bounds, parts, blocks and mistakes.

usage: GeodesicCentre.py OUR_PLUGIN
"""

import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import testing

testing.load(sys.argv[1])


def centres_of(proxy):
    output = testing.output_of(proxy)
    arrays = {output.GetPointData().GetArrayName(i): np.array(vtk_to_numpy(output.GetPointData().GetArray(i)))
              for i in range(output.GetPointData().GetNumberOfArrays())}
    return np.array(vtk_to_numpy(output.GetPoints().GetData())), arrays


def expect_error(words, **options):
    proxy = simple.GeodesicCentre(**options)
    messages = testing.messages_of(proxy.UpdatePipeline)
    assert words in messages, (words, messages)
    assert testing.output_of(proxy).GetNumberOfPoints() == 0
    assert words in testing.informed(proxy, "ErrorText")


# A plane of 1 by 1: its middle, and one of its diagonals.
plane = simple.Plane(XResolution=20, YResolution=20)
proxy = simple.GeodesicCentre(Input=plane)
places, arrays = centres_of(proxy)
assert arrays["Role"].tolist() == [0, 1, 2] and arrays["Part"].tolist() == [0, 0, 0]
assert np.abs(places[0]).max() < 0.06, places
assert np.abs(np.abs(places[1:, :2]) - 0.5).max() < 1e-6 and np.abs(places[1] + places[2]).max() < 1e-6
assert abs(arrays["Diameter"][0] - np.sqrt(2)) < 1e-6 and abs(arrays["Radius"][0] - np.sqrt(0.5)) < 0.01
assert arrays["LeastRadius"][0] <= np.sqrt(0.5) + 1e-6 and arrays["MostDiameter"][0] >= np.sqrt(2) - 1e-6
points = testing.points_of(plane)
assert np.abs(points[arrays["OriginalPointIds"]] - places).max() < 1e-6
assert testing.informed(proxy, "NumberOfParts") == 1 and testing.informed(proxy, "LargestError") <= 0.01

# On the Bunny, with few fields the bounds are wider, and hold.
bunny = testing.bunny()
_, few = centres_of(simple.GeodesicCentre(Input=bunny, MaximumNumberOfFields=5, RelativeError=0))
_, many = centres_of(simple.GeodesicCentre(Input=bunny, MaximumNumberOfFields=60))
assert few["NumberOfFields"][0] == 5
slack = 0.01 * many["Diameter"][0]
assert few["LeastRadius"][0] <= many["Radius"][0] + slack and few["MostDiameter"][0] >= many["Diameter"][0] - slack
assert few["LeastRadius"][0] <= many["LeastRadius"][0] + slack

# Parts, by the position of their first point; blocks are one surface, unless told otherwise.
halves = [simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0], XResolution=4, YResolution=4),
          simple.Plane(Origin=[1, 0, 0], Point1=[2, 0, 0], Point2=[1, 1, 0], XResolution=4, YResolution=4)]
group = simple.GroupDatasets(Input=halves)
_, whole = centres_of(simple.GeodesicCentre(Input=group))
assert len(whole["Part"]) == 3 and abs(whole["Diameter"][0] - np.sqrt(5)) < 1e-6 and "OriginalBlocks" in whole
places, apart = centres_of(simple.GeodesicCentre(Input=group, ConnectBlocks=0))
assert apart["Part"].tolist() == [0, 0, 0, 1, 1, 1] and places[0, 0] < 1 < places[3, 0]

expect_error("RelativeError is -0.1", Input=plane, RelativeError=-0.1)
expect_error("MaximumNumberOfFields is 0", Input=plane, MaximumNumberOfFields=0)
expect_error("no surface", Input=simple.PointSource())
