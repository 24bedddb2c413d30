# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Seeds and barriers that are lines: the fields on several ranks are those on one, however the surface is cut.

usage: mpiexec -n N pvbatch [--sym] Lines.py OUR_PLUGIN FOLDER
The run with one rank leaves the fields in FOLDER that the others are compared with.
"""

import os
import sys

import numpy as np
from paraview import simple

sys.path.append(os.path.dirname(__file__))
import cases
import harness
import pieces

PLUGIN, FOLDER = sys.argv[1:]
os.makedirs(FOLDER, exist_ok=True)
harness.load(PLUGIN)


def line(*points, closed=0):
    return simple.PolyLineSource(Points=list(points), Closed=closed)


POINTS_OF_EDGE = 4
SEED = [1.3, 0.2, 0.3]
ROUND = [1.1, 0.3, 0.38, 0.2, 1.2, 0.3, -1.15, 0.25, -0.35]
# Across the tube, so that the front has to go round the torus.
RING = [0.03 + 1.4 * 0.7, 1.4 * 0.7, 0, 0.7, 0.72, 0.4, 0.42, 0.43, 0, 0.7, 0.72, -0.4]
QUARTER_ON = np.reshape(RING, (-1, 3))[:, (1, 0, 2)] * (-1, 1, 1)
QUARTER_ON = QUARTER_ON.ravel().tolist()
SHORT = [0.5, 1.2, 0.2, 0.2, 1.2, 0.3]
NECK = [-0.0807, 0.0717, 0.0138, -0.0633, 0.0807, 0.0433, -0.0413, 0.1057, 0.0399, -0.0307, 0.1260, 0.0136,
        -0.0492, 0.1156, -0.0155, -0.0728, 0.0901, -0.0156]
# On the torus' outer side.
PATCH = [1.1, 0.5, 0.38, 1.35, 0.2, 0.2, 1.1, -0.3, 0.38, 0.9, 0.1, 0.4]
LINES = {
    "curve": ("torus", dict(SeedSource=line(*ROUND))),
    "curve and seeds": ("torus", dict(SeedSource=line(*ROUND), SeedPositions=[-1, -0.9, 0.2] + ROUND[:3],
                                      ComputeNearestSeed=1)),
    "curve, dijkstra": ("torus", dict(SeedSource=line(*ROUND), Method="Dijkstra")),
    "curve, cost": ("torus", dict(SeedSource=line(*ROUND), CostArray=["POINTS", "Cost"])),
    "barrier": ("torus", dict(SeedPositions=SEED, BarrierSource=line(*SHORT))),
    "barrier, edges": ("torus", dict(SeedPositions=SEED, BarrierSource=line(*SHORT), Method="Dijkstra")),
    "ring": ("torus", dict(SeedPositions=SEED, BarrierSource=line(*RING, closed=1))),
    "both": ("torus", dict(SeedSource=line(*ROUND[:6]), BarrierSource=line(-0.3, 1, 0.4, -1.2, 0.1, 0.3),
                           DestinationPositions=[-0.9, -0.9, 0.1])),
    "signed": ("torus", dict(SeedSource=line(*PATCH, closed=1), Signed=1)),
    "signed, ball": ("sphere", dict(SeedSource=line(0.1, 0.2, 0.9, 0.8, 0.1, 0.1, 0.2, -0.9, 0.2, closed=1), Signed=1)),
    "signed, open": ("thin", dict(SeedSource=line(0.41, -1, 0, 0.43, 1, 0), Signed=1)),
    "signed, parts": ("parts", dict(SeedSource=line(0.3, -9, 0, 0.35, 9, 0), Signed=1)),
    "signed, bunny": ("bunny", dict(SeedSource=line(*NECK, closed=1), Signed=1)),
    # Round the tube, which is open where the wall is.
    "signed, wall": ("torus", dict(SeedSource=line(*RING, closed=1), BarrierSource=line(*QUARTER_ON, closed=1),
                                   Signed=1)),
    "signed, wall of points": ("torus", dict(SeedSource=line(*RING, closed=1), BarrierArray=["POINTS", "Wall"],
                                             Signed=1)),
    "signed, wall of cells": ("torus", dict(SeedSource=line(*RING, closed=1), BarrierArray=["CELLS", "CellWall"],
                                            Signed=1)),
    "region": ("sphere", dict(SeedArray=["POINTS", "Region"], BarrierSource=line(0.1, 0.2, 0.9, 0.8, 0.1, 0.1))),
    "bunny": ("bunny", dict(SeedSource=line(*cases.points_on("bunny", 3)))),
}
# What one rank solves that the surface is brought to, split along its lines.
for method, names in (("Exact", ("curve and seeds", "both", "ring", "signed, ball", "signed, wall of cells", "region")),
                      ("Bounded", ("barrier", )), ("VirtualSources", ("barrier", ))):
    LINES.update({f"gathered {method} {name}": (LINES[name][0], dict(LINES[name][1], Method=method, GatherForExact=1))
                  for name in names})
LINES["gathered Exact near"] = ("torus", dict(SeedSource=line(*SHORT), Method="Exact", GatherForExact=1,
                                              UseMaximumDistance=1, MaximumDistance=0.5))

for name, (surface, options) in LINES.items():
    if harness.RANKS == 1:
        cases.check(FOLDER, f"lines {name}/whole", harness.surface(surface, "whole"), options)
        continue
    cases.check(FOLDER, f"lines {name}/slabs", harness.surface(surface, "slabs"), options)
    if name.removeprefix("gathered Exact ") in ("curve and seeds", "barrier, edges", "both", "signed, ball",
                                                "signed, wall of points"):
        cases.check(FOLDER, f"lines {name}/random", harness.surface(surface, "random"), options)
        cases.check(FOLDER, f"lines {name}/all on the last", harness.surface(surface, "last"), options)
    if name.removeprefix("gathered Exact ") in ("curve, cost", "ring", "region", "signed, wall of cells"):
        cases.check(FOLDER, f"lines {name}/with ghosts", harness.ghosted(harness.surface(surface, "slabs", True)),
                     options)

if harness.RANKS > 1:
    # The first rank holds its piece and what lies round the lines: so many points for each edge that they cross or
    # follow, on a mesh of 480 x 240 points. A barrier of three corners goes round the whole torus.
    points, cells = pieces.SURFACES["large"]()
    owner = pieces.owners(points, cells, "slabs", harness.RANKS)
    piece = np.max([len(np.unique(cells[owner == rank])) for rank in range(harness.RANKS)])
    for name, edges, options in (
            ("curve", 300, dict(SeedSource=line(*ROUND))),
            ("round the whole", 700, dict(SeedPositions=SEED, BarrierSource=line(
                1.4, 0.01, 0, -0.7, 1.21, 0, -0.7, -1.21, 0, closed=1)))):
        distance = simple.GeodesicDistance(Input=harness.surface("large", "slabs"), **options)
        harness.run(distance, os.path.join(FOLDER, f"held.{harness.RANKS}"))
        held = harness.informed(distance, "MostPointsOnARank")
        print(f"lines {name}: {held - piece} points beside a piece of {piece}", flush=True)
        assert piece <= held <= piece + POINTS_OF_EDGE * edges, (name, held, piece)
        simple.Delete(distance)
