# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The proxy GeodesicIsolines by the names of its properties, which are the scripting interface.

usage: GeodesicIsolines.py OUR_PLUGIN
"""

import os
import sys
import tempfile

import numpy as np
from paraview import simple

import testing

testing.load(sys.argv[1])


def column(proxy, name):
    return testing.vtk_to_numpy(testing.output_of(proxy).GetCellData().GetArray(name))


plane = simple.Plane(XResolution=20, YResolution=20)
distance = simple.GeodesicDistance(Input=plane, SeedPositions=[0.013, -0.021, 0])
isolines = simple.GeodesicIsolines(Input=distance)
assert len(isolines.Values) == 0
assert isolines.NumberOfValues == 10
# Neither has the input been updated nor the array been named.
assert isolines.MergeCoincidentPoints == 1 and isolines.ConnectBlocks == 1
values = np.unique(column(isolines, "GeodesicDistance"))
np.testing.assert_allclose(values, testing.array_of(distance).max() * np.arange(1, 11) / 11)

# The least is in the seed's face, where linear interpolation is wrong most.
isolines.Values = [0.4, 0.005, 0.1]
radius = np.array([0.005, 0.1, 0.4])
np.testing.assert_allclose(column(isolines, "GeodesicDistance"), radius)
np.testing.assert_allclose(column(isolines, "Length"), 2 * np.pi * radius, rtol=1e-6)
np.testing.assert_allclose(column(isolines, "EnclosedArea"), np.pi * radius**2, rtol=1e-6)
assert testing.output_of(isolines).GetLines().GetNumberOfCells() == 3

isolines.DistanceArray = ["POINTS", "Nothing"]
testing.expect_error(isolines, "Nothing")
assert "Nothing" in testing.informed(isolines, "ErrorText")

# The cost of Geodesic Distance is found by its note on the array, from a file as well.
cost = simple.Calculator(Input=plane, ResultArrayName="Cost", Function="0.2")
costed = simple.GeodesicDistance(
    Input=cost, SeedPositions=[0.013, -0.021, 0], CostArray=["POINTS", "Cost"]
)
circles = simple.GeodesicIsolines(Input=costed, Values=[0.2 * r for r in radius])
with tempfile.TemporaryDirectory() as folder:
    file = os.path.join(folder, "distances.vtp")
    simple.SaveData(file, proxy=costed, DataMode="Binary")
    read = simple.XMLPolyDataReader(FileName=[file])
    for source in [costed, read]:
        circles.Input = source
        np.testing.assert_allclose(column(circles, "Length"), 2 * np.pi * radius, rtol=1e-6)
        np.testing.assert_allclose(column(circles, "EnclosedArea"), np.pi * radius**2, rtol=1e-6)
