# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures one field on two threads, counts it on up to 64, and puts the tables into threads.md.

usage: thread_suite.py THREAD_BENCHMARK DOCUMENT.md [--tiny]
The tables stand in the page between two comments. --tiny: on tiny surfaces, to try whether it runs; the page stays.
"""

import statistics
import subprocess
import sys

from report import table

TIMED = {"sphere": ["sphere:7", "sphere:8", "sphere:9"], "torus": ["torus:286", "torus:570", "torus:1145"],
         "Bunny, subdivided": ["bunny:1", "bunny:2", "bunny:3"]}
COUNTED = {"sphere": "sphere:10", "terrain": "terrain:3200", "Bunny, subdivided": "bunny:4"}
TINY = {"sphere": ["sphere:4"]}
THREADS = [2, 4, 16, 64]
RUNS, RUNS_COUNTED = 5, 1
# Of the surfaces that are the first of each kind above.
NUMBERS_OF_SEEDS = [2, 5, 20, 100, 1000, 10000]
# What one thread takes depends on where a process gets its memory, by up to a third.
PROCESSES = 5
BEGIN, END = "<!-- Tables of thread_suite.py: -->", "<!-- End of the tables. -->"
LARGEST_DIFFERENCE = 1e-9


def measured(program, surface, threads, runs, seeds=1):
    run = subprocess.run([program, surface, str(threads), str(runs), str(seeds)], stdout=subprocess.PIPE, text=True,
                         check=True)
    found = {name: float(value) for name, value in (line.split(" ") for line in run.stdout.splitlines())}
    print(surface, threads, seeds, found, flush=True)
    if found["difference"] > LARGEST_DIFFERENCE:
        raise RuntimeError(f"The field is not that of one thread: it differs by {found['difference']}.")
    return found


def medians(program, surface, runs, processes, seeds=1):
    several = [measured(program, surface, 2, runs, seeds) for _ in range(processes)]
    return {key: statistics.median(one[key] for one in several) for key in several[0]}


def table_of_times(program, surfaces, runs, processes):
    rows = []
    for name, sizes in surfaces.items():
        for surface in sizes:
            found = medians(program, surface, runs, processes)
            rows.append([name, f"{found['vertices']:,.0f}", f"{found['alone']:.1f} ms", f"{found['time']:.1f} ms",
                         f"{found['ratio']:.2f}", f"{found['first_alone'] / found['first']:.2f}",
                         f"{found['difference']:.0e}"])
    return table(["surface", "vertices", "one thread", "two threads", "times as fast", "first run",
                  "largest difference"], rows)


def table_of_seeds(program, surfaces, numbers, runs, processes):
    rows = []
    for seeds in numbers:
        row = [f"{seeds:,}"]
        for sizes in surfaces.values():
            found = medians(program, sizes[0], runs, processes, seeds)
            row += [f"{found['alone']:.0f} and {found['time']:.0f} ms", f"{found['ratio']:.2f}"]
        rows.append(row)
    return table(["seeds", *(title for name in surfaces for title in (name, "times as fast"))], rows)


def table_of_counts(program, surfaces, threads_counted, runs):
    rows = []
    for name, surface in surfaces.items():
        for threads in threads_counted:
            found = measured(program, surface, threads, runs)
            rows.append([name, f"{found['vertices']:,.0f}", str(threads), f"{found['updates']:.2f}",
                         f"{found['sent']:.3f}", f"{found['rounds']:,.0f}", f"{found['balance']:.1f}",
                         f"{found['speed']:.1f}"])
    return table(["surface", "vertices", "threads", "updates a vertex", "sent a vertex", "rounds", "balance",
                  "times as fast by counts"], rows)


def main(program, document, *options):
    is_tiny = "--tiny" in options
    timed, runs, processes = (TINY, 2, 2) if is_tiny else (TIMED, RUNS, PROCESSES)
    times = table_of_times(program, timed, runs, processes)
    of_seeds = table_of_seeds(program, timed, [2, 100] if is_tiny else NUMBERS_OF_SEEDS, runs, processes)
    counted = {"sphere": "sphere:4"} if is_tiny else COUNTED
    counts = table_of_counts(program, counted, [3] if is_tiny else THREADS, 1 if is_tiny else RUNS_COUNTED)
    with open(document, encoding="utf-8") as page:
        text = page.read()
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    if not is_tiny:
        with open(document, "w", encoding="utf-8") as page:
            page.write(f"{before}{BEGIN}\n\n{times}\n\n{of_seeds}\n\n{counts}\n\n{END}{after}")


if __name__ == "__main__":
    main(*sys.argv[1:])
