# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts what fields on many ranks take, all in one process, and puts the tables into cluster_benchmarks.md.

usage: rank_suite.py RANK_COUNTS DOCUMENT.md [--tiny]
The tables stand in the page between two comments. --tiny: on tiny surfaces, to try whether it runs; the page stays.
"""

import functools
import subprocess
import sys

from report import table

SURFACES = {"sphere of 2.6 million": "sphere:9", "Bunny of 2.2 million": "bunny:3"}
TINY = {"sphere of 642": "sphere:3", "Bunny of 35 thousand": "bunny:0"}
SEEDS = {"on a cut": "cut", "in the middle": "middle"}
RANKS = [1, 2, 64, 1000]
# Patches a rank.
PATCHES = [1, 4, 8, 16]
BEGIN, END = "<!-- Tables of rank_suite.py: -->", "<!-- End of the tables. -->"
LARGEST_DIFFERENCE = 1e-9


@functools.cache
def counted(program, surface, seed, ranks, patches):
    run = subprocess.run(
        [program, surface, seed, str(ranks), str(patches)], stdout=subprocess.PIPE, text=True, check=True)
    found = {name: float(value) for name, value in (line.split(" ") for line in run.stdout.splitlines())}
    print(surface, seed, ranks, patches, found, flush=True)
    if found["difference"] > LARGEST_DIFFERENCE:
        raise RuntimeError(f"The field is not that of one rank: it differs by {found['difference']}.")
    return found


def speed(alone, found):
    """How many times as fast as one rank, were messages free and all updates equal."""
    return f"{alone['updates'] / found['chain']:.2f}"


def whole(number):
    return f"{number:,.0f}"


def table_of_ranks(program, surfaces, ranks_counted):
    rows = []
    for name, surface in surfaces.items():
        for seed_name, seed in SEEDS.items():
            alone = None
            for ranks in ranks_counted:
                found = counted(program, surface, seed, ranks, 1)
                alone = alone or found
                rows.append([name, seed_name, whole(ranks), whole(found["most_points"]), whole(found["shared"]),
                             whole(found["rounds"]), whole(found["bytes"]), whole(found["updates"]),
                             whole(found["chain"]), speed(alone, found)])
    return table(["surface", "seed", "ranks", "points a rank", "shared points", "rounds", "bytes", "updates",
                  "longest chain", "times as fast by counts"], rows)


def table_of_patches(program, surfaces):
    rows = []
    for name, surface in surfaces.items():
        for seed_name, seed in SEEDS.items():
            alone = counted(program, surface, seed, 1, 1)
            for patches in PATCHES:
                found = counted(program, surface, seed, 2, patches)
                rows.append([name, seed_name, whole(patches), whole(found["shared"]), whole(found["rounds"]),
                             whole(found["bytes"]), whole(found["updates"]), whole(found["chain"]),
                             speed(alone, found)])
    return table(["surface", "seed", "patches a rank", "shared points", "rounds", "bytes", "updates", "longest chain",
                  "times as fast by counts"], rows)


def main(program, document, *tiny):
    surfaces, ranks = (TINY, [1, 2, 8]) if tiny else (SURFACES, RANKS)
    tables = "\n\n".join(["Compact pieces, one a rank:", table_of_ranks(program, surfaces, ranks),
                          "Two ranks with several patches each, dealt out in turn:", table_of_patches(program, surfaces)])
    if tiny:
        print(tables)
        return
    with open(document) as file:
        before, rest = file.read().split(BEGIN)
    with open(document, "w") as file:
        file.write(f"{before}{BEGIN}\n\n{tables}\n\n{END}{rest.split(END)[1]}")
    print("Wrote", document)


if __name__ == "__main__":
    main(*sys.argv[1:])
