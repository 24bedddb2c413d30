# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is measured of Exact and Bounded, what is asked of it, and the tables of it.

usage: exact_report.py BUILD_FOLDER/benchmarks/exact.json DOCUMENTATION_FOLDER
"""

import json
import os
import string
import sys

from report import number, output_of, processor, table

TEMPLATE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "exact_benchmarks.md.in")
BEGIN, END = "<!-- Tables of exact_suite.py: -->", "<!-- End of the tables. -->"

GUIDE_WORDS = """Distances of a whole surface from one seed, on one core. *N:1* behind a surface: it was made N times flatter along one
axis, and the row is that of the slowest axis. Errors are fractions of the largest distance, from eight seeds, of the worst
axis: 1e-3 is 0.1 %."""

# Of each surface: how many times flatter, as one.
NATURAL = [("Bunny 35k", 1), ("icosphere 160k", 1), ("torus 250k", 1), ("thin grid 160k", 1),
           ("Delaunay plane 160k", 1)]
NEEDLES = [("Bunny 35k", 10), ("Bunny 35k", 100), ("Bunny 35k", 1000), ("torus 40k", 10), ("torus 40k", 100),
           ("torus 40k", 1000), ("box with fillets 40k", 1), ("box with fillets 40k", 1000)]
TRUTH_BY_CGAL = [("Spot 3k", 1), ("Bunny 35k", 1), ("icosphere 10k", 1), ("Delaunay plane 10k", 1), ("torus 10k", 1),
                 ("thin grid 10k", 1), ("saddles 10k", 1), ("cube 10k", 1), ("Spot 3k", 10), ("Spot 3k", 1000),
                 ("torus 10k", 1000), ("box with fillets 2k", 1), ("box with fillets 2k", 1000)]
TRUTH_BY_EXACT = [("icosphere 160k", 1), ("Delaunay plane 160k", 1), ("thin grid 160k", 1), ("Bunny 35k", 10),
                  ("Bunny 35k", 100), ("Bunny 35k", 1000), ("torus 40k", 10), ("torus 40k", 100), ("torus 40k", 1000),
                  ("torus 10k", 100), ("Spot 3k", 100), ("icosphere 10k", 10), ("icosphere 10k", 100),
                  ("icosphere 10k", 1000), ("saddles 10k", 10), ("saddles 10k", 1000), ("thin grid 10k", 1000),
                  ("Delaunay plane 10k", 1000), ("cube 10k", 10), ("cube 10k", 1000), ("box with fillets 40k", 1)]
METHODS = ["FastMarching", "Dijkstra", "VirtualSources", "Bounded", "Exact"]
OF_METHODS = [("Bunny 35k", 1), ("Bunny 35k", 1000), ("icosphere 160k", 1), ("Delaunay plane 160k", 1)]
WINDOWS = ["Exact", "Bounded"]
# Times of Dijkstra's algorithm: at least, aim.
ASKED = {("Bunny 35k", "Exact"): (30, 12), ("icosphere 160k", "Exact"): (90, 40),
         ("Delaunay plane 160k", "Exact"): (120, 60), ("Bunny 35k", "Bounded"): (15, 5),
         ("icosphere 160k", "Bounded"): (15, 5)}
ASKED_ON_NEEDLES = {"Bounded": (30, 10)}
# Bytes a vertex.
ASKED_BYTES = {"Bunny 35k": (800, 300)}
ASKED_BYTES_ELSEWHERE = (4000, 1500)
ASKED_OF_CGAL = {"Bunny 35k": (15, 50), "icosphere 10k": (20, 60)}
# Seconds.
ASKED_OF_PATHS = {0.01: (5e-3, 1e-3), 0.05: (0.1, 0.02)}
MANY = [("hilly grid 40k", 10000), ("hilly grid 160k", 100000), ("fan 100k", 1), ("fan 100k", 10000),
        ("pages 100k", 1), ("pages 100k", 10000), ("parts 100k", 100000), ("strip 100k", 1), ("strip 100k", 100000)]
LIMITS = [("icosphere 160k", 0.02), ("torus 250k", 0.05), ("Bunny 35k", 0.005), ("strip 300k", 0.03)]
ABORTED = "icosphere 2.6M"
SECONDS_TO_ABORT = 10


def commands():
    """What ExactBenchmark is told, one after the other."""
    for surface in NATURAL + NEEDLES:
        yield from (["time", *surface, method] for method in WINDOWS)
    for surface in OF_METHODS:
        yield from (["time", *surface, method] for method in METHODS if method not in WINDOWS)
        yield from (["error", *surface, method, "Exact"] for method in METHODS if method not in WINDOWS)
    for surface in TRUTH_BY_CGAL:
        yield from (["error", *surface, method, "CGAL"] for method in WINDOWS)
    for surface in TRUTH_BY_EXACT:
        yield ["error", *surface, "Bounded", "Exact"]
    yield from (["cgal", surface, "Exact"] for surface in ASKED_OF_CGAL)
    for part in ASKED_OF_PATHS:
        yield from (["path", "hilly grid 1M", part, method] for method in WINDOWS)
    for method in WINDOWS:
        yield from (["many", surface, count, method] for surface, count in MANY)
    for method in WINDOWS:
        yield from (["limit", surface, method, gigabytes] for surface, gigabytes in LIMITS)
    yield from (["abort", ABORTED, method, SECONDS_TO_ABORT] for method in WINDOWS)


def key(command):
    return " / ".join(map(str, command))


def named(surface):
    name, factor = surface
    return name if factor == 1 else f"{name}, {factor}:1"


def cell(found, name, times=1.0, unit=""):
    """A number and its unit; why there is none: - where it was not measured."""
    if name not in found:
        return found.get("error", "-")
    return number(times * found[name]) + unit


def held(value, asked):
    """Whether a value is no more than what is asked for; less than nothing asks for more."""
    if asked is None or value is None:
        return ""
    at_least, aim = asked
    sign = -1 if aim > at_least else 1
    if sign * value <= sign * aim:
        return "yes, the aim"
    return "yes" if sign * value <= sign * at_least else "**no**"


def times_and_memory(cases):
    rows = []
    for surface in NATURAL + NEEDLES:
        for method in WINDOWS:
            found = cases.get(key(["time", *surface, method]), {})
            asked = ASKED.get((surface[0], method)) if surface[1] == 1 else ASKED_ON_NEEDLES.get(method)
            asked = asked if surface in NATURAL or surface[1] > 1 else None
            asked_bytes = ASKED_BYTES.get(surface[0], ASKED_BYTES_ELSEWHERE) if surface[1] == 1 \
                else ASKED_BYTES_ELSEWHERE
            rows.append([named(surface), method, cell(found, "points"), cell(found, "seconds", 1e3, " ms"),
                         cell(found, "dijkstras"), str(asked[0]) if asked else "", held(found.get("dijkstras"), asked),
                         cell(found, "windows"), cell(found, "bytes"), str(asked_bytes[0]),
                         held(found.get("bytes"), asked_bytes)])
    return table(["Surface", "Method", "Points", "Time", "D", "asked", "holds", "Windows", "Bytes", "asked", "holds"],
                 rows)


def agreement(cases):
    rows = []
    for surface in TRUTH_BY_CGAL:
        found = cases.get(key(["error", *surface, "Exact", "CGAL"]), {})
        asked = (1e-9, 1e-11) if surface[1] > 1 or "fillets" in surface[0] else (1e-10, 1e-11)
        rows.append([named(surface), cell(found, "points"), cell(found, "largest"), cell(found, "unreached"),
                     f"{asked[0]:.0e}", held(found.get("largest"), asked)])
    return table(["Surface", "Points", "Largest difference", "Points not reached", "asked", "holds"], rows)


def errors_of_bounded(cases):
    rows = []
    for surfaces, truth in ((TRUTH_BY_CGAL, "CGAL"), (TRUTH_BY_EXACT, "Exact")):
        for surface in surfaces:
            found = cases.get(key(["error", *surface, "Bounded", truth]), {})
            rows.append([named(surface), truth, cell(found, "points"), cell(found, "too_large"),
                         cell(found, "too_small"), held(found.get("too_large"), (1.0000001e-3, 1.0000001e-3))])
    return table(["Surface", "Truth", "Points", "Too large at most", "Too small at most", "within 1e-3"], rows)


def beside_cgal(cases):
    rows = []
    for surface, asked in ASKED_OF_CGAL.items():
        found = cases.get(key(["cgal", surface, "Exact"]), {})
        rows.append([surface, cell(found, "points"), cell(found, "times"), str(asked[0]), held(found.get("times"), asked)])
    return table(["Surface", "Points", "CGAL's time in ours", "asked", "holds"], rows)


def paths(cases):
    rows = []
    for part, asked in ASKED_OF_PATHS.items():
        for method in WINDOWS:
            found = cases.get(key(["path", "hilly grid 1M", part, method]), {})
            rows.append([f"{100 * part:g} %", method, cell(found, "median", 1e3, " ms"), cell(found, "most", 1e3, " ms"),
                         f"{1e3 * asked[0]:g} ms", held(found.get("median"), asked), cell(found, "proven", 100, " %")])
    return table(["Ends apart", "Method", "Median", "Most", "asked", "holds", "Proven"], rows)


def many(cases):
    rows = []
    for surface, count in MANY:
        for method in WINDOWS:
            found = cases.get(key(["many", surface, count, method]), {})
            rows.append([surface, f"{count:,}", method, cell(found, "seconds", 1e3, " ms"), cell(found, "silence", 1e3, " ms"),
                         cell(found, "megabytes", 1, " MB")])
    return table(["Surface", "Seeds", "Method", "Time", "Silence", "Memory"], rows)


def limits(cases):
    rows = []
    for surface, gigabytes in LIMITS:
        for method in WINDOWS:
            found = cases.get(key(["limit", surface, method, gigabytes]), {})
            rows.append([surface, method, f"{1e3 * gigabytes:g} MB", cell(found, "gigabytes", 1e3, " MB"),
                         found.get("message", found.get("error", "-"))])
    return table(["Surface", "Method", "Limit", "Taken", "Message"], rows)


def aborts(cases):
    rows = []
    for method in WINDOWS:
        found = cases.get(key(["abort", ABORTED, method, SECONDS_TO_ABORT]), {})
        rows.append([method, *(cell(found, name, 1e3, " ms") for name in (
            "silence_of_set_up", "silence_of_field", "end_of_field", "silence_of_path", "end_of_path")),
            held(max((v for k, v in found.items() if k.startswith(("silence", "end"))), default=None), (0.2, 0.2))])
    return table(["Method", "Set-up", "Field", "its end", "Path", "its end", "within 0.2 s"], rows)


def methods(cases):
    """The guide's table: time and error of all methods."""
    rows = []
    for surface in OF_METHODS:
        for method in METHODS:
            time = cases.get(key(["time", *surface, method]), {})
            error = {} if method in WINDOWS else cases.get(key(["error", *surface, method, "Exact"]), {})
            if method == "Bounded":
                truth = "CGAL" if surface in TRUTH_BY_CGAL else "Exact"
                error = cases.get(key(["error", *surface, method, truth]), {})
            rows.append([named(surface), method, cell(time, "seconds", 1e3, " ms"),
                         *(["0", "0"] if method == "Exact" else [cell(error, "mean"), cell(error, "largest")])])
    return table(["Surface, points", "Method", "Time", "Mean error", "Largest error"], rows)


