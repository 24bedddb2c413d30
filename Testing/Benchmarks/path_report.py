# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the document of the path benchmarks from their results.

usage: path_report.py BUILD_FOLDER/benchmarks/paths/all.json DOCUMENT.md
"""

import json
import os
import string
import sys
from statistics import median

from report import Medians, machine, number, row, row_without_bounds, table

TEMPLATE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "path_benchmarks.md.in")
# Rounding makes a length a few units in the last place shorter than the exact one.
ROUNDING = 1e-12
KINDS = {"ours": "Geodesic Path", "dijkstra": "vtkDijkstraGraphGeodesicPath (unoptimised)",
         "bundled": "Bundled GeodesicMeasurement (unoptimised)"}


class Core(Medians):
    def curved(self):
        return self.meshes("Lengths")

    def flat(self):
        return [mesh for mesh in self.meshes("LengthsFromFaces") if mesh not in self.curved()]

    def large(self):
        return self.meshes("Across")


def surfaces(run):
    """Those that the peers are run on."""
    core = Core(run)
    return [*core.curved(), *core.large()]


def excess(value):
    """Lengths over the exact one as a number, rounding aside."""
    return "0" if abs(value) <= ROUNDING else number(value)


def worst(core, what, meshes, counter):
    mesh = max(meshes, key=lambda m: core(what, m, counter))
    return core(what, mesh, counter), f" ({mesh})"


def rows_of_lengths(core):
    meshes = core.curved()
    for words, counter, at_least, aim in (
            ("straightened: median", "straight_median", 5e-4, 1e-5),
            ("straightened: 95th percentile", "straight_p95", 5e-3, 1e-3),
            ("order 1 before straightening: 95th percentile", "traced_p95", 2e-2, 5e-3)):
        value, note = worst(core, "Lengths", meshes, counter)
        yield row(f"Length beyond exact, {words}, the worst of {len(meshes)}", value, at_least, aim,
                  note=note)
    runs = [(what, m) for what in ("Lengths", "LengthsFromFaces") for m in core.meshes(what)]
    paths, straight, traced = (sum(core(what, m, counter) for what, m in runs)
                               for counter in ("paths", "straight_longer", "traced_longer"))
    yield ["Longer than Dijkstra's path", "never", "", f"{straight:.0f} of {paths:,.0f}",
           "yes" if straight == 0 else "**no**"]
    yield ["The same before straightening", "", "", f"{traced:.0f} of {paths:,.0f}", ""]
    value, note = worst(core, "LengthsFromFaces", core.flat(), "straight_most")
    least = min(core("LengthsFromFaces", m, "straight_least") for m in core.flat())
    yield row(f"Largest relative error on a plane and on what unrolls, the worst of {len(core.flat())}",
              max(value, -least), 1e-9, 1e-12, note=note)
    for what, words in (("ScaledDown", "1e-6"), ("ScaledUp", "1e6")):
        value, note = worst(core, what, meshes, "change")
        yield row_within(f"Largest relative change of a length on a surface scaled by {words}", value,
                         1e-9, note)


def row_within(what, measured, bound, note):
    return [what, number(bound), "", number(measured) + note, "yes" if measured <= bound else "**no**"]


def rows_of_times(core, peers):
    for mesh in core.large():
        for what, words, at_least, aim in (("Query1", "1 %", 0.5, 0.1), ("Query5", "5 %", 5, 1)):
            yield row(f"Warm query, {mesh}, {words} of the box's diagonal",
                      core(what, mesh, "query_ms"), at_least, aim, " ms",
                      f" (the slowest of 20: {number(core(what, mesh, 'slowest_ms'))} ms)")
        yield row(f"Warm query, {mesh}, to the farthest point, in solves of the whole field",
                  core("Across", mesh, "ratio"), 1.0, 0.5)
        yield row_without_bounds(f"Warm query, {mesh}, to a random point, in such solves",
                                 core("Across", mesh, "random_ratio"))
    for mesh in core.meshes("Matrix"):
        # Asked of surfaces of 160k points.
        bounds = (250, 130) if mesh.endswith("160k") else None
        words = f"Matrix of 100 x 100 landmarks, {mesh}, in solves of the whole field"
        note = f" (the marches alone: {number(core('Matrix', mesh, 'marches'))})"
        measured = core("Matrix", mesh)
        yield row(words, measured, *bounds, note=note) if bounds else row_without_bounds(words, measured)
    for mesh in core.large():
        warm = peers["ours"][mesh]
        yield row(f"The whole filter in pvpython, warm, {mesh}, 5 %", 1e3 * median(warm["whole"][1:]), 30,
                  10, " ms", f" (its Update() alone: {number(1e3 * median(warm['update'][1:]))} ms)")


def table_of_curved(core):
    """Each way's median, 95th percentile and most, in the order of the heads."""
    ways = ("straight", "traced", "edges")
    rows = []
    for what, where in (("Lengths", "at vertices"), ("LengthsFromFaces", "in faces")):
        for mesh in core.curved():
            rows.append([mesh, where, *(excess(core(what, mesh, f"{way}_{part}"))
                                        for way in ways for part in ("median", "p95", "most")),
                         number(core(what, mesh, "path_ms")) + " ms"])
    return table(["Surface", "Sources", *(head for way in ("Straightened", "Order 1", "Along edges")
                                          for head in (f"{way}: median", "95 %", "most")), "Time"], rows)


