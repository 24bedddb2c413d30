# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The worst cases: what the document calls them, what WorstCases is told, and what is asked of them."""

from dataclasses import dataclass
from typing import Callable, Optional


@dataclass
class Bound:
    """What is asked for: its words, and the most that is allowed beside what else was measured."""
    words: str
    value: Callable[[dict], float]


@dataclass
class Asked:
    """The least that is asked for, the aim, and what of a measurement these bound."""
    at_least: Bound
    aim: Bound
    of: Callable[[dict], float]


@dataclass
class Case:
    name: str
    command: list
    asked: Optional[Asked] = None
    # What the time is told for each of as well.
    each: str = ""


def seconds(found):
    return found["seconds"]


def growth_of_errors(found):
    """The worse one of the value that is too small by most and of the mean error."""
    return max(found[error] / found[f"{error}_before"] for error in ("too_small", "mean_error"))


def both(bound, at_least, aim, of=seconds):
    return Asked(bound(*at_least), bound(*aim), of)


def one_seeds(times):
    return Bound(f"{times} S", lambda found: times * found["one_seed"])


def one_seeds_and_segments(times, microseconds):
    return Bound(f"{times} S + {microseconds} us a segment",
                 lambda found: times * found["one_seed"] + 1e-6 * microseconds * found["items"])


def dijkstras(times):
    return Bound(f"{times} D", lambda found: times * found["dijkstra"])


def points_and_seeds(nanoseconds, microseconds):
    return Bound(f"{nanoseconds} ns a reached point + {microseconds} us a seed",
                 lambda found: 1e-9 * nanoseconds * found["reached"] + 1e-6 * microseconds * found["items"])


def one_seeds_and_starts(times, milliseconds):
    return Bound(f"{times} S + {milliseconds} ms a start",
                 lambda found: times * found["one_seed"] + 1e-3 * milliseconds * found["items"])


def edges(mean, largest):
    return f"{mean} and {largest}", {"difference_mean": mean, "difference_largest": largest}


def errors_before(times):
    return Bound(f"{times} times those before", lambda found: times)


SEEDS = {100: (2.5, 1.5), 1000: (4, 2), 10000: (4, 2), 1000000: (2, 1)}
SEGMENTS = both(one_seeds_and_segments, (6, 10), (3, 5))
# To tell the nearest seed may take half as long again; the aim is 15 %.
NUMBERED = both(one_seeds_and_segments, (9, 15), (3.45, 5.75))
SHAPES = both(one_seeds, (3,), (1.5,))
STRIP_PATH = both(one_seeds, (3,), (1,))
STARTS = both(one_seeds_and_starts, (1, 0.1), (1, 0.03))
COSTS = both(dijkstras, (6,), (3,))
# Of the field of many seeds to the least of their single ones: mean and largest.
DIFFERENCE_AT_LEAST = edges(0.05, 0.5)
DIFFERENCE_AIM = edges(0.01, 0.1)
FLAT = {10: (4, 2), 100: (6, 2), 1000: (8, 3)}


def seeds_of(surface):
    for count, (at_least, aim) in SEEDS.items():
        words = "every vertex a seed" if count == 1000000 else f"{count:,} random vertices as seeds"
        yield Case(f"{surface}: {words}", ["seeds", surface, count], both(one_seeds, (at_least,), (aim,)))


def flat(case, surfaces, asked):
    """Asked of the default method; the others are beside it."""
    for surface in surfaces:
        for factor in FLAT:
            for method in ("FastMarching", "VirtualSources", "Exact"):
                yield Case(f"{surface}, {factor}:1, {method}", [case, surface, factor, method],
                           asked(factor) if method == "FastMarching" else None)


def loose(name, arguments):
    """As the filter solves them, and with Compute Nearest Seed."""
    yield Case(name, [*arguments, "loose"], SEGMENTS)
    yield Case(f"{name}, numbered", [*arguments, "numbered"], NUMBERED)


