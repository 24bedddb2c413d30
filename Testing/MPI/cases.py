# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is computed on several ranks and on one, and how the two are compared."""

import os

import numpy as np
from paraview import simple

import harness
import pieces


def points_on(name, count, on_vertices=False):
    """Seeds on a surface: of its points, or near the middle of edges and faces."""
    points, cells = pieces.SURFACES[name]()
    random = np.random.default_rng(3)
    if on_vertices:
        return points[random.integers(len(points), size=count)].ravel().tolist()
    corners = cells[random.integers(len(cells), size=count)]
    weights = random.uniform(size=(count, 3))
    weights[::3, 0] = 0  # on edges
    weights /= weights.sum(axis=1)[:, None]
    return np.einsum("ij,ijk->ik", weights, points[corners].astype(float)).ravel().tolist()


# What is computed, by the name of the case: surface and properties.
FIELDS = {
    "bunny": ("bunny", dict(SeedPositions=points_on("bunny", 1, True))),
    "sphere": ("sphere", dict(SeedPositions=points_on("sphere", 1))),
    "torus": ("torus", dict(SeedPositions=points_on("torus", 1))),
    "thin": ("thin", dict(SeedPositions=[0.02, 0.001, 0])),
    "flat": ("flat", dict(SeedPositions=points_on("flat", 4), ComputeNearestSeed=1)),
    "flat near": ("flat", dict(SeedPositions=points_on("flat", 1), UseMaximumDistance=1, MaximumDistance=0.3)),
    "flat wall": ("flat", dict(SeedPositions=[1.4, 0, 0], BarrierArray=["POINTS", "Wall"])),
    "edge": ("edge", dict(SeedPositions=[0.3, 0.2, 0])),
    "corner": ("corner", dict(SeedPositions=[0.3, 0.2, 0])),
    "triangle": ("triangle", dict(SeedPositions=[0.3, 0.2, 0])),
    "dijkstra": ("bunny", dict(SeedPositions=points_on("bunny", 7), Method="Dijkstra", ComputeNearestSeed=1)),
    "seeds": ("bunny", dict(SeedPositions=points_on("bunny", 60), ComputeNearestSeed=1)),
    "everywhere": ("sphere", dict(SeedPositions=pieces.SURFACES["sphere"]()[0].ravel().tolist(), ComputeNearestSeed=1)),
    "spheres seeds": ("sphere", dict(SeedPositions=points_on("sphere", 30), ComputeNearestSeed=1)),
    "groups": ("large", dict(SeedPositions=points_on("large", 150), ComputeNearestSeed=1)),
    "cost": ("bunny", dict(SeedPositions=points_on("bunny", 1), CostArray=["POINTS", "Cost"])),
    "costs": ("torus", dict(SeedPositions=points_on("torus", 9), CostArray=["POINTS", "Cost"], ComputeNearestSeed=1)),
    "spread cost": ("torus", dict(SeedPositions=points_on("torus", 1), CostArray=["POINTS", "SpreadCost"])),
    "spread costs": ("torus", dict(SeedPositions=points_on("torus", 60), CostArray=["POINTS", "SpreadCost"])),
    "speed": ("torus", dict(SeedPositions=points_on("torus", 2), CostArray=["POINTS", "Cost"], CostMode="Speed",
                            Method="Dijkstra")),
    "wall": ("torus", dict(SeedPositions=[1.4, 0, 0], BarrierArray=["POINTS", "Wall"])),
    "closed": ("torus", dict(SeedPositions=[1.4, 0, 0], BarrierArray=["CELLS", "CellWall"])),
    "region": ("sphere", dict(SeedArray=["POINTS", "Region"], ComputeNearestSeed=1)),
    "cells": ("torus", dict(SeedArray=["CELLS", "CellRegion"])),
    "maximum": ("bunny", dict(SeedPositions=points_on("bunny", 3), UseMaximumDistance=1, MaximumDistance=0.04)),
    # Seeds without a symmetry: else there are points just as far as a destination.
    "any": ("torus", dict(SeedPositions=[1.3, 0.2, 0.3], DestinationPositions=[0, 1.4, 0.0, -1.4, 0, 0])),
    "all": ("torus", dict(SeedPositions=[1.3, 0.2, 0.3], DestinationPositions=[0, 1.4, 0.0, 0.05, -1.45, 0.1],
                          DestinationMode="All")),
}
# What one rank solves that the surface is brought to.
for method, names in (("Exact", ("torus", "edge", "wall", "closed", "maximum", "all")), ("Bounded", ("wall", )),
                      ("VirtualSources", ("all", "closed"))):
    FIELDS.update({f"gathered {method} {name}": (FIELDS[name][0], dict(FIELDS[name][1], Method=method, GatherForExact=1))
                   for name in names})


