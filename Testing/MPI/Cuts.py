# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cuts by ParaView's own filters, ghost cells, global ids, empty ranks: the fields are those of one rank.

usage: mpiexec -n N pvbatch [--sym] Cuts.py OUR_PLUGIN FOLDER
After Fields.py with one rank, whose fields are compared with.
"""

import os
import sys

from paraview import simple

sys.path.append(os.path.dirname(__file__))
import cases
import harness

PLUGIN, FOLDER = sys.argv[1:]
harness.load(PLUGIN)
can_redistribute = harness.can_redistribute()

for case in ("bunny", "seeds", "torus", "costs", "wall"):
    surface, options = cases.FIELDS[case]
    cases.check(FOLDER, f"{case}/in boxes", harness.surface(surface, "boxes"), options)
    if can_redistribute:
        cases.check(FOLDER, f"{case}/redistributed", harness.redistributed(surface), options)
    cases.check(FOLDER, f"{case}/boxes with ghosts", harness.ghosted(harness.surface(surface, "boxes", True)), options)
    cases.check(FOLDER, f"{case}/with ghosts", harness.ghosted(harness.surface(surface, "slabs", True)), options)
    cases.check(FOLDER, f"{case}/random with ghosts", harness.ghosted(harness.surface(surface, "random", True)), options)
    cases.check(FOLDER, f"{case}/all on the last", harness.surface(surface, "last"), options)
    cases.check(FOLDER, f"{case}/with ids", harness.surface(surface, "slabs", True), options)
    cases.check(FOLDER, f"{case}/ids only", harness.surface(surface, "random", True), dict(options, MergeCoincidentPoints=0))
    cases.check(FOLDER, f"{case}/blocks", harness.in_blocks(surface), options)
    cases.check(FOLDER, f"{case}/made ids", harness.with_made_ids(harness.surface(surface, "slabs")),
                 dict(options, MergeCoincidentPoints=0))
