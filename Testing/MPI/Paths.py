# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Paths on several ranks are those on one rank, however the surface is cut.

usage: mpiexec -n N pvbatch [--sym] Paths.py OUR_PLUGIN FOLDER
The run with one rank leaves the paths in FOLDER that the others are compared with.
"""

import os
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.append(os.path.dirname(__file__))
import cases
import harness
import pieces

PLUGIN, FOLDER = sys.argv[1:]
os.makedirs(FOLDER, exist_ok=True)
harness.load(PLUGIN)
can_redistribute = harness.can_redistribute()


def between(surface, count, **options):
    return surface, dict(WaypointPositions=cases.points_on(surface, count), **options)


def along(surface, count, apart=0, **options):
    """Through many points, from each to the nearest of the others; none nearer to x = 0 than some length."""
    left = np.reshape(cases.points_on(surface, count), (-1, 3))
    left = left[np.abs(left[:, 0]) >= apart]
    chain = [left[0]]
    for _ in range(len(left) - 1):
        left = left[np.any(left != chain[-1], axis=1)]
        chain.append(left[np.argmin(np.linalg.norm(left - chain[-1], axis=1))])
    return surface, dict(WaypointPositions=np.ravel(chain).tolist(), **options)


# What is gathered round a path of so many edges.
POINTS_OF_EDGE = 40
ON_TORUS = [1.3, 0.2, 0.3, -1.35, 0.1, 0.1]
# Across the way from one to the other.
LINE = dict(BarrierSource=simple.PolyLineSource(Points=[0.03, 0.75, -0.3, 0.02, 0.61, 0, 0.03, 1, 0.4]))
# What is sought, by the name of the case: surface and properties.
PATHS = {
    "bunny": between("bunny", 2),
    "waypoints": between("bunny", 6, Closed=1),
    "traced": between("bunny", 2, Straighten="Off"),
    "edges": between("bunny", 2, InterpolationOrder=0),
    "dijkstra": between("bunny", 3, Method="Dijkstra"),
    "dijkstra edges": between("bunny", 3, Method="Dijkstra", InterpolationOrder=0),
    "sphere": between("sphere", 4),
    "torus": ("torus", dict(WaypointPositions=ON_TORUS)),
    "thin": ("thin", dict(WaypointPositions=[0.02, 0.001, 0, 0.97, 0.0178, 0])),
    "cost": ("torus", dict(WaypointPositions=ON_TORUS, CostArray=["POINTS", "Cost"])),
    "edge": ("edge", dict(WaypointPositions=[0.3, 0.2, 0, 6.2, 13.4, 0])),
    "corner": ("corner", dict(WaypointPositions=[0.3, 0.2, 0, 13.2, 13.4, 0])),
    "triangle": ("triangle", dict(WaypointPositions=[0.1, 0.1, 0, 0.5, 0.3, 0])),
    "wall": ("torus", dict(WaypointPositions=ON_TORUS, BarrierArray=["POINTS", "Wall"])),
    "closed": ("torus", dict(WaypointPositions=ON_TORUS, BarrierArray=["CELLS", "CellWall"])),
    "line": ("torus", dict(WaypointPositions=ON_TORUS, **LINE)),
    "line traced": ("torus", dict(WaypointPositions=ON_TORUS, Straighten="Off", **LINE)),
    "line cost": ("torus", dict(WaypointPositions=ON_TORUS, CostArray=["POINTS", "Cost"], **LINE)),
    "line edges": ("torus", dict(WaypointPositions=ON_TORUS, Method="Dijkstra", InterpolationOrder=0, **LINE)),
    "line on edges": ("edge", dict(WaypointPositions=[2.3, 1.2, 0, 3.2, 5.4, 0],
                                   BarrierSource=simple.PolyLineSource(Points=[1, 3, 0, 5, 3, 0]))),
    "line nearest": ("torus", dict(PathMode="ToNearestSeed", WaypointPositions=ON_TORUS[3:] + [-0.3, 1.1, 0.3],
                                   StartPositions=ON_TORUS[:3] + [0.3, 1.1, 0.35, 0.2, -1.3, 0.1], **LINE)),
    "start is end": ("torus", dict(WaypointPositions=ON_TORUS[:3] * 2)),
    "one vertex": ("torus", dict(WaypointPositions=[1.4, 0, 0] * 2)),
    "raised": ("torus", dict(WaypointPositions=ON_TORUS, HeightOffset=0.1)),
    "short": ("torus", dict(WaypointPositions=ON_TORUS, UseMaximumPathLength=1, MaximumPathLength=0.7)),
    "nearest": ("bunny", dict(PathMode="ToNearestSeed", WaypointPositions=cases.points_on("bunny", 9),
                              StartPositions=cases.points_on("bunny", 20)[27:])),
    "nearest along edges": ("bunny", dict(PathMode="ToNearestSeed", WaypointPositions=cases.points_on("bunny", 9),
                                          StartPositions=cases.points_on("bunny", 20)[27:], InterpolationOrder=0)),
    "many nearest": ("large", dict(PathMode="ToNearestSeed", WaypointPositions=cases.points_on("large", 40),
                                   StartPositions=cases.points_on("large", 500)[120:])),
    "many traced": ("large", dict(PathMode="ToNearestSeed", WaypointPositions=ON_TORUS, Straighten="Off",
                                  StartPositions=cases.points_on("large", 200))),
    "many along edges": ("bunny", dict(PathMode="ToNearestSeed", WaypointPositions=cases.points_on("bunny", 4),
                                       StartPositions=cases.points_on("bunny", 60)[12:], InterpolationOrder=0)),
    "many with cost": ("torus", dict(PathMode="ToNearestSeed", WaypointPositions=ON_TORUS, CostArray=["POINTS", "Cost"],
                                     StartPositions=cases.points_on("torus", 60))),
    "many round a line": ("torus", dict(PathMode="ToNearestSeed", WaypointPositions=ON_TORUS,
                                        StartPositions=cases.points_on("torus", 60), **LINE)),
    "chain": along("large", 300, Closed=1),
    "chain traced": along("bunny", 80, Straighten="Off"),
    "chain along edges": along("bunny", 60, InterpolationOrder=0),
    "chain of dijkstra": along("bunny", 60, Method="Dijkstra"),
    "chain with cost": along("torus", 80, CostArray=["POINTS", "Cost"]),
    "chain beside a wall": along("torus", 80, 0.15, BarrierArray=["CELLS", "CellWall"]),
    "chain no route": ("parts", dict(WaypointPositions=[0.3, 0.2, 0, 6.3, 5.2, 0, 0.3, 0.2, 5] + [2.3, 0.7, 5, 0.3, 0.2, 5] * 9)),
    "exact": between("bunny", 3, Method="Exact", GatherForExact=1),
    "exact traced": between("bunny", 2, Method="Exact", GatherForExact=1, Straighten="Off"),
    "exact along edges": between("bunny", 2, Method="Exact", GatherForExact=1, InterpolationOrder=0),
    "bounded": between("sphere", 3, Method="Bounded", GatherForExact=1),
    "exact wall": ("torus", dict(WaypointPositions=ON_TORUS, BarrierArray=["POINTS", "Wall"], Method="Exact", GatherForExact=1)),
    "exact closed": ("torus", dict(WaypointPositions=ON_TORUS, BarrierArray=["CELLS", "CellWall"], Method="Exact",
                                   GatherForExact=1)),
    "exact line": ("torus", dict(WaypointPositions=ON_TORUS, Method="Exact", GatherForExact=1, **LINE)),
    "exact nearest": ("bunny", dict(PathMode="ToNearestSeed", WaypointPositions=cases.points_on("bunny", 9),
                                    StartPositions=cases.points_on("bunny", 20)[27:], Method="Exact", GatherForExact=1)),
    "exact no route": ("parts", dict(WaypointPositions=[0.3, 0.2, 0, 6.3, 5.2, 0, 0.3, 0.2, 5, 2.3, 0.7, 5],
                                     Method="Exact", GatherForExact=1)),
    "no route": ("parts", dict(WaypointPositions=[0.3, 0.2, 0, 6.3, 5.2, 0, 0.3, 0.2, 5, 2.3, 0.7, 5])),
}


def found(source, options):
    """Arrays of the first rank's output, and what this rank reports."""
    path = simple.GeodesicPath(Input=source, **options)
    messages = harness.messages_of(path.UpdatePipeline)
    output = path.GetClientSideObject().GetOutputDataObject(0)
    assert harness.IS_FIRST or output.GetNumberOfPoints() == 0
    result = dict(messages=messages, total=harness.informed(path, "TotalLength"),
                  held=harness.informed(path, "MostPointsOnARank"))
    for attributes in (output.GetPointData(), output.GetCellData()):
        for i in range(attributes.GetNumberOfArrays()):
            result[attributes.GetArrayName(i)] = np.array(vtk_to_numpy(attributes.GetArray(i)))
    if output.GetNumberOfPoints():
        result["points"] = np.array(vtk_to_numpy(output.GetPoints().GetData()))
    simple.Delete(path)
    return result