def tolerance_of(case):
    """What Bounded merges depends on the order of the triangles, within what it promises."""
    return 1e-3 if "gathered Bounded" in case else 1e-9


def compare(case, parts, reference):
    """The largest difference, relative to the largest distance."""
    size = int(reference["PointNumber"].max()) + 1
    truth = harness.joined([reference], "GeodesicDistance", size)[0]
    least, most = harness.joined(parts, "GeodesicDistance", size)
    isReached = truth < 1e300
    assert np.array_equal(isReached, least < 1e300), (case, "reached", np.sum(isReached), np.sum(least < 1e300))
    # All distances may be 0.
    largest = truth[isReached].max() or 1.0
    error = max(np.abs(found[isReached] - truth[isReached]).max() / largest for found in (least, most))
    assert error <= tolerance_of(case), (case, "error", error)
    if "NearestSeed" in reference:
        seeds = harness.joined([reference], "NearestSeed", size)[0]
        others = np.logical_or(*(found != seeds for found in harness.joined(parts, "NearestSeed", size)))[isReached]
        assert not np.any(others), (case, "nearest seeds", np.sum(others))
    return error


def check(folder, case, source, options):
    """Computes a case on this cut; FIELD/CUT, one rank leaves what the others are compared with."""
    distance = simple.GeodesicDistance(Input=source, **options)
    parts = harness.run(distance, os.path.join(folder, f"{case}.{harness.RANKS}".replace("/", ".")))
    numbers = [harness.informed(distance, name) for name in (
        "NumberOfRounds", "NumberOfUpdates", "BytesExchanged", "MostPointsOnARank", "NumberOfVisitedPoints",
        "ThinTriangles")]
    reached = harness.informed(distance, "MaximumDistanceReached")
    simple.Delete(distance)
    if not harness.IS_FIRST:
        return
    path = os.path.join(folder, f"{case.split('/')[0]}.reference.npz")
    if harness.RANKS == 1:
        np.savez(path, numbers=numbers, reached=reached, **parts[0])
        return
    with np.load(path) as file:
        reference = dict(file)
    error = compare(case, parts, reference)
    assert numbers[4] == reference["numbers"][4], (case, "visited", numbers[4], reference["numbers"][4])
    assert numbers[5] == reference["numbers"][5], (case, "thin", numbers[5], reference["numbers"][5])
    assert abs(reached - reference["reached"]) <= tolerance_of(case) * reached, (case, reached, reference["reached"])
    largest = max(int(part["points"]) for part in parts)
    # What is round lines is on the first rank as well.
    whole = len(reference["PointNumber"])
    most = whole if case.startswith("lines") else 2 * whole if "spread" in case else largest
    # Where many triangles are thin, fast marching brings the surface to one rank by itself.
    if "gathered" in case or case.startswith(("thin", "flat")):
        # Points of several pieces are there for each of them. Of distances within a limit only what lies there is.
        most = (1.5 if case.endswith("maximum/slabs") else 1 + harness.RANKS) * whole
    assert largest <= numbers[3] <= most, (case, largest, numbers[3], most)
    if case.endswith("/slabs") and numbers[4] > 1000:
        # In the order of values ranks go ahead of each other.
        most = 4.0 if case.startswith("spread") else 1.5
        assert numbers[1] <= most * reference["numbers"][1], (case, "updates", numbers[1], reference["numbers"][1])
    if case == "spread cost/random":
        assert numbers[1] <= 30 * reference["numbers"][1], (case, "updates", numbers[1], reference["numbers"][1])
    print(f"{case:24s} error {error:7.1e}  rounds {numbers[0]:5d}  updates x{numbers[1] / max(reference['numbers'][1], 1):5.2f}"
          f"  bytes {numbers[2]:9d}  points {numbers[3]}", flush=True)
