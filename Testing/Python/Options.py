# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every option of GeodesicDistance, alone and combined, on a plane and on the Bunny.

usage: Options.py OUR_PLUGIN
"""

import itertools
import sys

import numpy as np
from paraview import servermanager, simple

import testing

testing.load(sys.argv[1])


def run(surface, **options):
    distance = simple.GeodesicDistance(Input=surface, **options)
    found = testing.array_of(distance).copy()
    simple.Delete(distance)
    return found


def nearest_seed(surface, **options):
    distance = simple.GeodesicDistance(Input=surface, ComputeNearestSeed=1, **options)
    found = testing.array_of(distance, "NearestSeed").copy()
    simple.Delete(distance)
    return found


def expect(name, found, truth, most=1e-6, mean=None):
    """At most this far from the truth, and NaN where it is NaN."""
    error = np.abs(found - truth)
    assert (np.isnan(found) == np.isnan(truth)).all(), name
    assert np.nanmax(error) <= most, (name, np.nanmax(error))
    assert np.nanmean(error) <= (mean or most), (name, np.nanmean(error))


def expect_stopped(name, found, whole, limit):
    """The whole field up to the limit; what equals it to rounding may be reached or not."""
    is_near = np.abs(whole - limit) < 1e-9
    truth = np.where(whole <= limit, whole, np.nan)
    expect(name, np.where(is_near, limit, found), np.where(is_near, limit, truth))


def along_edges(points, cells, starts, cost=None, open_points=None):
    """An oracle for Dijkstra's method: Bellman's equation, iterated over all edges."""
    cost = np.ones(len(points)) if cost is None else cost
    edges = np.unique(np.sort(np.vstack([cells[:, [i, (i + 1) % 3]] for i in range(3)])), axis=0)
    if open_points is not None:
        edges = edges[open_points[edges].all(axis=1)]
    edges = np.vstack([edges, edges[:, ::-1]])
    edges = edges[np.argsort(edges[:, 1], kind="stable")]
    length = np.linalg.norm(np.diff(points[edges].astype(float), axis=1)[:, 0], axis=1)
    weight = length * cost[edges].mean(axis=1)
    ends, first = np.unique(edges[:, 1], return_index=True)
    field = np.full(len(points), np.inf)
    field[starts] = 0
    while True:
        better = np.minimum(field[ends], np.minimum.reduceat(field[edges[:, 0]] + weight, first))
        if (better == field[ends]).all():
            return np.where(np.isfinite(field), field, np.nan)
        field[ends] = better


# --- The square [-0.5, 0.5]^2 ---

N = 40
grid = simple.Triangulate(Input=simple.Plane(XResolution=N, YResolution=N))
points = testing.points_of(grid).astype(float)
cells = testing.cells_of(grid)
centers = points[cells].mean(axis=1)
x, y = points[:, 0], points[:, 1]


def point_at(*xy):
    return int(np.argmin(np.hypot(x - xy[0], y - xy[1])))


def is_in(p, x0, x1, y0, y1):
    return (p[:, 0] > x0 - 1e-6) & (p[:, 0] < x1 + 1e-6) & (p[:, 1] > y0 - 1e-6) & (p[:, 1] < y1 + 1e-6)


# A wall that reaches from (0, -0.2) to the upper border.
WALL = (0, 0.05, -0.2, 1)
BLOCK, OTHER_BLOCK = (-0.4, -0.2, 0.1, 0.3), (-0.4, -0.3, -0.4, -0.3)
plane = testing.with_arrays(
    grid,
    points={
        "two": np.full(len(points), 2.0),
        "half": np.full(len(points), 0.5),
        "one block": is_in(points, *BLOCK),
        "blocks": is_in(points, *BLOCK) + 2 * is_in(points, *OTHER_BLOCK),
        "line": is_in(points, 0, 0, -0.2, 1),
    },
    cells={
        "cell block": is_in(centers, *BLOCK),
        "cell blocks": is_in(centers, *BLOCK) + 2 * is_in(centers, *OTHER_BLOCK),
        "cell wall": is_in(centers, *WALL),
    },
)


def straight(seeds):
    """Distances of straight lines: one row a seed."""
    return np.linalg.norm(points[None, :, :2] - np.asarray(seeds, float)[:, None, :2], axis=2)


def is_hidden(wall, a, b):
    """Whether the wall is between points a and b, arrays of the same shape."""
    low, high = np.zeros(a.shape[:-1]), np.ones(a.shape[:-1])
    for axis, (start, end) in enumerate((wall[:2], wall[2:])):
        step = b[..., axis] - a[..., axis]
        step = np.where(np.abs(step) < 1e-12, 1e-12, step)
        t = np.stack([(start - a[..., axis]) / step, (end - a[..., axis]) / step])
        low, high = np.maximum(low, t.min(axis=0)), np.minimum(high, t.max(axis=0))
    return high - low > 1e-4


def round_wall(wall, seeds):
    """Pythagoras: straight, or by one or both of the wall's lower corners."""
    seeds = np.asarray(seeds, float)[:, None, :2]
    ends = points[None, :, :2]
    corners = [np.array([[[wall[i], wall[2]]]]) for i in (0, 1)]

    def leg(a, b):
        return np.where(is_hidden(wall, *np.broadcast_arrays(a, b)), np.inf, np.linalg.norm(a - b, axis=2))

    ways = [leg(seeds, ends)]
    ways += [leg(seeds, corner) + leg(corner, ends) for corner in corners]
    ways.append(leg(seeds, corners[0]) + (wall[1] - wall[0]) + leg(corners[1], ends))
    return np.min(ways, axis=0)


