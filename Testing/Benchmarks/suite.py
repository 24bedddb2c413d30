# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmarks on one core, or two where they say so, and writes the document of their results.

usage: suite.py BUILD_FOLDER PVPYTHON OUR_PLUGIN BUNDLED_PLUGIN DOCUMENT.md [--tiny]

The results stay in BUILD_FOLDER/benchmarks as JSON. --tiny: on tiny meshes, to try whether it runs.
"""

import json
import os
import subprocess
import sys

import report

FOLDER = os.path.dirname(os.path.abspath(__file__))
ROUNDS = 3
TWO_THREADS = "^SetupOnTwoThreads/"


def run(*command):
    print(*command, flush=True)
    subprocess.run(command, check=True)


def loaded(file):
    with open(file) as stream:
        return json.load(stream)


def main(build, pvpython, ours, bundled, document, tiny=None):
    results = os.path.join(build, "benchmarks")
    os.makedirs(results, exist_ok=True)
    cores = os.sched_getaffinity(0)

    def core(name, only="."):
        file = os.path.join(results, name + ".json")
        run(os.path.join(build, "bin", "SolverBenchmark"), *([tiny] if tiny else []),
            f"--benchmark_filter={only}", "--benchmark_report_aggregates_only=true",
            "--benchmark_out_format=json", f"--benchmark_out={file}")
        return loaded(file)

    def filter_run(kind, plugin):
        file = os.path.join(results, kind + ".json")
        run(pvpython, os.path.join(FOLDER, "filter_benchmark.py"), file, "2" if tiny else "8", kind,
            plugin)
        return loaded(file)

    def moving_run(seed_by):
        file = os.path.join(results, f"moving-by-{seed_by}.json")
        run(pvpython, os.path.join(FOLDER, "moving_surface.py"), file, ours, seed_by,
            *(["20"] if tiny else []))
        return loaded(file)

    two_threads = core("two-threads", TWO_THREADS) if len(cores) > 1 else None
    # What is started from here on inherits the core.
    os.sched_setaffinity(0, {max(cores)})
    # The core's solve runs again and again between the filters that are compared with it.
    found = {
        "two-threads": two_threads,
        "core": core("core", f"-{TWO_THREADS}"),
        "rounds": [{
            "core": core("round", f"^Solve/{report.FILTER_MESH}"),
            "ours-by-id": filter_run("ours-by-id", ours),
            "ours-by-position": filter_run("ours-by-position", ours),
            "bundled": filter_run("bundled", bundled),
            "moving": {seed_by: moving_run(seed_by) for seed_by in ("id", "position")},
        } for _ in range(1 if tiny else ROUNDS)]
    }
    with open(os.path.join(results, "all.json"), "w") as stream:
        json.dump(found, stream, indent=1)
    report.write(found, document)
    print("Wrote", document)


if __name__ == "__main__":
    main(*sys.argv[1:])