def global_ids(surface):
    """By the point ids of the whole surface, as pieces.part makes both."""
    return 3 * np.unique(pieces.SURFACES[surface]()[1]) + 10


def check(name, cut, source, options):
    result = found(source, options)
    file = os.path.join(FOLDER, f"{name}.path.npz")
    assert ("No path over the surface leads from waypoint 1 to waypoint 2." in result["messages"]) == (
        name.endswith("no route")), (name, cut, result["messages"])
    if harness.RANKS == 1:
        np.savez(file, **result)
        if name == "line":
            assert result["total"] > 1.01 * float(np.load(os.path.join(FOLDER, "torus.path.npz"))["total"])
        return
    with np.load(file) as stored:
        reference = dict(stored)
    total = float(reference["total"])
    # What Bounded merges depends on the order of the triangles, within what it promises.
    tolerance = 1e-3 if name == "bounded" else 1e-9
    assert abs(result["total"] - total) <= tolerance * total, (name, cut, result["total"], total)
    if harness.IS_FIRST and name != "bounded":
        compare(name, cut, result, reference, PATHS[name][0])


def compare(name, cut, result, reference, surface):
    """What the first rank has of a case with what one rank has."""
    for array in ("Segment", "NearestSeed"):
        assert (array in reference) == (array in result), (name, cut, array)
        assert array not in result or np.array_equal(reference[array], result[array]), (name, cut, array)
    size = np.ptp(reference["points"], axis=0).max() or 1
    error = np.abs(reference["Length"] - result["Length"]).max() / (reference["total"] or 1)
    assert error <= 1e-9, (name, cut, "length", error)
    assert len(reference["points"]) == len(result["points"]), (name, cut, "points", len(result["points"]))
    aside = np.abs(reference["points"] - result["points"]).max() / size
    # Where the path ends a step short of a point, rounding decides on which side.
    assert aside <= 1e-7, (name, cut, "aside", aside)
    turned = np.abs(reference["Normals"] - result["Normals"]).max()
    assert turned <= 1e-6, (name, cut, "normals", turned)
    for array in ("OriginalPointIds", "EdgePointIds"):
        ids = result[array]
        expected = global_ids(surface)[reference[array]] if "ids" in cut else -1
        # Both ends of an edge are as near to its middle.
        assert np.mean(ids != expected) < 0.02, (name, cut, array, ids, expected)
    print(f"{name:15s} {cut:18s} length {error:7.1e}  aside {aside:7.1e}  normals {turned:7.1e}"
          f"  points {len(result['points']):4d}  held {result['held']}", flush=True)