def spread(x0, x1, y0, y1):
    """The points of the grid in a rectangle or segment: the nearest of it to others are among them."""
    return points[is_in(points, x0, x1, y0, y1), :2]


def selection(kind, ids):
    flat = [number for i in ids for number in (0, int(i))]
    return servermanager.sources.IDSelectionSource(FieldType=kind, IDs=flat)


first, second, third = (-0.213, 0.107), (-0.31, -0.42), (0.3, 0.25)
inside_block = np.flatnonzero(is_in(points, *BLOCK))
cells_of_block = np.flatnonzero(is_in(centers, *BLOCK))
# Its points are the mesh's: a segment from one to the next lies along an edge.
on_edges = testing.polyline([(i / N, -0.3, 0) for i in range(-16, -3)])
bent = testing.polyline(
    [(i / N, -0.3, 0) for i in range(-16, -3)] + [(-0.1, i / N, 0) for i in range(-11, 1)])
BENT = [(-0.4, -0.1, -0.3, -0.3), (-0.1, -0.1, -0.3, 0)]
cloud = simple.PointSource(NumberOfPoints=4, Radius=0.4)

# name: (properties, the points that stand for each seed in the order of their numbers)
SEEDS = {
    "positions": (dict(SeedPositions=[*first, 0.4, *third, 0]), [[first], [third]]),
    "one position": (dict(SeedPositions=[*second, 0]), [[second]]),
    "point ids": (
        dict(SeedPointIds=[point_at(0.2, 0.2), point_at(-0.3, 0)]), [[(0.2, 0.2)], [(-0.3, 0)]]),
    "a source's points": (
        dict(SeedSource=cloud), [[p[:2]] for p in testing.points_of(cloud)]),
    "a polyline": (dict(SeedSource=on_edges), [spread(-0.4, -0.1, -0.3, -0.3)]),
    "a bent polyline": (dict(SeedSource=bent), [np.vstack([spread(*s) for s in BENT])]),
    "array 0/1": (dict(SeedArray=["POINTS", "one block"]), [spread(*BLOCK)]),
    "array 0/1/2": (
        dict(SeedArray=["POINTS", "blocks"]), [spread(*BLOCK), spread(*OTHER_BLOCK)]),
    "cell array 0/1": (dict(SeedArray=["CELLS", "cell block"]), [spread(*BLOCK)]),
    "cell array 0/1/2": (
        dict(SeedArray=["CELLS", "cell blocks"]), [spread(*BLOCK), spread(*OTHER_BLOCK)]),
    "selected points": (dict(SeedSelection=selection("POINT", inside_block)), [spread(*BLOCK)]),
    "selected cells": (dict(SeedSelection=selection("CELL", cells_of_block)), [spread(*BLOCK)]),
    "all kinds": (
        dict(SeedPositions=[*third, 0], SeedPointIds=[point_at(0.4, -0.4)], SeedSource=on_edges,
             SeedArray=["CELLS", "cell blocks"],
             SeedSelection=selection("POINT", [point_at(-0.45, 0.45)])),
        [[third], [(0.4, -0.4)], spread(-0.4, -0.1, -0.3, -0.3), spread(*BLOCK),
         spread(*OTHER_BLOCK), [(-0.45, 0.45)]]),
}
TWO_REGIONS = {"array 0/1/2", "cell array 0/1/2", "all kinds"}
COSTS = {
    "no cost": ({}, 1),
    "cost 2": (dict(CostArray=["POINTS", "two"], CostMode="Cost"), 2),
    "speed 0.5": (dict(CostArray=["POINTS", "half"], CostMode="Speed"), 2),
}
BARRIERS = {
    "no barrier": ({}, straight),
    "a wall": (dict(BarrierArray=["CELLS", "cell wall"]), lambda seeds: round_wall(WALL, seeds)),
}
near, far = (int(np.argmin(np.hypot(*(centers[:, :2] - at).T))) for at in ((-0.2, -0.1), (0.2, 0.4)))