def table_of_flat(core):
    what = "LengthsFromFaces"
    return table(["Surface", "Points", "Straightened: most", "Order 1: 95 %", "most", "Time"],
                 [[mesh, f"{core(what, mesh, 'points'):,.0f}", number(core(what, mesh, "straight_most")),
                   *(excess(core(what, mesh, counter)) for counter in ("traced_p95", "traced_most")),
                   number(core(what, mesh, "path_ms")) + " ms"] for mesh in core.flat()])


def excess_cells(found):
    """Median, 95th percentile, most and how many paths are missing."""
    over = sorted(length / exact - 1 for length, exact in zip(found["length"], found["exact"]) if length)
    if not over:
        return ["-", "-", "-", str(len(found["length"]))]
    at = [over[int(part * (len(over) - 1))] for part in (0.5, 0.95, 1)]
    # Single precision, in which a peer may put its points.
    return [*("0" if abs(value) < 1e-6 else number(value) for value in at),
            str(len(found["length"]) - len(over))]


def table_of_peers(core, peers):
    return table(["Surface", "Filter", "Length beyond exact: median", "95 %", "most", "Paths missing",
                  "Update(), median"],
                 [[mesh, name, *excess_cells(peers[kind][mesh]),
                   number(1e3 * median(t for t in peers[kind][mesh]["update"] if t)) + " ms"]
                  for mesh in core.curved() for kind, name in KINDS.items()])


def table_of_large(core, peers):
    rows = []
    for mesh in core.large():
        ours = peers["ours"][mesh]
        for kind, name in KINDS.items():
            found = peers[kind][mesh]
            there = [i for i, length in enumerate(found["length"]) if length]
            warm = [i for i in there if i > 0]
            if not warm:
                rows.append([mesh, name, *["-"] * 4, str(len(found["length"]))])
                continue
            # Between a pair's own two lengths: what is exact is not known here.
            over = median(found["length"][i] / ours["length"][i] - 1 for i in there)
            rows.append([mesh, name, number(1e3 * found["update"][0]) + " ms",
                         number(1e3 * median(found["update"][i] for i in warm)) + " ms",
                         number(median(found["update"][i] / ours["update"][i] for i in warm)),
                         "-" if kind == "ours" else number(over), str(len(found["length"]) - len(there))])
    return table(["Surface", "Filter", "First Update()", "warm, median", "in times of ours",
                  "Length beyond ours, median", "Paths missing"], rows)


def table_of_exact(core):
    return table(["Surface", "Points", "CGAL: setup for a source", "path", "length beyond exact: most",
                  "Ours: path"],
                 [[mesh, f"{core('Lengths', mesh, 'points'):,.0f}",
                   *(number(core("Exact", mesh, counter)) + " ms" for counter in ("setup_ms", "path_ms")),
                   excess(core("Exact", mesh, "exact_most")),
                   number(core("Exact", mesh, "ours_ms")) + " ms"] for mesh in core.meshes("Exact")])


def write(found, document):
    core = Core(found["core"])
    peers = found["peers"]
    with open(TEMPLATE) as file:
        template = string.Template(file.read())
    text = template.substitute(
        machine=machine(found["core"]),
        asked=table(["", "At least", "Aim", "Measured", "Holds"],
                    [*rows_of_lengths(core), *rows_of_times(core, peers)]),
        curved=table_of_curved(core),
        flat=table_of_flat(core),
        peers=table_of_peers(core, peers),
        large=table_of_large(core, peers),
        exact=table_of_exact(core))
    with open(document, "w") as file:
        file.write(text)


if __name__ == "__main__":
    with open(sys.argv[1]) as stream:
        write(json.load(stream), sys.argv[2])
