# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""GeodesicDistanceMatrix: lengths, sets, barriers, CSV files and mistakes.

usage: GeodesicDistanceMatrix.py OUR_PLUGIN
"""

import csv
import os
import sys
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import testing

testing.load(sys.argv[1])


def matrix_of(proxy):
    table = testing.output_of(proxy)
    assert table.GetColumnName(0) == "From"
    count = table.GetNumberOfColumns() - 1
    assert [table.GetColumnName(i + 1) for i in range(count)] == [f"To {i}" for i in range(count)]
    return np.array([vtk_to_numpy(table.GetColumn(i + 1)) for i in range(count)]).T


def expect_error(words, **options):
    proxy = simple.GeodesicDistanceMatrix(**options)
    messages = testing.messages_of(proxy.UpdatePipeline)
    assert words in messages, (words, messages)
    assert testing.output_of(proxy).GetNumberOfColumns() == 0
    assert words in testing.informed(proxy, "ErrorText")


def path_length(source, start, end, **options):
    path = simple.GeodesicPath(Input=source, WaypointPositions=[*start, *end], **options)
    path.UpdatePipeline()
    return testing.informed(path, "TotalLength")


# On a plane distances are straight, and the table is what a formula gives.
plane = simple.Plane(XResolution=37, YResolution=23)
random = np.random.default_rng(7)
landmarks = np.column_stack([random.uniform(-0.5, 0.5, (25, 2)), np.zeros(25)])
matrix = simple.GeodesicDistanceMatrix(Input=plane, LandmarkPositions=landmarks.ravel().tolist())
truth = np.linalg.norm(landmarks[:, None] - landmarks[None], axis=2)
found = matrix_of(matrix)
assert np.abs(found - truth).max() < 1e-6, np.abs(found - truth).max()
assert np.array_equal(found, found.T) and not found.diagonal().any()
assert testing.informed(matrix, "NumberOfUnjoinedPairs") == 0

# A CSV file has the same table.
with tempfile.TemporaryDirectory() as folder:
    file = os.path.join(folder, "matrix.csv")
    simple.SaveData(file, proxy=matrix, Precision=12)
    with open(file, encoding="utf-8") as lines:
        rows = list(csv.DictReader(lines))
assert len(rows) == 25
assert abs(float(rows[3]["To 19"]) - truth[3, 19]) < 1e-6

# From one set to another, and a source instead of positions.
second = simple.GeodesicDistanceMatrix(Input=plane, LandmarkPositions=landmarks[:4].ravel().tolist(),
                                       SecondLandmarkSource=testing.polyline(landmarks[4:]))
assert np.abs(matrix_of(second) - truth[:4, 4:]).max() < 1e-6

# On the Bunny, the length of each pair is that of Geodesic Path, within the differences that rounding and the
# direction of a path make; with Exact it is the same to 1e-9.
bunny = testing.bunny()
points = testing.points_of(bunny)[[10, 9000, 17000, 26000]].astype(float)
for method, tolerance in (("FastMarching", 1e-2), ("VirtualSources", 1e-2), ("Exact", 1e-9)):
    found = matrix_of(simple.GeodesicDistanceMatrix(Input=bunny, LandmarkPositions=points.ravel().tolist(), Method=method))
    for i in range(4):
        for j in range(i):
            length = path_length(bunny, points[i], points[j], Method=method)
            assert abs(found[i, j] - length) <= tolerance * length, (method, i, j, found[i, j], length)

# A barrier across the plane leaves a gap at its end; one round a landmark leaves no path.
ends = [-0.2, 0, 0, 0.2, 0, 0]
wall = testing.polyline([[0, -1, 0], [0, 0.2, 0]])
found = matrix_of(simple.GeodesicDistanceMatrix(Input=plane, LandmarkPositions=ends, BarrierSource=wall))
assert abs(found[0, 1] - 2 * np.hypot(0.2, 0.2)) < 0.02, found
ring = testing.polyline([[0.1, -0.1, 0], [0.3, -0.1, 0], [0.3, 0.1, 0], [0.1, 0.1, 0]], closed=True)
closed = simple.GeodesicDistanceMatrix(Input=plane, LandmarkPositions=ends, BarrierSource=ring)
assert np.array_equal(np.isnan(matrix_of(closed)), ~np.eye(2, dtype=bool))
assert testing.informed(closed, "NumberOfUnjoinedPairs") == 1

# Coincident points are one, unless told otherwise: two halves of a plane with points of their own.
halves = simple.AppendGeometry(Input=[simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0]),
                                      simple.Plane(Origin=[1, 0, 0], Point1=[2, 0, 0], Point2=[1, 1, 0])])
across = dict(Input=simple.AppendDatasets(Input=halves), LandmarkPositions=[0.5, 0.5, 0, 1.5, 0.5, 0])
assert abs(matrix_of(simple.GeodesicDistanceMatrix(**across))[0, 1] - 1) < 1e-6
assert np.isnan(matrix_of(simple.GeodesicDistanceMatrix(MergeCoincidentPoints=0, **across))[0, 1])
# So with blocks.
group = simple.GroupDatasets(Input=[simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0]),
                                    simple.Plane(Origin=[1, 0, 0], Point1=[2, 0, 0], Point2=[1, 1, 0])])
across["Input"] = group
assert abs(matrix_of(simple.GeodesicDistanceMatrix(**across))[0, 1] - 1) < 1e-6
assert np.isnan(matrix_of(simple.GeodesicDistanceMatrix(ConnectBlocks=0, **across))[0, 1])

# Threads share the landmarks; the lengths are the same to the bit.
many = dict(Input=simple.Sphere(ThetaResolution=60, PhiResolution=60),
            LandmarkPositions=np.random.default_rng(35).normal(size=36).tolist())
of_one = matrix_of(simple.GeodesicDistanceMatrix(NumberOfThreads=1, **many))
assert of_one.shape == (12, 12)
for threads in (-1, 0, 2, 3, 8):
    np.testing.assert_array_equal(matrix_of(simple.GeodesicDistanceMatrix(NumberOfThreads=threads, **many)), of_one)
expect_error("NumberOfThreads is -2; give -1", NumberOfThreads=-2, **many)

expect_error("There is no landmark", Input=plane)
expect_error("multiple of 3", Input=plane, LandmarkPositions=[0, 0])
expect_error("no surface", Input=simple.PointSource(), LandmarkPositions=ends)
expect_error("LandmarkSource is set as well", Input=plane, LandmarkPositions=ends, LandmarkSource=testing.polyline(landmarks))
expect_error("Landmark 1 lies on a line of BarrierSource", Input=plane, LandmarkPositions=[-0.3, 0, 0, 0, 0, 0],
             BarrierSource=wall)
# Far too many: said before the first march.
expect_error("A matrix of 25 by 25 landmarks needs 1e-05 gigabytes", Input=plane,
             LandmarkPositions=landmarks.ravel().tolist(), MemoryLimit=1e-6)

# After an error the next run has all.
broken = simple.GeodesicDistanceMatrix(Input=plane)
testing.messages_of(broken.UpdatePipeline)
broken.LandmarkPositions = ends
assert abs(matrix_of(broken)[0, 1] - 0.4) < 1e-6