def at_center(cell):
    return centers[cell].tolist()


# name: (properties, the limit for a whole field); a point in a face is reached with its corners
STOPS = {
    "no stop": ({}, lambda whole: np.inf),
    "maximum distance": (dict(UseMaximumDistance=1, MaximumDistance=0.3001), lambda whole: 0.3001),
    "any": (
        dict(DestinationPositions=at_center(near) + at_center(far), DestinationMode="Any"),
        lambda whole: min(whole[cells[near]].max(), whole[cells[far]].max())),
    "all": (
        dict(DestinationPositions=at_center(near) + at_center(far), DestinationMode="All"),
        lambda whole: max(whole[cells[near]].max(), whole[cells[far]].max())),
    "point ids": (dict(DestinationPointIds=[point_at(-0.2, 0)]), lambda whole: whole[point_at(-0.2, 0)]),
    "whichever is first": (
        dict(DestinationPositions=at_center(far), DestinationPointIds=[point_at(-0.2, 0)],
             DestinationMode="All", UseMaximumDistance=1, MaximumDistance=0.4001),
        lambda whole: min(0.4001, max(whole[cells[far]].max(), whole[point_at(-0.2, 0)]))),
}


# Without a wall the seeds' fields are exact, but for the two regions, whose borders are dense seeds: these
# are off by half an edge at most, and by a twentieth of one in the mean. Round its corners they are off by up to an edge, and by
# a fifth of one in the mean: the front is young there and its origin is a guess.
for seeds, cost, barrier in itertools.product(SEEDS, COSTS, BARRIERS):
    options = {**SEEDS[seeds][0], **COSTS[cost][0], **BARRIERS[barrier][0]}
    factor, distances = COSTS[cost][1], BARRIERS[barrier][1]
    of_seeds = factor * np.array([distances(stand_ins).min(axis=0) for stand_ins in SEEDS[seeds][1]])
    is_open = np.isin(np.arange(len(points)), cells[~is_in(centers, *WALL)]) | (barrier == "no barrier")
    truth = np.where(is_open, of_seeds.min(axis=0), np.nan)
    if barrier != "no barrier":
        most, mean = 1.1 * factor / N, 0.2 * factor / N
    elif seeds in TWO_REGIONS:
        most, mean = 0.5 * factor / N, 0.05 * factor / N
    else:
        most, mean = 1e-6, 1e-6
    name = (seeds, cost, barrier)
    whole = run(plane, **options)
    expect(name, whole, truth, most, mean)

    number = nearest_seed(plane, **options)
    assert (of_seeds[number, np.arange(len(points))] <= truth + 2 * most)[is_open].all(), name
    assert (number[~is_open] == -1).all(), name

    # A speed becomes a cost before anything is stopped.
    for stop, (properties, limit) in STOPS.items() if "speed" not in cost else []:
        expect_stopped((*name, stop), run(plane, **options, **properties), whole, limit(whole))

