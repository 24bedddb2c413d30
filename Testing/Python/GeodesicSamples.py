# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""GeodesicSamples: evenly spread points, regions, first positions, costs, barriers and mistakes.

usage: GeodesicSamples.py OUR_PLUGIN
"""

import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import testing

testing.load(sys.argv[1])


def outputs_of(proxy):
    proxy.UpdatePipeline()
    client = proxy.GetClientSideObject()
    return client.GetOutputDataObject(0), client.GetOutputDataObject(1)


def array_of(data, name):
    return np.array(vtk_to_numpy(data.GetPointData().GetArray(name)))


def points_of(data):
    return np.array(vtk_to_numpy(data.GetPoints().GetData())).astype(float)


def expect_error(words, **options):
    proxy = simple.GeodesicSamples(**options)
    messages = testing.messages_of(proxy.UpdatePipeline)
    assert words in messages, (words, messages)
    assert [data.GetNumberOfPoints() for data in outputs_of(proxy)] == [0, 0]
    assert words in testing.informed(proxy, "ErrorText")


# On a plane distances are straight: each sample is the point that is farthest from those before it.
plane = simple.Plane(XResolution=31, YResolution=23)
proxy = simple.GeodesicSamples(Input=plane, NumberOfSamples=40)
samples, regions = outputs_of(proxy)
assert samples.GetNumberOfPoints() == samples.GetNumberOfVerts() == 40
places, grid = points_of(samples), points_of(regions)
ids, radii = array_of(samples, "OriginalPointIds"), array_of(samples, "GeodesicDistance")
assert np.abs(grid[ids] - places).max() < 1e-6
assert radii[0] == -1 and ids[0] == 0
for i in range(1, 40):
    farthest = np.linalg.norm(grid[:, None] - places[None, :i], axis=2).min(axis=1)
    assert abs(farthest[ids[i]] - radii[i]) < 1e-6 and abs(farthest.max() - radii[i]) < 1e-6, i
everywhere = np.linalg.norm(grid[:, None] - places[None], axis=2)
assert np.abs(array_of(regions, "GeodesicDistance") - everywhere.min(axis=1)).max() < 1e-6
nearest = array_of(regions, "NearestSeed")
assert np.abs(everywhere[np.arange(len(grid)), nearest] - everywhere.min(axis=1)).max() < 1e-6
assert testing.informed(proxy, "SamplesTaken") == 40
assert abs(testing.informed(proxy, "CoveringRadius") - everywhere.min(axis=1).max()) < 1e-6
assert testing.informed(proxy, "NumberOfUnreachedPoints") == 0

# The number of threads changes nothing.
sphere = simple.Sphere(ThetaResolution=80, PhiResolution=60)
of_threads = [outputs_of(simple.GeodesicSamples(Input=sphere, NumberOfSamples=300, NumberOfThreads=threads))
              for threads in (1, 2, 0, -1)]
for samples_of, regions_of in of_threads[1:]:
    np.testing.assert_array_equal(array_of(samples_of, "OriginalPointIds"), array_of(of_threads[0][0], "OriginalPointIds"))
    for name in ("GeodesicDistance", "NearestSeed"):
        np.testing.assert_array_equal(array_of(regions_of, name), array_of(of_threads[0][1], name))

# The first positions stay first; equal ones count once, and those at points of the input have ids.
first = [0.013, 0.02, 0, -0.5, -0.5, 0, 0.013, 0.02, 0]
samples, _ = outputs_of(simple.GeodesicSamples(Input=plane, NumberOfSamples=12, FirstPositions=first))
assert np.abs(points_of(samples)[:2] - [[0.013, 0.02, 0], [-0.5, -0.5, 0]]).max() < 1e-6
assert array_of(samples, "OriginalPointIds")[:2].tolist() == [-1, 0]
assert array_of(samples, "GeodesicDistance")[:3].tolist()[:2] == [-1, -1] and samples.GetNumberOfPoints() == 12

# A spacing takes as many as it needs: of the Bunny, of its edges' size, and larger than the surface.
bunny = testing.bunny()
spaced = simple.GeodesicSamples(Input=bunny, Spacing=0.02)
samples, regions = outputs_of(spaced)
count = samples.GetNumberOfPoints()
assert 50 < count < 500 and array_of(samples, "GeodesicDistance")[1:].min() > 0.02
assert array_of(regions, "GeodesicDistance").max() <= 0.02 and testing.informed(spaced, "CoveringRadius") <= 0.02
assert outputs_of(simple.GeodesicSamples(Input=bunny, Spacing=10))[0].GetNumberOfPoints() == 1
assert outputs_of(simple.GeodesicSamples(Input=plane, Spacing=1e-6))[0].GetNumberOfPoints() == 32 * 24

# More where it is dear: the right half costs five times as much.
cost = simple.Calculator(Input=plane, Function="1 + 4 * (coordsX > 0)", ResultArrayName="cost")
samples, _ = outputs_of(simple.GeodesicSamples(Input=cost, NumberOfSamples=60, CostArray=["POINTS", "cost"]))
right = (points_of(samples)[:, 0] > 0).sum()
assert right > 40, right

# No sample lies on a barrier, and what it closes in is a part with a sample of its own.
ring = testing.polyline([[0.1, -0.1, 0], [0.3, -0.1, 0], [0.3, 0.1, 0], [0.1, 0.1, 0]], closed=True)
samples, regions = outputs_of(simple.GeodesicSamples(Input=plane, NumberOfSamples=2, BarrierSource=ring))
places = points_of(samples)
assert array_of(samples, "GeodesicDistance").tolist() == [-1, -1]
assert (np.abs(places[1] - [0.2, 0, 0]) < 0.1).all(), places
walls = simple.Calculator(Input=plane, Function="abs(coordsX) < 0.02", ResultArrayName="wall")
halves = simple.GeodesicSamples(Input=walls, NumberOfSamples=1, BarrierArray=["POINTS", "wall"])
_, regions = outputs_of(halves)
unreached = testing.informed(halves, "NumberOfUnreachedPoints")
assert unreached == ((grid[:, 0] >= 0.02)).sum() > 0, unreached
assert (array_of(regions, "NearestSeed") == -1).any()

# Blocks are one surface, unless told otherwise.
group = simple.GroupDatasets(Input=[simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0], XResolution=5),
                                    simple.Plane(Origin=[1, 0, 0], Point1=[2, 0, 0], Point2=[1, 1, 0], XResolution=5)])
samples, regions = outputs_of(simple.GeodesicSamples(Input=group, NumberOfSamples=2))
assert array_of(samples, "GeodesicDistance")[0] == -1 < array_of(samples, "GeodesicDistance")[1]
assert samples.GetPointData().HasArray("OriginalBlocks") and regions.GetNumberOfBlocks() == 2
samples, _ = outputs_of(simple.GeodesicSamples(Input=group, NumberOfSamples=2, ConnectBlocks=0))
assert array_of(samples, "GeodesicDistance").tolist() == [-1, -1]

# Points without cells are no samples.
loose = simple.AppendGeometry(Input=[plane, simple.PointSource(NumberOfPoints=5, Center=[9, 9, 9])])
samples, _ = outputs_of(simple.GeodesicSamples(Input=loose, NumberOfSamples=30))
assert points_of(samples).max() < 1

# All points, and no more.
small = simple.Plane(XResolution=3, YResolution=2)
assert outputs_of(simple.GeodesicSamples(Input=small, NumberOfSamples=12))[0].GetNumberOfPoints() == 12
expect_error("only 12 points", Input=small, NumberOfSamples=13)
expect_error("NumberOfSamples is 0", Input=small, NumberOfSamples=0)
expect_error("NumberOfSamples is -3", Input=small, NumberOfSamples=-3)
expect_error("Spacing is -1", Input=small, Spacing=-1)
expect_error("NumberOfThreads is -2; give -1", Input=small, NumberOfThreads=-2)
expect_error("fewer than the 2 first points", Input=small, NumberOfSamples=1, FirstPositions=[0, 0, 0, 0.1, 0.1, 0])
expect_error("multiple of 3", Input=small, FirstPositions=[0, 0])
expect_error("no surface", Input=simple.PointSource())
expect_error("First position 0 lies on a line of BarrierSource", Input=plane, FirstPositions=[0.1, 0, 0],
             BarrierSource=ring)
expect_error("can't work with costs", Input=cost, CostArray=["POINTS", "cost"], Method="Exact")

# After an error the next run has all.
broken = simple.GeodesicSamples(Input=small, NumberOfSamples=0)
testing.messages_of(broken.UpdatePipeline)
broken.NumberOfSamples = 5
assert outputs_of(broken)[0].GetNumberOfPoints() == 5
