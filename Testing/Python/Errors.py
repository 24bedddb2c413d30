# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A script notices an error by an empty output; the message names value, limit and remedy.

usage: Errors.py OUR_PLUGIN
"""

import sys

import numpy as np
from paraview import servermanager, simple

import testing

testing.load(sys.argv[1])

sphere = simple.Sphere()
distance = simple.GeodesicDistance(Input=sphere, SeedPositions=[0, 0, 0.5])


def expect_error(*named):
    testing.expect_error(distance, *named)


def expect_well():
    assert not testing.is_empty(distance)
    assert testing.array_of(distance) is not None


expect_well()

distance.SeedPositions = []
expect_error("SeedPositions")
distance.SeedPositions = [0, 0]
expect_error("2 numbers, which is not a multiple of 3")
distance.SeedPositions = [0, 0, 1, 2]
expect_error("4 numbers, which is not a multiple of 3")
distance.SeedPositions = [0, 0, 0.5, 0, float("nan"), 0]
expect_error("Point 1 of SeedPositions")
distance.SeedPositions = [0, 0, 0.5]
expect_well()

distance.UseMaximumDistance = 1
distance.MaximumDistance = -1
expect_error("maximum distance is -1")
distance.UseMaximumDistance = 0
expect_well()

# Inputs without a surface.
distance.Input = simple.PointSource(NumberOfPoints=5)
expect_error("no surface")
distance.Input = simple.PolyLineSource()
expect_error("no surface")
distance.Input = simple.GroupDatasets(Input=[simple.PolyLineSource(), simple.PointSource()])
expect_error("no surface")
distance.Input = sphere
expect_well()

# What guides the front: each mistake is made and taken back. The plane has 5 x 5 points.
plane = simple.Triangulate(Input=simple.Plane(XResolution=4, YResolution=4))
points = testing.points_of(plane)
count = len(points)
ones = np.ones(count)


def ones_but(places, value):
    values = ones.copy()
    values[places] = value
    return values


surface = testing.with_arrays(
    plane,
    points={
        "zero": ones_but([9, 17], 0),
        "negative": ones_but([9, 17], -0.5),
        "tiny": ones_but([9, 17], -1e-12),
        "nan": ones_but([9, 17], np.nan),
        "infinite": ones_but([9, 17], np.inf),
        "pairs": np.ones((count, 2)),
        "none": 0 * ones,
        "all": ones,
        "middle": 1.0 * (np.arange(count) == 12),
    },
    cells={"cells": np.ones(32), "no cells": np.zeros(32), "cell pairs": np.ones((32, 2))})
through_seed = testing.polyline([(0, 0, 0), (0.25, 0, 0)])
across = testing.polyline([(-0.5, -0.4, 0), (0.5, 0.4, 0)])
crossing = testing.polyline([(-0.3, 0.2, 0), (0.3, -0.2, 0)])
apart = testing.polyline([(0, 0.1, 0), (0, 0, 5)])
no_number = testing.polyline([(0, 0, 0), (0, float("nan"), 0)])
nothing = servermanager.sources.IDSelectionSource(FieldType="POINT", IDs=[0, 25])

distance.Input = surface
distance.SeedPositions = [0, 0, 0]
POSITIVE = "must be positive and finite"
MISTAKES = [
    # Arrays that there are not, or not of the kind.
    (dict(CostArray=["POINTS", "lost"]), "CostArray", "lost", "not a point array", "or None"),
    (dict(SeedArray=["CELLS", "lost"]), "SeedArray", "lost", "not a cell array", "or None"),
    (dict(BarrierArray=["POINTS", "lost"]), "BarrierArray", "lost", "not a point array", "or None"),
    (dict(CostArray=["CELLS", "cells"]), "CostArray", "cells", "cell array", "Cell Data to Point Data"),
    (dict(CostArray=["POINTS", "pairs"]), "CostArray", "pairs", "2 components", "one component"),
    (dict(SeedArray=["POINTS", "pairs"]), "SeedArray", "pairs", "2 components", "array of one"),
    (dict(SeedArray=["CELLS", "cell pairs"]), "SeedArray", "cell pairs", "2 components", "array of one"),
    (dict(BarrierArray=["POINTS", "pairs"]), "BarrierArray", "pairs", "2 components", "array of one"),
    (dict(SeedArray=["POINTS", "none"]), "SeedArray", "none", "is 0 on the whole surface"),
    (dict(SeedArray=["CELLS", "no cells"]), "SeedArray", "no cells", "is 0 on the whole surface"),
    # Costs: the first point that has none.
    (dict(CostArray=["POINTS", "zero"]), "zero", "is 0 at point 9;", POSITIVE),
    (dict(CostArray=["POINTS", "negative"]), "negative", "is -0.5 at point 9;", POSITIVE),
    (dict(CostArray=["POINTS", "tiny"]), "tiny", "is -1e-12 at point 9;", POSITIVE),
    (dict(CostArray=["POINTS", "nan"]), "is nan at point 9;", POSITIVE),
    (dict(CostArray=["POINTS", "infinite"]), "is inf at point 9;", POSITIVE),
    (dict(CostArray=["POINTS", "zero"], CostMode="Speed"), "is 0 at point 9;", POSITIVE),
    # Seeds and destinations.
    (dict(SeedPointIds=[3, 25]), "Seed point id 25", "25 points", "numbered from 0"),
    (dict(SeedPointIds=[-1]), "Seed point id -1", "25 points"),
    (dict(DestinationPointIds=[25]), "Destination point id 25", "25 points", "numbered from 0"),
    (dict(DestinationPositions=[0, 0]), "DestinationPositions", "2 numbers", "multiple of 3"),
    (dict(DestinationPositions=[0, float("inf"), 0]), "Point 0 of DestinationPositions", "inf"),
    (dict(SeedSource=no_number), "Point 1 of SeedSource", "nan", "finite"),
    (dict(SeedSelection=nothing), "SeedSelection", "no point or cell of the surface", "Select others"),
    # Barriers.
    (dict(BarrierArray=["POINTS", "middle"]), "Seed 0", "point 12", "off the barrier"),
    (dict(BarrierArray=["CELLS", "cells"]), "Seed 0", "point 12", "off the barrier"),
    (dict(BarrierArray=["POINTS", "all"]), "Seed 0", "point 12", "off the barrier"),
    (dict(BarrierSource=through_seed), "Seed 0", "point 12", "off the barrier"),
    (dict(BarrierSource=across), "Seed 0", "on a line of BarrierSource", "off the line"),
    (dict(BarrierSource=across, SeedPositions=[0.1, 0.2, 0], SeedSource=crossing), "Seed 1",
     "on a line of BarrierSource"),
    # Stops.
    (dict(UseMaximumDistance=1, MaximumDistance=-1e-12), "maximum distance is -1e-12", "at least 0"),
    (dict(UseMaximumDistance=1, MaximumDistance=float("nan")), "maximum distance is nan", "at least 0"),
    # Tolerance.
    (dict(Tolerance=0), "Tolerance is 0", "above 0"),
    (dict(Tolerance=float("nan")), "Tolerance is nan", "above 0"),
    # Memory.
    (dict(MemoryLimit=-1), "MemoryLimit is -1", "give gigabytes from 0"),
    (dict(MemoryLimit=float("nan")), "MemoryLimit is nan", "give gigabytes from 0"),
    # Number of threads.
    (dict(NumberOfThreads=-2), "NumberOfThreads is -2", "a number from 1 to 1024"),
    (dict(NumberOfThreads=1025), "NumberOfThreads is 1025", "a number from 1 to 1024"),
    (dict(Method="Bounded", MemoryLimit=1e-9), "more than the memory limit of 1e-09 GB", "Raise the limit"),
    (dict(Method="Exact", MemoryLimit=1e-13), "more than the memory limit of 1e-09 GB", "Raise the limit"),
    (dict(Method="Exact", MemoryLimit=1e-9), "more than the memory limit of 1e-09 GB", "Raise the limit"),
]
RIGHT = dict(
    SeedPositions=[0, 0, 0], SeedPointIds=[], SeedSource=None, SeedArray=["POINTS", "None"], SeedSelection=None,
    Method="FastMarching", Tolerance=1e-3, MemoryLimit=0, NumberOfThreads=-1, UseMaximumDistance=0, DestinationPositions=[], DestinationPointIds=[],
    CostArray=["POINTS", "None"], CostMode="Cost", BarrierArray=["POINTS", "None"], BarrierSource=None)


def change(properties):
    for name, value in properties.items():
        distance.SetPropertyWithName(name, value)


for mistake, *named in MISTAKES:
    change(mistake)
    expect_error(*named)
    change(RIGHT)
    expect_well()

# A line between parts that do not hang together.
distance.Input = simple.AppendGeometry(Input=[plane, simple.Plane(
    Origin=[-0.5, -0.5, 5], Point1=[0.5, -0.5, 5], Point2=[-0.5, 0.5, 5])])
for source in ("SeedSource", "BarrierSource"):
    change({source: apart})
    expect_error(f"{source}'s line 0", "point 0 to its point 1", "no path over the surface")
    change(RIGHT)
    expect_well()