# Exact is exact from all of them, and round the wall's corners. Bounded keeps its promise.
for seeds, barrier in itertools.product(SEEDS, BARRIERS):
    options = {**SEEDS[seeds][0], **BARRIERS[barrier][0]}
    truth = np.min([BARRIERS[barrier][1](stand_ins).min(axis=0) for stand_ins in SEEDS[seeds][1]], axis=0)
    is_open = np.isin(np.arange(len(points)), cells[~is_in(centers, *WALL)]) | (barrier == "no barrier")
    truth = np.where(is_open, truth, np.nan)
    expect(("Exact", seeds, barrier), run(plane, Method="Exact", **options), truth)
    bounded = run(plane, Method="Bounded", Tolerance=0.01, **options)
    assert (np.isnan(bounded) == np.isnan(truth)).all(), (seeds, barrier)
    assert (bounded - truth)[is_open].min() > -1e-6, (seeds, barrier)
    assert (bounded - 1.01 * truth)[is_open].max() < 1e-6, (seeds, barrier)

# Of equally near seeds the one of the smaller number, and the same again in the other order.
binary = simple.Plane(XResolution=8, YResolution=8)
for sign in (1, -1):
    number = nearest_seed(binary, SeedPositions=[sign * 0.25, 0, 0, sign * -0.25, 0, 0])
    np.testing.assert_array_equal(number, sign * testing.points_of(binary)[:, 0] < 0)

# Very many seeds are looked up in an order of their own, and keep their numbers.
shuffled = np.random.default_rng(1).permutation(len(points))
number = nearest_seed(plane, SeedPositions=points[shuffled].ravel().tolist())
np.testing.assert_array_equal(number[shuffled], np.arange(len(points)))

# Along edges, from the points of each seed.
for cost, barrier, stop in itertools.product(
        [None, "x"], [None, "line"], ["no stop", "all", "whichever is first"]):
    rising = 1.5 + x
    surface = testing.with_arrays(plane, points={"x": rising})
    options = dict(Method="Dijkstra", SeedPointIds=[point_at(-0.3, 0)], SeedArray=["POINTS", "blocks"])
    options.update(dict(CostArray=["POINTS", cost]) if cost else {})
    options.update(dict(BarrierArray=["POINTS", "line"]) if barrier else {})
    starts = [point_at(-0.3, 0), *np.flatnonzero(is_in(points, *BLOCK) | is_in(points, *OTHER_BLOCK))]
    truth = along_edges(points, cells, starts, rising if cost else None,
                        ~is_in(points, 0, 0, -0.2, 1) if barrier else None)
    properties, limit = STOPS[stop]
    found = run(surface, **options, **properties)
    expect_stopped(("Dijkstra", cost, barrier, stop), found, truth, limit(truth))

# From inside a face straight to its corners.
ways = [along_edges(points, cells, [corner]) + np.linalg.norm(points[corner] - centers[near])
        for corner in cells[near]]
found = run(plane, Method="Dijkstra", SeedPositions=at_center(near))
expect("Dijkstra from a face", found, np.min(ways, axis=0), 1e-7)

