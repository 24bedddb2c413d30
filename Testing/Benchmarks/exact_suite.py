# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures Exact and Bounded on one core, each case in a process of its own, and writes what was found into the pages.

usage: exact_suite.py EXACT_BENCHMARK BUILD_FOLDER DOCUMENTATION_FOLDER [--tiny]

The results stay in BUILD_FOLDER/benchmarks/exact.json. The page of exact benchmarks is written whole; in the guide's page
of methods the tables stand between two comments. --tiny: on tiny surfaces, to try whether it runs; no page of the guide.
"""

import datetime
import json
import os
import subprocess
import sys

import exact_report
from report import commit

# Seconds of the clock on the wall.
LIMIT = 1800


def measured(program, command, tiny):
    """What the program told; "error" where it did not end well."""
    print(*command, flush=True)
    try:
        run = subprocess.run([program, *tiny, *map(str, command)], stdout=subprocess.PIPE, text=True, timeout=LIMIT,
                             check=False)
        lines = run.stdout.splitlines()
        if run.returncode not in (0, 1):
            raise RuntimeError(f"{program} {' '.join(map(str, command))} ended with {run.returncode}")
    except subprocess.TimeoutExpired:
        lines = [f"error took more than {LIMIT} s"]
    found = {}
    for line in lines:
        name, value = line.split(" ", 1)
        found[name] = value if name in ("error", "message") else float(value)
    print(found, flush=True)
    return found


def main(program, build, documentation, *tiny):
    results = os.path.join(build, "benchmarks")
    os.makedirs(results, exist_ok=True)
    run = {"load": os.getloadavg(), "cores": os.cpu_count(), "commit": commit(), "date": str(datetime.date.today()),
           "cases": {}}
    # What is started from here on inherits the core.
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    for command in exact_report.commands():
        run["cases"][exact_report.key(command)] = measured(program, command, tiny)
        with open(os.path.join(results, "exact.json"), "w") as stream:
            json.dump(run, stream, indent=1)
    exact_report.write(run, documentation, with_guide=not tiny)


if __name__ == "__main__":
    main(*sys.argv[1:])