TIMED = {
    "Many seeds": [case for surface in ("hilly grid 40k", "Bunny 35k", "icosphere 160k", "Delaunay plane 160k")
                   for case in seeds_of(surface)],
    "Lines of seeds": [
        *loose("slice through a hilly grid of 100 x 100, loose segments", ["slice", 100]),
        Case("slice through a hilly grid of 200 x 200, one curve", ["slice", 200, "curve"], SEGMENTS),
        *loose("border of a hilly grid of 100 x 100, loose edges", ["border", "hilly grid 10k"]),
        *loose("border of the Bunny, loose edges", ["border", "Bunny 35k"]),
        *loose("contour on a hilly grid, loose segments", ["contour", "hilly grid 160k", 2.2]),
        *loose("10,000 edges at random", ["edges", "hilly grid 160k", 10000]),
        Case("one curve of 100,000 bends that crosses itself", ["wandering-curve", "hilly grid 160k", 100000]),
    ],
    "Shapes and costs": [
        Case("100,000 triangles apart, 5,000 seeds", ["parts", 100000, 5000],
             both(points_and_seeds, (150, 2), (75, 1))),
        Case("hilly grid, random cost", ["cost", "hilly grid 40k", 4, 1], COSTS),
        Case("shaken grid, random cost", ["cost", "shaken grid 40k", 4, 1], COSTS),
        Case("shaken grid, random cost, 100 seeds", ["cost", "shaken grid 40k", 4, 100]),
        Case("fan of 100,000 triangles, from its centre", ["field", "fan 100k", 0], SHAPES),
        Case("fan of 100,000 triangles, path across", ["path", "fan 100k"], SHAPES),
        Case("sphere of 1000 x 1000, from its pole", ["field", "sphere of latitudes 1M", 0], SHAPES),
        Case("sphere of 1000 x 1000, path between sides of its equator", ["path", "sphere of latitudes 1M"], SHAPES),
        Case("strip of 300,000 squares, from its end", ["field", "strip 300k", 0], SHAPES),
        Case("strip of 300,000 squares, path from end to end", ["path", "strip 300k"], STRIP_PATH),
    ],
    "Flattened surfaces": [
        *flat("flat", ["Bunny 35k", "torus 40k", "box with fillets 40k"],
              lambda factor: both(dijkstras, *((n,) for n in FLAT[factor]))),
    ],
    "Much of what a loop runs over": [
        Case("10,000 starts to the nearest of 5 seeds", ["starts", "hilly grid 40k", 10000, 5], STARTS, "start"),
        Case("10,000 starts to the nearest of 10,000 seeds", ["starts", "hilly grid 40k", 10000, 10000], each="start"),
        Case("10,000 waypoints, 20 random edges from one to the next", ["waypoints", "hilly grid 160k", 10000],
             each="waypoint"),
        Case("10,000 seeds in one face", ["seeds-of-one-face", "hilly grid 40k", 10000]),
        Case("100,000 seeds in one face", ["seeds-of-one-face", "hilly grid 40k", 100000]),
        Case("80 seeds in 12 faces of a hilly grid", ["crowd", "hilly grid 40k", 80, 12]),
        Case("80 seeds in 400 faces of a hilly grid", ["crowd", "hilly grid 40k", 80, 400]),
        Case("80 seeds in 12 faces of the Bunny", ["crowd", "Bunny 35k", 80, 12]),
        Case("1,000 seeds in 2,000 faces of a hilly grid", ["crowd", "hilly grid 40k", 1000, 2000]),
        Case("every vertex a target", ["targets", "hilly grid 40k", 40000]),
        Case("100,000 triangles on one edge, path between two", ["path", "pages 100k"]),
        Case("100,000 triangles on one edge, 10,000 random vertices as seeds", ["seeds-on-hub", "pages 100k", 10000]),
    ],
}

ERRORS = [*flat("flat-error", ["Spot 3k", "torus 2k", "box with fillets 2k"],
                lambda factor: both(errors_before, (1.5,), (1,), growth_of_errors))]