# A line of points that are never entered, as a point array and as a source of lines along edges:
# between the ways round a wall without width and round one that is an edge thicker on all sides.
LINE, THICK_LINE = (0, 0, -0.2, 1), (-1 / N, 1 / N, -0.2 - 1 / N, 1)
on_line = is_in(points, *LINE)
beside = ~is_in(points, -0.5 / N, 0.5 / N, -0.2, 1)
line = testing.polyline([(0, i / N, 0) for i in range(-8, 21)])
for guide in (dict(BarrierArray=["POINTS", "line"]), dict(BarrierSource=line)):
    found = run(plane, SeedPositions=[*second, 0], **guide)
    assert (np.isnan(found) == on_line).all(), guide
    shortest, longest = round_wall(LINE, [second])[0], round_wall(THICK_LINE, [second])[0]
    assert (found >= shortest - 1e-6)[beside].all(), guide
    assert (found <= longest + 1.1 / N)[beside].all(), guide

# Snell's law: the least of all broken lines over the border x = 0 of costs 1 and 3. A triangle has
# the mean of its corners' costs, so that the border is a column of cells and the error falls with it.
source = (-0.3, 0.1)
errors = []
for n in (40, 160):
    fine = simple.Triangulate(Input=simple.Plane(XResolution=n, YResolution=n))
    at = testing.points_of(fine).astype(float)
    surface = testing.with_arrays(fine, points={"cost": np.where(at[:, 0] < 1e-6, 1, 3)})
    borders = np.linspace(-0.5, 0.5, 801)
    to_border = np.hypot(source[0], borders - source[1])
    # From the dearer side the way can lead along the border, at its cheaper side.
    beyond = np.min([a + 3 * np.hypot(at[:, 0], at[:, 1] - b) for a, b in zip(to_border, borders)], axis=0)
    truth = np.where(at[:, 0] < 1e-6, np.hypot(at[:, 0] - source[0], at[:, 1] - source[1]), beyond)
    found = run(surface, SeedPositions=[*source, 0], CostArray=["POINTS", "cost"])
    errors.append(np.mean(np.abs(found - truth)) / truth.max())
assert errors[0] < 1e-2 and errors[1] < 0.35 * errors[0], errors

# --- The Bunny ---

scan = testing.bunny()
points, cells = testing.points_of(scan).astype(float), testing.cells_of(scan)
centers = points[cells].mean(axis=1)
dear = 1.5 + np.sin(100 * points[:, 1])
patch = np.linalg.norm(centers - points[8000], axis=1) < 0.01
in_patch = np.isin(np.arange(len(points)), cells[patch])
bunny = testing.with_arrays(
    scan,
    points={"dear": dear, "fast": 1 / dear, "three": np.full(len(points), 3), "patch": in_patch},
    cells={"patch": patch})
SPOTS = [[0.000, 0.085, 0.058], [0.059, 0.055, 0.010], [-0.05, 0.15, 0.0]]
spots = dict(SeedPositions=np.ravel(SPOTS).tolist())
whole = run(bunny, **spots)

# What no triangle leads to has no distance, and all else has one.
is_used = np.isin(np.arange(len(points)), cells)
assert (np.isnan(whole) == ~is_used).all()

# Several seeds: the least of their fields, and the number of the one that it is of.
singles = np.array([run(bunny, SeedPositions=spot) for spot in SPOTS])
expect("three seeds", whole, singles.min(axis=0), 1e-9)
number = nearest_seed(bunny, **spots)
assert (number[~is_used] == -1).all()
expect("their numbers", np.where(is_used, singles[number, np.arange(len(points))], np.nan), whole, 1e-9)

# Costs.
costs = dict(CostArray=["POINTS", "dear"])
in_costs = run(bunny, **spots, **costs)
expect("cost 3", run(bunny, **spots, CostArray=["POINTS", "three"]), 3 * whole, 1e-9)
expect("speed", run(bunny, **spots, CostArray=["POINTS", "fast"], CostMode="Speed"), in_costs, 1e-9)

# Barriers only lengthen.
around = run(bunny, **spots, BarrierArray=["CELLS", "patch"])
is_closed = ~np.isin(np.arange(len(points)), cells[~patch])
assert (np.isnan(around) == is_closed).all()
assert np.nanmin(around - whole) > -1e-9 and np.nanmax(around - whole) > 1e-3

