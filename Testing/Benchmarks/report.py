# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the document of the benchmarks from their results.

usage: report.py BUILD_FOLDER/benchmarks/all.json DOCUMENT.md
"""

import json
import os
import platform
import shutil
import string
import subprocess
import sys
from statistics import median

TEMPLATE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "benchmarks.md.in")
FILTER_MESH = "icosphere 650k"
MIXED = "rounded tube 66k"
SMOOTH = ["icosphere 10k", "icosphere 160k", "torus 250k", "icosphere 650k",
          "shuffled points 650k", "all shuffled 650k", "icosphere 2.6M"]
ALL_SHUFFLED = "all shuffled 650k"


class Medians:
    """The medians of a run of SolverBenchmark, by what was measured and on which mesh."""

    def __init__(self, run):
        self.entries = {}
        for entry in run["benchmarks"]:
            if entry.get("aggregate_name", "median") == "median":
                what, mesh = entry["run_name"].split("/")[:2]
                self.entries[what, mesh] = entry

    def __call__(self, what, mesh, counter="ratio"):
        return self.entries[what, mesh].get(counter)

    def meshes(self, what):
        return [mesh for w, mesh in self.entries if w == what]


def number(value):
    """Two or three digits, in the notation that reads best."""
    if value is None:
        return "-"
    if value == 0:
        return "0"
    if 0.1 <= value < 1e6:
        return f"{value:.3g}" if value < 100 else f"{value:,.0f}"
    mantissa, exponent = f"{value:.1e}".split("e")
    return f"{mantissa}e{int(exponent)}"


def table(heads, rows):
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def row(what, measured, at_least, aim, unit="", note=""):
    """A row of what was asked for; larger is better where the aim is the larger bound."""
    sign = -1 if aim > at_least else 1

    def holds(bound):
        return sign * measured <= sign * bound

    verdict = "yes, the aim" if holds(aim) else "yes" if holds(at_least) else "**no**"
    return [what, number(at_least) + unit, number(aim) + unit, number(measured) + unit + note, verdict]


def row_without_bounds(what, measured):
    return [what, "", "", number(measured), ""]


def worst(medians, what, meshes):
    """The largest ratio and on which mesh."""
    mesh = max(meshes, key=lambda m: medians(what, m))
    return medians(what, mesh), f" ({mesh}; best {number(min(medians(what, m) for m in meshes))})"


def rows_of_solve(medians):
    ratio, note = worst(medians, "Solve", SMOOTH)
    yield row(f"Solve, Dijkstra times: smooth, the worst of {len(SMOOTH)}", ratio, 1.2, 0.9, note=note)
    for mesh, at_least, aim in (
            ("Bunny 35k", 1.8, 1.2), ("Delaunay plane 160k", 2.2, 1.4), ("thin grid 160k", 10, 5)):
        yield row(f"Solve, Dijkstra times: {mesh}", medians("Solve", mesh), at_least, aim)
    yield row_without_bounds(f"Solve, Dijkstra times: {MIXED}, edges 1:1000", medians("Solve", MIXED))
    asked = [mesh for mesh in medians.meshes("Setup") if mesh != ALL_SHUFFLED]
    ratio, note = worst(medians, "Setup", asked)
    yield row("Setup, Dijkstra times: the worst of all but the next", ratio, 1.5, 1.0, note=note)
    yield row("Setup, Dijkstra times: triangles shuffled as well as points",
              medians("Setup", ALL_SHUFFLED), 1.5, 1.0)


def rows_of_filter(rounds):
    def of(kind, key):
        return median(r[kind][key] for r in rounds)

    points = of("ours-by-position", "points")
    allowed, warm = [], []
    for r in rounds:
        core = Medians(r["core"])("Solve", FILTER_MESH, "solve_ns") * points
        allowed.append(1.3 * core + 20 * points)
        warm.append(1e9 * median(r["ours-by-position"]["warm"]))
    share = median(w / a for w, a in zip(warm, allowed))
    yield ["Filter's Update(), warm, seed by position", "1.3 x core + 20 ns a point", "",
           f"{median(warm) / 1e6:.0f} ms, allowed {median(allowed) / 1e6:.0f} ms",
           "yes" if share <= 1 else "**no**"]
    for kind, words, at_least, aim in (
            ("ours-by-id", "by point id", 30, 60), ("ours-by-position", "by position", 12, 35)):
        gain = median(r["bundled"]["first"] / r[kind]["first"] for r in rounds)
        yield row(f"First Update() against the bundled filter, seed {words}", gain, at_least, aim, "x")
    for seed_by, words in (("id", "point id"), ("position", "position")):
        for cells, origin in (("same-cells", "the cells passed on"), ("new-cells", "equal cells, read anew")):
            runs = [r["moving"][seed_by][cells] for r in rounds]
            yield row(f"A step of a bending torus, 200k points, against a warm run: {origin}, seed by {words}",
                      median(run["steps"] / run["warm"] for run in runs), 1.3, 1.15, "x")
    for what, kind, key, at_least, aim in (
            ("held, seed by point id", "ours-by-id", "held", 220, 130),
            ("held, seed by position", "ours-by-position", "held", 320, 180),
            ("highest", "ours-by-position", "peak", 350, 220)):
        yield row(f"Filter's memory, bytes a point: {what}", of(kind, key), at_least, aim)


def rows_of_queries(medians):
    for mesh in medians.meshes("ClosestPoint"):
        build, on, off = (
            medians("ClosestPoint", mesh, key) for key in ("build_ns", "on_surface_us", "in_box_us"))
        yield row(f"Closest point, {mesh}: build, a triangle", build, 300, 100, " ns")
        yield row(f"Closest point, {mesh}: query on the surface", on, 20, 5, " us")
        yield row(f"Closest point, {mesh}: query anywhere in its box", off, 20, 5, " us")
    for mesh in medians.meshes("HundredSeeds"):
        yield row(f"100 seeds against one, {mesh}", medians("HundredSeeds", mesh), 2, 1.3, "x")
    yield row("Growth: a point at 2.6M over one at 160k", medians("Growth", "icosphere 160k"), 1.3, 1.1)
    reached = medians("BoundedQuery", "icosphere 2.6M", "reached")
    query = medians("BoundedQuery", "icosphere 2.6M", "query_us")
    yield row("Within 1 % of the box's diagonal, 2.6M points, warm", query / 1000, 1, 0.1, " ms",
              f" ({reached:.0f} points reached)")


def row_of_threads(run):
    what = f"Two threads for setup, {FILTER_MESH}, by the clock on the wall"
    if run is None:
        return [what, "1.5x", "1.8x", "not measured: there is one core", "-"]
    return row(what, Medians(run)("SetupOnTwoThreads", FILTER_MESH), 1.5, 1.8, "x")


def rows_of_errors(medians):
    for counter, words in (("error_of_largest", "of the largest distance"),
                           ("error_of_own", "of each point's own")):
        for mesh, at_least, aim in (
                ("icosphere 160k", 3.5e-4, 1e-4), ("Delaunay plane 160k", 1e-9, 1e-10),
                ("thin grid 160k", 1e-9, 1e-10), ("Bunny 35k", 2.5e-3, 1.5e-3)):
            yield row(f"Mean error, in parts {words}: {mesh}", medians("Solve", mesh, counter),
                      at_least, aim)
        yield row_without_bounds(f"Mean error, in parts {words}: {MIXED}, edges 1:1000",
                                 medians("Solve", MIXED, counter))


def table_of_meshes(medians):
    def cells(what, mesh, *counters):
        return [number(medians(what, mesh, counter)) for counter in counters]

    return table(
        ["Mesh", "Points", "Dijkstra", "Solve", "in Dijkstra times", "Setup", "in Dijkstra times",
         "Mean error, of largest", "of own"],
        [[mesh, f"{medians('Solve', mesh, 'points'):,.0f}",
          *cells("Solve", mesh, "dijkstra_ns", "solve_ns", "ratio"),
          *cells("Setup", mesh, "setup_ns", "ratio"),
          *cells("Solve", mesh, "error_of_largest", "error_of_own")]
         for mesh in medians.meshes("Solve")])


def table_of_tiers(medians):
    rows = []
    for mesh in medians.meshes("Reference"):
        batched, reference = (medians(what, mesh, "solve_ns") for what in ("Solve", "Reference"))
        rows.append([mesh, number(batched), number(reference), number(reference / batched)])
    return table(["Mesh", "Batched", "Reference", "times as long"], rows)


def table_of_heat(medians):
    return table(
        ["Mesh", "Setup", "Solve", "in Dijkstra times", "Mean error, of largest", "of own"],
        [[mesh, *(number(medians("Heat", mesh, counter)) for counter in
                  ("setup_ns", "solve_ns", "ratio", "error_of_largest", "error_of_own"))]
         for mesh in medians.meshes("Heat")])


def table_of_filters(rounds):
    names = {"ours-by-id": "Geodesic Distance, seed by point id",
             "ours-by-position": "Geodesic Distance, seed by position",
             "bundled": "Bundled GeodesicMeasurement, as shipped (unoptimised)"}
    return table(
        ["Filter", "First Update()", "ns a point", "Bytes a point held", "highest",
         "Mean error, of largest"],
        [[name, f"{median(r[kind]['first'] for r in rounds):.2f} s",
          number(median(1e9 * r[kind]["first"] / r[kind]["points"] for r in rounds)),
          *(number(median(r[kind][key] for r in rounds)) for key in ("held", "peak", "error"))]
         for kind, name in names.items()])


def core_memory(medians):
    held, with_index, peak = (
        medians("Memory", FILTER_MESH, key) for key in ("held", "held_with_index", "peak"))
    return (f"{held:.0f} bytes a point held after a solve, {with_index:.0f} with the closest-point index, "
            f"{peak:.0f} at the highest")


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


def commit():
    """Of these sources; they may have come without git, or belong to somebody else."""
    if not shutil.which("git"):
        return "not known"
    told = subprocess.run(["git", "-C", os.path.dirname(TEMPLATE), "describe", "--always", "--dirty"],
                          capture_output=True, text=True)
    return told.stdout.strip() or "not known"


def version(package):
    return output_of("dpkg-query", "-W", "-f", "${Version}", package)


def processor():
    with open("/proc/cpuinfo") as file:
        return next(line.split(":")[1].strip() for line in file if line.startswith("model name"))


def machine(run):
    context = run["context"]
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    caches = ", ".join(f"L{c['level']} {c['size'] // 1024:,} KiB" for c in context["caches"]
                       if c["type"] != "Instruction")
    return table(["", ""], [
        ["Date", context["date"][:10]],
        ["Commit", commit()],
        ["Processor", f"{processor()}, {context['num_cpus']} cores, {caches}; one is used but for setup on two threads"],
        ["Memory", f"{memory:.0f} GiB"],
        ["Load before the start", ", ".join(f"{load:.2f}" for load in context["load_avg"])],
        ["System", f"{platform.freedesktop_os_release()['PRETTY_NAME']}, Linux {platform.release()}"],
        ["Compiler", f"g++ {output_of('g++', '-dumpfullversion')}, Release: -O3 -DNDEBUG"],
        ["ParaView", version("paraview-dev")],
        ["CGAL, Eigen", f"{version('libcgal-dev')}, {version('libeigen3-dev')}"],
        ["Google Benchmark", version("libbenchmark-dev")],
    ])


def write(found, document):
    medians = Medians(found["core"])
    asked = [*rows_of_solve(medians), *rows_of_filter(found["rounds"]), *rows_of_queries(medians),
             row_of_threads(found["two-threads"]), *rows_of_errors(medians)]
    with open(TEMPLATE) as file:
        template = string.Template(file.read())
    text = template.substitute(
        machine=machine(found["core"]),
        asked=table(["", "At least", "Aim", "Measured", "Holds"], asked),
        meshes=table_of_meshes(medians),
        tiers=table_of_tiers(medians),
        heat=table_of_heat(medians),
        filters=table_of_filters(found["rounds"]),
        core_memory=core_memory(medians))
    with open(document, "w") as file:
        file.write(text)


if __name__ == "__main__":
    with open(sys.argv[1]) as stream:
        write(json.load(stream), sys.argv[2])
