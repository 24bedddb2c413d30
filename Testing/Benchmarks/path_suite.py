"""Runs the benchmarks of paths on one core and writes the document of their results.

usage: path_suite.py BUILD_FOLDER PVPYTHON OUR_PLUGIN BUNDLED_PLUGIN DOCUMENT.md [--tiny]

The results stay in BUILD_FOLDER/benchmarks as JSON. --tiny: on tiny meshes, to try whether it runs.
"""

import json
import os
import sys

import path_report
from suite import FOLDER, loaded, run


def main(build, pvpython, ours, bundled, document, tiny=None):
    results = os.path.join(build, "benchmarks", "paths")
    os.makedirs(results, exist_ok=True)
    # What is started from here inherits the core.
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})

    core = os.path.join(results, "core.json")
    run(os.path.join(build, "bin", "PathBenchmark"), *([tiny] if tiny else []),
        f"--surfaces={results}", f"--benchmark_out={core}", "--benchmark_out_format=json")
    found = {"core": loaded(core), "peers": {}}
    for kind, plugin in (("ours", ours), ("dijkstra", ours), ("bundled", bundled)):
        file = os.path.join(results, kind + ".json")
        run(pvpython, os.path.join(FOLDER, "path_peers.py"), file, kind, plugin, results,
            *path_report.surfaces(found["core"]))
        found["peers"][kind] = loaded(file)
    with open(os.path.join(results, "all.json"), "w") as stream:
        json.dump(found, stream, indent=1)
    path_report.write(found, document)
    print("Wrote", document)


if __name__ == "__main__":
    main(*sys.argv[1:])