# A closed polyline along edges, the patch's border, confines the front, and changes nothing inside
# as far as the front has not met it.
edges = {(a, b) for cell in cells[patch] for a, b in zip(cell, np.roll(cell, -1))}
nexts = {a: b for a, b in edges if (b, a) not in edges}
loop = [next(iter(nexts))]
while nexts[loop[-1]] != loop[0]:
    loop.append(nexts[loop[-1]])
assert len(loop) == len(nexts)
within = in_patch & ~np.isin(np.arange(len(points)), loop)
confined = run(bunny, SeedPointIds=[8000], BarrierSource=testing.polyline(points[loop], closed=True))
unconfined = run(bunny, SeedPointIds=[8000])
assert (np.isfinite(confined) == within).all()
is_free = unconfined < 0.8 * unconfined[loop].min()
assert is_free.any()
expect("inside a loop", confined[is_free], unconfined[is_free], 1e-9)

# The same loop as a seed is 0 along all of its edges: the third corner of a face beside an edge is
# not farther than straight through that face.
curve = run(bunny, SeedSource=testing.polyline(points[loop], closed=True))
assert np.abs(curve[loop]).max() < 1e-7
for cell in cells:
    for a, b, c in (cell, np.roll(cell, 1), np.roll(cell, 2)):
        if nexts.get(a) == b or nexts.get(b) == a:
            side = points[b] - points[a]
            t = np.clip((points[c] - points[a]) @ side / (side @ side), 0, 1)
            assert curve[c] <= np.linalg.norm(points[c] - points[a] - t * side) + 1e-7, cell

# Seeds x costs x barriers x stops. A field is at least as long as the straight line at the least
# cost, at most as along the edges (but for 1 %: within a face a cost is its corners' mean), and up
# to a stop it is the whole one.
SCAN_SEEDS = {
    "spots": (spots, None),
    "ids": (dict(SeedPointIds=[100, 20000]), [100, 20000]),
    "patch": (dict(SeedArray=["POINTS", "patch"]), np.flatnonzero(in_patch)),
}
SCAN_COSTS = {"no cost": ({}, np.ones(len(points))), "dear": (costs, dear)}
ears = np.linalg.norm(points - points[np.argmax(points[:, 1])], axis=1) < 0.02
bunny = testing.with_arrays(bunny, points={"ears": ears})
SCAN_BARRIERS = {"no barrier": ({}, None), "ears": (dict(BarrierArray=["POINTS", "ears"]), ~ears)}
target = int(np.argmin(np.linalg.norm(centers - [0.04, 0.07, 0.03], axis=1)))
destination = dict(DestinationPositions=centers[target].tolist(), DestinationMode="All")
for seeds, cost, barrier in itertools.product(SCAN_SEEDS, SCAN_COSTS, SCAN_BARRIERS):
    name = (seeds, cost, barrier)
    options = {**SCAN_SEEDS[seeds][0], **SCAN_COSTS[cost][0], **SCAN_BARRIERS[barrier][0]}
    field = run(bunny, **options)
    for stop, limit in (
            (dict(UseMaximumDistance=1, MaximumDistance=0.0321), 0.0321),
            (destination, field[cells[target]].max()),
            (dict(UseMaximumDistance=1, MaximumDistance=0.0321, **destination),
             min(0.0321, field[cells[target]].max()))):
        expect_stopped((*name, stop), run(bunny, **options, **stop), field, limit)
    starts, per_length = SCAN_SEEDS[seeds][1], SCAN_COSTS[cost][1]
    edges = run(bunny, Method="Dijkstra", **options)
    if starts is not None:
        expect((*name, "Dijkstra"), edges,
               along_edges(points, cells, starts, per_length, SCAN_BARRIERS[barrier][1]), 1e-9)
    if seeds == "ids":
        straight_line = np.min([np.linalg.norm(points - points[s], axis=1) for s in starts], axis=0)
        assert np.nanmin(field - straight_line * per_length[is_used].min()) > -1e-9, name
    assert np.nanmax(field - 1.01 * edges) < 1e-9, name
