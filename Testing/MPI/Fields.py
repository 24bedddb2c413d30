# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields on several ranks are those of one rank, however the triangles are dealt out.

usage: mpiexec -n N pvbatch [--sym] Fields.py OUR_PLUGIN FOLDER [CASE ...]
The run with one rank leaves the fields in FOLDER that the others are compared with.
"""

import os
import sys

sys.path.append(os.path.dirname(__file__))
import cases
import harness

PLUGIN, FOLDER, *ONLY = sys.argv[1:]
os.makedirs(FOLDER, exist_ok=True)
harness.load(PLUGIN)

chosen = {case: cases.FIELDS[case] for case in ONLY} or harness.some(cases.FIELDS)
for case, (surface, options) in chosen.items():
    for cut in ("slabs", "random") if harness.RANKS > 1 else ("whole",):
        cases.check(FOLDER, f"{case}/{cut}", harness.surface(surface, cut), options)
    if harness.RANKS > 1 and "GatherForExact" not in options:
        cases.check(FOLDER, f"{case}/slabs spread", harness.surface(surface, "slabs"), dict(options, SpreadWork=1))