for name, (surface, options) in harness.some(PATHS).items():
    if harness.RANKS == 1:
        check(name, "whole", harness.surface(surface, "whole"), options)
        continue
    check(name, "slabs", harness.surface(surface, "slabs"), options)
    if surface != "bunny" or name in ("bunny", "nearest"):
        check(name, "random", harness.surface(surface, "random"), options)
    if name in ("bunny", "cost", "closed", "line"):
        check(name, "in boxes", harness.surface(surface, "boxes"), options)
        if can_redistribute:
            check(name, "redistributed", harness.redistributed(surface), options)
        check(name, "ghosts and ids", harness.ghosted(harness.surface(surface, "slabs", True)), options)
        check(name, "random, ghosts, ids", harness.ghosted(harness.surface(surface, "random", True)), options)
        check(name, "ids only", harness.surface(surface, "random", True), dict(options, MergeCoincidentPoints=0))
        check(name, "all on the last", harness.surface(surface, "last"), options)
        check(name, "blocks", harness.in_blocks(surface), options)
        check(name, "multiblock", harness.in_multiblock(surface), options)

if harness.RANKS > 1:
    # The first rank holds its piece and what lies round the path, not the surface.
    count = len(pieces.SURFACES["bunny"]()[0])
    short = found(harness.surface("bunny", "slabs"), dict(PATHS["bunny"][1]))
    assert count / harness.RANKS <= short["held"] < count / harness.RANKS + 0.15 * count, (short["held"], count)

    # So with very many starts: no more than its piece again, and what lies round each of them.
    many = found(harness.surface("large", "slabs"), dict(PATHS["many nearest"][1]))
    points, cells = pieces.SURFACES["large"]()
    owner = pieces.owners(points, cells, "slabs", harness.RANKS)
    piece = np.max([len(np.unique(cells[owner == rank])) for rank in range(harness.RANKS)])
    if harness.IS_FIRST:
        print(f"many nearest: {many['held'] - piece} points beside a piece of {piece}", flush=True)
    assert many["held"] <= 2 * piece + 20 * 500, (many["held"], piece)

    # So along edges, where the way can lie anywhere in a wide strip, and beside a barrier round the whole surface: so
    # many points for each edge of the way, on a mesh of 480 x 240 points; the barrier's 700 edges have few points each.
    whole_round = simple.PolyLineSource(Points=[1.4, 0.01, 0, -0.7, 1.21, 0, -0.7, -1.21, 0], Closed=1)
    for name, edges, options in (
            ("straight", 240, {}),
            ("along edges", 240, dict(InterpolationOrder=0)),
            ("nearest along edges", 150, dict(InterpolationOrder=0, PathMode="ToNearestSeed",
                                              StartPositions=ON_TORUS[:3], WaypointPositions=ON_TORUS[3:] + [0, -1.3, 0.2])),
            ("beside a barrier", 350, dict(BarrierSource=whole_round)),
            ("along edges beside a barrier", 350, dict(BarrierSource=whole_round, InterpolationOrder=0))):
        way = found(harness.surface("large", "slabs"), dict(dict(WaypointPositions=ON_TORUS), **options))
        if harness.IS_FIRST:
            print(f"{name}: {way['held'] - piece} points beside a piece of {piece}", flush=True)
        assert piece <= way["held"] <= piece + POINTS_OF_EDGE * edges, (name, way["held"], piece)
