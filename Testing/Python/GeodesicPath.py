# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""GeodesicPath: lengths, arrays, modes and mistakes; its closed path as a barrier.

usage: GeodesicPath.py OUR_PLUGIN
"""

import os
import sys
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.util.numpy_support import vtk_to_numpy

import testing

testing.load(sys.argv[1])


def total(path):
    testing.output_of(path)
    return testing.informed(path, "TotalLength")


def cell_array(path, name):
    return vtk_to_numpy(testing.output_of(path).GetCellData().GetArray(name))


def polylines(path):
    """Points of each segment."""
    data = testing.output_of(path)
    points = vtk_to_numpy(data.GetPoints().GetData())
    lines = data.GetLines()
    offsets = vtk_to_numpy(lines.GetOffsetsArray())
    ids = vtk_to_numpy(lines.GetConnectivityArray())
    return [points[ids[a:b]] for a, b in zip(offsets[:-1], offsets[1:])]


def length(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1).sum()


def message_of(path):
    """What the run says; the output is what it is."""
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    path.UpdatePipeline()
    vtkOutputWindow.SetInstance(None)
    return window.GetOutput()


def expect_near(value, truth, tolerance):
    assert np.all(np.abs(np.asarray(value) - truth) <= tolerance), (value, truth)


# A straight line on the plane, whichever way the triangles lie.
plane = simple.Plane(XResolution=37, YResolution=23)
path = simple.GeodesicPath(Input=plane, WaypointPositions=[-0.41, -0.33, 0, 0.47, 0.29, 0])
exact = np.hypot(0.88, 0.62)
expect_near(total(path), exact, 1e-7)
[line] = polylines(path)
expect_near(line[0], [-0.41, -0.33, 0], 1e-7)
expect_near(line[-1], [0.47, 0.29, 0], 1e-7)
assert np.allclose(testing.array_of(path, "ArcLength")[-1], total(path))
assert testing.output_of(path).GetFieldData().GetArray("TotalLength").GetValue(0) == total(path)

# Along edges: Manhattan, and Dijkstra's own distance.
path.InterpolationOrder = 0
path.Method = "Dijkstra"
distance = simple.GeodesicDistance(
    Input=plane, SeedPositions=[-0.41, -0.33, 0], Method="Dijkstra",
    DestinationPositions=[0.47, 0.29, 0], DestinationMode="All")
assert total(path) > exact * 1.01
ids = testing.array_of(path, "OriginalPointIds")
corners = testing.points_of(plane)[ids[1:-1]]
expect_near(polylines(path)[0][1:-1], corners, 1e-12)
path.InterpolationOrder = 1
path.Method = "FastMarching"

# Several waypoints, in order; closed; from a source.
square = [-0.3, -0.2, 0, 0.3, -0.2, 0, 0.3, 0.2, 0, -0.3, 0.2, 0]
path.WaypointPositions = square
expect_near(cell_array(path, "Length"), [0.6, 0.4, 0.6], 1e-7)
path.Closed = 1
expect_near(cell_array(path, "Length"), [0.6, 0.4, 0.6, 0.4], 1e-7)
expect_near(total(path), 2.0, 1e-7)
assert list(cell_array(path, "Segment")) == [0, 1, 2, 3]
expect_near(testing.array_of(path, "ArcLength")[-1], 2.0, 1e-7)
path.WaypointPositions = []
path.WaypointSource = testing.polyline(square)
expect_near(total(path), 2.0, 1e-6)
path.WaypointPositions = square
testing.expect_error(path, "WaypointPositions has 12 numbers", "WaypointSource", "Clear WaypointPositions, or set WaypointSource to None")
path.WaypointSource = None
expect_near(total(path), 2.0, 1e-7)

# Equal waypoints: a segment of length 0, the others intact.
path.Closed = 0
path.WaypointPositions = square[:3] + square[:3] + square[3:6]
expect_near(cell_array(path, "Length"), [0, 0.6], 1e-7)

# Where it ends, and how high it is.
path.WaypointPositions = square[:6]
path.UseMaximumPathLength = 1
path.MaximumPathLength = 0.25
expect_near(total(path), 0.25, 1e-9)
path.MaximumPathLength = -1
testing.expect_error(path, "MaximumPathLength is -1", "at least 0")
path.UseMaximumPathLength = 0
path.HeightOffset = 0.125
expect_near(polylines(path)[0][:, 2], 0.125, 1e-9)
expect_near(total(path), 0.6, 1e-7)
expect_near(vtk_to_numpy(testing.output_of(path).GetPointData().GetArray("Normals")), [0, 0, 1], 1e-9)
path.HeightOffset = 0

# Too few waypoints, an array that is not there.
path.WaypointPositions = square[:3]
testing.expect_error(path, "at least two waypoints", "is 1.")
path.WaypointPositions = [0, 0]
testing.expect_error(path, "2 numbers, which is not a multiple of 3")
path.WaypointPositions = square[:6]
path.CostArray = ["POINTS", "missing"]
testing.expect_error(path, 'CostArray "missing"')
path.CostArray = ["POINTS", "None"]
expect_near(total(path), 0.6, 1e-7)

# A wall with a gap: round its end, in two straight lines. No way at all is an error that names both.
wall = testing.polyline([[0.013, -0.5, 0], [0.013, 0.25, 0]])
path.BarrierSource = wall
end = np.array([0.013, 0.25])
exact = np.linalg.norm(end - [-0.3, -0.2]) + np.linalg.norm(end - [0.3, -0.2])
expect_near(total(path), exact, 1e-6)
wall.Points = [0.013, -0.5, 0, 0.013, 0.5, 0]
path.WaypointPositions = square
message = message_of(path)
assert "from waypoint 0 to waypoint 1, or from waypoint 2 to waypoint 3" in message, message
assert list(cell_array(path, "Segment")) == [1]
expect_near(total(path), 0.4, 1e-7)
path.WaypointPositions = [0.013, 0.1, 0, 0.3, 0.2, 0]
testing.expect_error(path, "Waypoint 0 lies on a line of BarrierSource")
path.BarrierSource = None

# From many starts to the nearest waypoint.
path.PathMode = "ToNearestSeed"
path.WaypointPositions = [-0.4, 0, 0, 0.4, 0, 0]
testing.expect_error(path, "2 waypoints and 0 starts")
path.StartPositions = [-0.2, 0.3, 0, 0.1, 0.1, 0, 0.4, 0, 0, -0.4, -0.41, 0]
expect_near(cell_array(path, "Length"),
            [np.hypot(0.2, 0.3), np.hypot(0.3, 0.1), 0, 0.41], 1e-6)
assert list(cell_array(path, "NearestSeed")) == [0, 1, 1, 0]
for line, start in zip(polylines(path), np.reshape(path.StartPositions, (-1, 3))):
    expect_near(line[0], start, 1e-7)
path.StartPositions = []
path.StartSource = testing.polyline([[-0.2, 0.3, 0], [0.1, 0.1, 0]])
expect_near(total(path), np.hypot(0.2, 0.3) + np.hypot(0.3, 0.1), 1e-6)

# Bunny: no longer than along edges, and round a closed path nothing passes, from either side.
bunny = testing.bunny()
points = testing.points_of(bunny)
size = np.ptp(points, axis=0).max()
way = simple.GeodesicPath(Input=bunny, WaypointPositions=points[[100, 20000, 33000, 9000]].ravel().tolist())
across = cell_array(way, "Length")
way.InterpolationOrder, way.Method = 0, "Dijkstra"
along = cell_array(way, "Length")
assert np.all(across < along) and np.all(across > 0.8 * along), (across, along)
way.InterpolationOrder, way.Method = 1, "FastMarching"

head = points[points[:, 1].argmax()]
for method, order in (("FastMarching", 1), ("FastMarching", 0), ("Dijkstra", 1), ("Dijkstra", 0)):
    # A loop round the neck, from four points at the height of the chin.
    height = points[:, 1].max() - 0.45 * np.ptp(points[:, 1])
    middle = points[np.abs(points[:, 1] - height) < 0.02 * size].mean(axis=0)
    corners = [middle + size * np.array(d) for d in ((-1, 0, 0), (0, 0, 1), (1, 0, 0), (0, 0, -1))]
    loop = simple.GeodesicPath(Input=bunny, WaypointPositions=np.ravel(corners).tolist(), Closed=1,
                               Method=method, InterpolationOrder=order)
    assert total(loop) > 0
    inside = simple.GeodesicDistance(Input=bunny, SeedPositions=list(head), BarrierSource=loop)
    confined = ~np.isnan(testing.array_of(inside))
    outside = simple.GeodesicDistance(
        Input=bunny, SeedPositions=list(points[points[:, 1].argmin()]), BarrierSource=loop)
    rest = ~np.isnan(testing.array_of(outside))
    used = np.zeros(len(points), bool)
    used[np.unique(testing.cells_of(bunny))] = True
    on_loop = np.zeros(len(points), bool)
    edge = vtk_to_numpy(testing.output_of(loop).GetPointData().GetArray("EdgePointIds"))
    on_loop[edge[edge[:, 0] == edge[:, 1]].ravel()] = True
    assert 500 < confined.sum() < 0.8 * len(points), confined.sum()
    assert not np.any(confined & rest), (method, order, np.sum(confined & rest))
    left_out = used & ~confined & ~rest & ~on_loop
    assert not np.any(left_out), (method, order, left_out.sum())
    # Along edges nothing passes either; but what has no edge but across the loop is not reached.
    inside.Method = outside.Method = "Dijkstra"
    along_inside, along_outside = (~np.isnan(testing.array_of(proxy)) for proxy in (inside, outside))
    assert not np.any(along_inside & ~confined) and not np.any(along_outside & ~rest)
    assert along_inside.sum() > 0.98 * confined.sum() and along_outside.sum() > 0.98 * rest.sum()
    for proxy in (inside, outside, loop):
        simple.Delete(proxy)

# With Exact all segments are the shortest of all; from starts to the nearest waypoint, too.
ends = np.ravel(points[[100, 7000, 15000, 30000]])
shortest = simple.GeodesicPath(Input=bunny, WaypointPositions=ends, Method="Exact", Closed=1)
fast = simple.GeodesicPath(Input=bunny, WaypointPositions=ends, Closed=1)
assert total(shortest) <= total(fast) * (1 + 1e-9)
assert testing.informed(shortest, "ProvenShortest") == 4
assert testing.informed(fast, "ProvenShortest") == 0
nearest = simple.GeodesicPath(Input=bunny, WaypointPositions=ends[:6], StartPositions=ends[6:],
                              PathMode="ToNearestSeed", Method="Exact")
field = simple.GeodesicDistance(Input=bunny, SeedPositions=ends[:6], Method="Exact")
expect_near([length(line) for line in polylines(nearest)], testing.array_of(field)[[15000, 30000]], 1e-9)
assert testing.informed(nearest, "ProvenShortest") == 2

# Segments are traced from both ends, and the shorter paths kept: no longer than those from one end, as in a drag, and
# the same in the other order. What was found in a drag is found anew after it, and what was found before it is kept.
chosen = points[np.random.default_rng(5).integers(len(points), size=60)]
there = simple.GeodesicPath(Input=bunny, WaypointPositions=np.ravel(chosen))


def set_dragged(proxy, is_dragged):
    proxy.SMProxy.GetProperty("Dragged").SetElement(0, is_dragged)
    proxy.SMProxy.UpdateVTKObjects()


set_dragged(there, 1)
from_one_end = cell_array(there, "Length")
set_dragged(there, 0)
from_both_ends = cell_array(there, "Length")
assert testing.informed(there, "NumberOfSearches") == 59
assert np.all(from_both_ends <= from_one_end * (1 + 1e-12)) and np.any(from_both_ends < from_one_end * (1 - 1e-6))
set_dragged(there, 1)
np.testing.assert_array_equal(cell_array(there, "Length"), from_both_ends)
assert testing.informed(there, "NumberOfSearches") == 0
back = simple.GeodesicPath(Input=bunny, WaypointPositions=np.ravel(chosen[::-1]))
expect_near(cell_array(back, "Length")[::-1], from_both_ends, 1e-8)
for proxy in (there, back):
    simple.Delete(proxy)
# Under costs, too: what counts is what a path costs. Where they jump, a trace can miss the best way from one end only.
priced = simple.Calculator(Input=bunny, ResultArrayName="price", Function="1 + 999 * (sin(900*coordsX) * sin(900*coordsY) > 0)")
there = simple.GeodesicPath(Input=priced, WaypointPositions=np.ravel(chosen), CostArray=["POINTS", "price"])
back = simple.GeodesicPath(Input=priced, WaypointPositions=np.ravel(chosen[::-1]), CostArray=["POINTS", "price"])
expect_near(cell_array(back, "Length")[::-1], cell_array(there, "Length"), 1e-6)
for proxy in (there, back, priced):
    simple.Delete(proxy)

# What Straighten, Interpolation Order and Path Mode do with the methods whose values have a promise.
least = cell_array(shortest, "Length")
edges = simple.GeodesicPath(Input=bunny, WaypointPositions=ends, Closed=1, Method="Dijkstra", InterpolationOrder=0)
along = cell_array(edges, "Length")
for method in ("Exact", "Bounded", "VirtualSources"):
    other = simple.GeodesicPath(Input=bunny, WaypointPositions=ends, Closed=1, Method=method)
    straight, proven = cell_array(other, "Length"), testing.informed(other, "ProvenShortest")
    other.Straighten = "Off"
    traced = cell_array(other, "Length")
    assert np.all(straight >= least * (1 - 1e-9)) and np.all(straight <= traced * (1 + 1e-12)), (method, straight, traced)
    beyond = {"Exact": 1e-9, "Bounded": 1e-3, "VirtualSources": 0.02}[method]
    assert np.all(traced < least * (1 + beyond)), (method, traced / least - 1)
    assert proven == (0 if method == "VirtualSources" else 4), (method, proven)
    # Along edges no path is shorter than that of Dijkstra, and none is proven to be the shortest of all. Distances of
    # Bounded, by which the path is searched for, are not a lower bound.
    other.InterpolationOrder = 0
    expect_near(cell_array(other, "Length"), along, 1e-3 if method == "Bounded" else 1e-9)
    assert testing.informed(other, "ProvenShortest") == 0
    to_nearest = simple.GeodesicPath(Input=bunny, WaypointPositions=ends[:6], StartPositions=ends[6:],
                                     PathMode="ToNearestSeed", Method=method)
    for straighten, order in (("Auto", 1), ("Off", 1), ("Auto", 0)):
        to_nearest.Straighten, to_nearest.InterpolationOrder = straighten, order
        assert list(cell_array(to_nearest, "NearestSeed")) == list(cell_array(nearest, "NearestSeed")), method
        beyond = cell_array(to_nearest, "Length") / cell_array(nearest, "Length") - 1
        assert np.all(beyond > -1e-9) and np.all(beyond < (0.02 if order else 0.2)), (method, straighten, order, beyond)
    simple.Delete(other)
    simple.Delete(to_nearest)
for proxy in (shortest, fast, nearest, field, edges):
    simple.Delete(proxy)

# Along edges from many starts: each is the shortest to its waypoint, as Dijkstra's distances from there tell.
chosen = points[np.unique(testing.cells_of(bunny))[::301]]
waypoints, chosen = chosen[::40], np.delete(chosen, np.s_[::40], axis=0)
many = simple.GeodesicPath(Input=bunny, PathMode="ToNearestSeed", WaypointPositions=waypoints.ravel().tolist(),
                           StartPositions=chosen.ravel().tolist(), InterpolationOrder=0)
alone = simple.GeodesicDistance(Input=bunny, Method="Dijkstra")
for number, waypoint in enumerate(waypoints):
    ends_here = cell_array(many, "NearestSeed") == number
    assert np.sum(ends_here) >= 8, np.sum(ends_here)
    alone.SeedPositions = waypoint.tolist()
    ids = [np.argmin(np.linalg.norm(points - start, axis=1)) for start in chosen[ends_here]]
    expect_near(cell_array(many, "Length")[ends_here], testing.array_of(alone)[ids], 1e-9 * size)
for proxy in (many, alone):
    simple.Delete(proxy)

# A state file brings all of it back.
before = total(way)
state = os.path.join(tempfile.mkdtemp(), "path.pvsm")
simple.SaveState(state)
simple.ResetSession()
testing.load(sys.argv[1])
simple.LoadState(state)
again = [p for (name, _), p in simple.GetSources().items() if p.SMProxy.GetXMLName() == "GeodesicPath"
         and p.Input.SMProxy.GetXMLName() == "XMLPolyDataReader"]
expect_near(total(again[0]), before, 1e-12 * before)

# Segments without a path: the message names the first few, and tells what of the rest is there.
here, there = [-0.3, 0, 0], [0.2, 0.1, 5]
parts = simple.AppendGeometry(Input=[simple.Plane(), simple.Plane(
    Origin=[-0.5, -0.5, 5], Point1=[0.5, -0.5, 5], Point2=[-0.5, 0.5, 5])])
alone = simple.GeodesicPath(Input=parts, WaypointPositions=here + there + [0.3, 0, 0])
testing.expect_error(
    alone, "from waypoint 0 to waypoint 1, or from waypoint 1 to waypoint 2. So there is no segment.")
alone.WaypointPositions = here + [0.3, 0, 0] + there
messages = testing.messages_of(alone.UpdatePipeline)
assert "from waypoint 1 to waypoint 2. The other 1 of 2 segments are in the output." in messages, messages
assert alone.GetDataInformation().GetNumberOfCells() == 1
starts = simple.GeodesicPath(
    Input=parts, PathMode="ToNearestSeed", WaypointPositions=here, StartPositions=there * 20 + [0.4, 0, 0])
messages = testing.messages_of(starts.UpdatePipeline)
assert "or from start 4 to any waypoint, nor for 15 segments more. The other 1 of 21" in messages, messages