def machine(run):
    return (f"{processor()}, {run['cores']} cores; g++ {output_of('g++', '-dumpfullversion')}; commit {run['commit']}; "
            f"{run['date']}")


def load(run):
    return f"load before the start {run['load'][0]:.2f}"


def write(run, documentation, with_guide=True):
    cases = run["cases"]
    with open(TEMPLATE) as file:
        template = string.Template(file.read())
    with open(os.path.join(documentation, "exact_benchmarks.md"), "w") as file:
        file.write(template.substitute(
            machine=f"{machine(run)}; {load(run)}", times=times_and_memory(cases), agreement=agreement(cases),
            bounded=errors_of_bounded(cases), cgal=beside_cgal(cases), paths=paths(cases), many=many(cases),
            limits=limits(cases), aborts=aborts(cases), abort_seconds=SECONDS_TO_ABORT))
    if not with_guide:
        methods(cases)
        return
    page = os.path.join(documentation, "guide", "methods.md")
    with open(page) as file:
        before, rest = file.read().split(BEGIN)
    with open(page, "w") as file:
        file.write(f"{before}{BEGIN}\n\n{GUIDE_WORDS}\n\nMeasured on {machine(run)}.\n\n{methods(cases)}\n\n{END}{rest.split(END)[1]}")


if __name__ == "__main__":
    with open(sys.argv[1]) as stream:
        write(json.load(stream), sys.argv[2])
