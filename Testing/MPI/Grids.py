# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Grids that ranks have pieces of: the fields on their outer surface are those of one rank.

usage: mpiexec -n N pvbatch [--sym] Grids.py OUR_PLUGIN FOLDER
The run with one rank leaves the fields in FOLDER that the others are compared with.
"""

import os
import sys

from paraview import simple

sys.path.append(os.path.dirname(__file__))
import cases
import harness

PLUGIN, FOLDER = sys.argv[1:]
os.makedirs(FOLDER, exist_ok=True)
harness.load(PLUGIN)
BRICK = dict(SeedPositions=[0.31, 0.2, 1])
IMAGE = dict(SeedPositions=[8, 12, 4], ComputeNearestSeed=1)


def whole():
    return [("brick/whole", harness.brick("first"), BRICK), ("image/whole", harness.image(), IMAGE)]


def in_pieces():
    made_ids = harness.with_made_ids(harness.brick("random"))
    return [("brick/random", harness.brick("random"), BRICK),
            ("brick/random with ghosts", harness.ghosted(harness.brick("random")), BRICK),
            ("brick/made ids", made_ids, dict(BRICK, MergeCoincidentPoints=0)),
            ("brick/in boxes", harness.brick("boxes"), BRICK),
            ("brick/boxes with ghosts", harness.ghosted(harness.brick("boxes")), BRICK),
            ("brick/all on the first", harness.brick("first"), BRICK),
            ("image/parts", harness.image(), IMAGE), ("image/with ghosts", harness.ghosted(harness.image()), IMAGE)]


def redistributed():
    cut = simple.RedistributeDataSet(Input=harness.brick("first"))
    return [("brick/redistributed", cut, BRICK), ("brick/with ghosts", harness.ghosted(cut), BRICK)]


found = whole() if harness.RANKS == 1 else in_pieces()
if harness.RANKS > 1 and harness.can_redistribute():
    found += redistributed()
for case, source, options in found:
    cases.check(FOLDER, case, source, options)
