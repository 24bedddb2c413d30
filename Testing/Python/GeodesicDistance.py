# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The proxy GeodesicDistance by the names of its properties, which are the scripting interface.

usage: GeodesicDistance.py OUR_PLUGIN
"""

import sys

import numpy as np
from paraview import simple

import testing

testing.load(sys.argv[1])

# The square [-0.5, 0.5]^2, where the truth is the straight line.
plane = simple.Plane(XResolution=20, YResolution=20)
points = testing.points_of(plane)


def truth(*seeds):
    return np.min([np.linalg.norm(points - seed, axis=1) for seed in seeds], axis=0)


def expect(distance, expected):
    found = testing.array_of(distance)
    np.testing.assert_allclose(found, expected, atol=1e-6)


# The defaults are the documented ones.
distance = simple.GeodesicDistance(Input=plane)
assert len(distance.SeedPositions) == 0
assert distance.Method == "FastMarching"
assert distance.UseMaximumDistance == 0
assert distance.DistanceArrayName == "GeodesicDistance"
assert distance.UnreachedAs == "NaN"
assert distance.UnreachedValue == -1
assert distance.MergeCoincidentPoints == 1

# One seed and two, anywhere on the faces or off them.
first, second = (0.113, -0.207, 0), (-0.31, 0.42, 0)
distance.SeedPositions = first
expect(distance, truth(first))
distance.SeedPositions = [*first[:2], 3.0, *second]
expect(distance, truth(first, second))
assert abs(testing.informed(distance, "MaximumDistanceReached") - truth(first, second).max()) < 1e-6
assert testing.informed(distance, "NumberOfVisitedPoints") == len(points)
assert testing.informed(distance, "ThinTriangles") == 0
assert testing.informed(distance, "NoticeText") == ""

# On thin triangles fast marching would be far off. It goes over others, or says so; the other methods are not.
needles = simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 0.01, 0], XResolution=20, YResolution=20)
priced = simple.Calculator(Input=needles, ResultArrayName="price", Function="1 + coordsX")
across = simple.Line(Point1=[0.2, 0, 0], Point2=[0.2, 0.01, 0])
for surface, source, remedy in ((needles, None, "FastMarching goes over others of the same surface instead."),
                                (needles, across, "Use the method Exact, Bounded or VirtualSources, or remesh"),
                                (priced, None, "Remesh")):
    thin = simple.GeodesicDistance(Input=surface)
    if source:
        thin.SeedSource = source
    else:
        thin.SeedPositions = first
    if surface is priced:
        thin.CostArray = ["POINTS", "price"]
    thin.UpdatePipeline()
    assert testing.informed(thin, "ThinTriangles") == 800, testing.informed(thin, "ThinTriangles")
    notice = testing.informed(thin, "NoticeText")
    assert notice.startswith("800 of 800 triangles are thin") and remedy in notice, notice
    if surface is needles:
        thin.Method = "Exact"
        thin.UpdatePipeline()
        assert testing.informed(thin, "ThinTriangles") == 0
        assert testing.informed(thin, "NoticeText") == ""

# Coloured at once.
assert testing.output_of(distance).GetPointData().GetScalars().GetName() == "GeodesicDistance"

# Bounded; what is beyond is NaN, or a value.
distance.SeedPositions = first
distance.UseMaximumDistance = 1
distance.MaximumDistance = 0.25
expect(distance, np.where(truth(first) <= 0.25, truth(first), np.nan))
distance.UnreachedAs = "Value"
distance.UnreachedValue = 7
expect(distance, np.where(truth(first) <= 0.25, truth(first), 7))
distance.UseMaximumDistance = 0

# Along edges: never shorter.
distance.Method = "Dijkstra"
assert (testing.array_of(distance) >= truth(first) - 1e-6).all()
assert testing.array_of(distance).max() > 1.05 * truth(first).max()
distance.Method = "FastMarching"

# The name of the array; none without one.
distance.DistanceArrayName = "d"
assert testing.array_of(distance, "d") is not None
assert testing.array_of(distance) is None
distance.DistanceArrayName = ""
assert testing.output_of(distance).GetPointData().GetNumberOfArrays() == 2
distance.DistanceArrayName = "GeodesicDistance"

# Two halves that share a border of equal coordinates are one surface, or two.
left = simple.Plane(Origin=[-1, 0, 0], Point1=[0, 0, 0], Point2=[-1, 1, 0], XResolution=9, YResolution=9)
right = simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0], XResolution=9, YResolution=9)
halves = simple.AppendGeometry(Input=[left, right])
points = testing.points_of(halves)
across = simple.GeodesicDistance(Input=halves, SeedPositions=[-0.5, 0.5, 0])
expect(across, truth((-0.5, 0.5, 0)))
across.MergeCoincidentPoints = 0
assert np.isnan(testing.array_of(across)).sum() == 100

# An input array of the same name is replaced in the output only.
named = simple.Calculator(Input=plane, ResultArrayName="GeodesicDistance", Function="coordsX + 100")
before = testing.array_of(named).copy()
points = testing.points_of(plane)
over = simple.GeodesicDistance(Input=named, SeedPositions=first)
expect(over, truth(first))
np.testing.assert_array_equal(testing.array_of(named), before)

# Coordinates follow the input: the same seeds on a moved surface are projected anew.
moved = simple.Transform(Input=plane)
moved.Transform.Translate = [0, 0, 5]
expect(simple.GeodesicDistance(Input=moved, SeedPositions=first), truth(first))
