# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmarks of paths on one core and writes the document of their results.

usage: path_suite.py BUILD_FOLDER PVPYTHON OUR_PLUGIN BUNDLED_PLUGIN DOCUMENT.md [--tiny]

The results stay in BUILD_FOLDER/benchmarks as JSON. --tiny: on fewer and tiny meshes, to try whether it runs.
"""

import array
import json
import os
import subprocess
import sys

import path_report
from suite import FOLDER, loaded, run

MISSING = {"length": 0, "update": 0, "whole": 0}


def lines_of(file):
    with open(file) as stream:
        return [json.loads(line) for line in stream]


def paths_of(kind, pvpython, plugin, folder, surface):
    """What path_peers.py finds, as columns. Where the bundled filter crashes or does not end, there is no path."""
    exact = array.array("d")
    with open(os.path.join(folder, surface + ".pairs"), "rb") as stream:
        exact.frombytes(stream.read())
    exact = exact[2::3].tolist()
    file = os.path.join(folder, f"{surface}.{kind}.jsonl")
    open(file, "w").close()
    while len(lines := lines_of(file)) < len(exact):
        print(kind, "on", surface, "from pair", len(lines), flush=True)
        # What it says while it does not end would fill the disk.
        ended = subprocess.run([pvpython, os.path.join(FOLDER, "path_peers.py"), file, kind, plugin, folder,
                                surface, str(len(lines))],
                               stdout=subprocess.DEVNULL if kind == "bundled" else None,
                               stderr=subprocess.DEVNULL if kind == "bundled" else None)
        if kind == "bundled" and ended.returncode < 0:
            with open(file, "a") as stream:
                print(json.dumps(MISSING), file=stream)
        else:
            ended.check_returncode()
    return {"exact": exact, **{key: [line[key] for line in lines] for key in MISSING}}


def main(build, pvpython, ours, bundled, document, tiny=None):
    results = os.path.join(build, "benchmarks", "paths")
    os.makedirs(results, exist_ok=True)
    # What is started from here inherits the core.
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})

    core = os.path.join(results, "core.json")
    run(os.path.join(build, "bin", "PathBenchmark"),
        *([tiny, "--benchmark_filter=-(torus 10k|sphere|hills)"] if tiny else []),
        f"--surfaces={results}", f"--benchmark_out={core}", "--benchmark_out_format=json")
    found = {"core": loaded(core), "peers": {}}
    for kind, plugin in (("ours", ours), ("dijkstra", ours), ("bundled", bundled)):
        found["peers"][kind] = {surface: paths_of(kind, pvpython, plugin, results, surface)
                                for surface in path_report.surfaces(found["core"])}
    with open(os.path.join(results, "all.json"), "w") as stream:
        json.dump(found, stream, indent=1)
    path_report.write(found, document)
    print("Wrote", document)


if __name__ == "__main__":
    main(*sys.argv[1:])
