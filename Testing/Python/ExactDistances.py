# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every option of GeodesicDistance, alone and combined, against CGAL's exact distances; once set by
Python and once more read from a state file. The cost is 1 throughout.

usage: ExactDistances.py OUR_PLUGIN EXACT_FIELD

A surface's truth comes from the program EXACT_FIELD, a row of distances for each seed. What is
closed by a barrier is left out of the surface that the program gets.
"""

import itertools
import os
import subprocess
import sys
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

import testing

PLUGIN, EXACT_FIELD = sys.argv[1:]
testing.load(PLUGIN)
folder = tempfile.TemporaryDirectory()


class Scene:
    """A surface in a file and what the tables need of it."""

    def __init__(self, name, source, seeds, targets, wall, radius, step, limit, tolerances):
        """Seeds: four spots; targets: two; radius: of patches round spots; step: where lines lead;
        tolerances: largest and mean, relative, without and with a barrier."""
        self.name, self.limit, self.tolerances = name, limit, tolerances
        self.points = testing.points_of(source).astype(float)
        self.cells = testing.cells_of(source)
        edges = np.vstack([self.cells[:, [i, (i + 1) % 3]] for i in range(3)])
        self.edges = np.unique(np.sort(edges), axis=0)
        self.seeds = [self.nearest_point(spot) for spot in seeds]
        self.seed_cell = self.cell_at(self.seeds[0])
        self.target_cells = [self.cell_at(self.nearest_point(spot)) for spot in targets]
        self.patch = self.points_near(self.seeds[2], radius)
        self.patch_cells = self.patch[self.cells].all(axis=1)
        wall = self.nearest_point(wall)
        self.wall = self.points_near(wall, 2 * radius)
        self.wall_cells = self.wall[self.cells].all(axis=1)
        self.seed_line = self.walk(self.seeds[3], step)
        self.wall_line = self.walk(wall, step)
        file = os.path.join(folder.name, f"{name}.vtp")
        simple.SaveData(file, DataMode="Binary", proxy=testing.with_arrays(
            source,
            points={"one": np.ones(len(self.points)), "patch": self.patch, "wall": self.wall},
            cells={"patch": self.patch_cells, "wall": self.wall_cells}))
        self.reader = simple.XMLPolyDataReader(registrationName=name, FileName=file)
        self.rows = {}

    def is_wanted(self, seed, barrier, other):
        """On the plane all is combined; on the Bunny, where a row takes seconds, a part of it."""
        return self.name == "plane" or seed == "position" or barrier == "none" and (
            seed == "all kinds" or other in ("no stop", "all of these"))

    def nearest_point(self, spot):
        is_used = np.isin(np.arange(len(self.points)), self.cells)
        return int(np.argmin(np.where(is_used, np.linalg.norm(self.points - spot, axis=1), np.inf)))

    def points_near(self, point, radius):
        return np.linalg.norm(self.points - self.points[point], axis=1) < radius

    def cell_at(self, point):
        return int(np.flatnonzero((self.cells == point).any(axis=1))[0])

    def center(self, cell):
        return self.points[self.cells[cell]].mean(axis=0)

    def walk(self, point, step):
        """Points along edges, 8 times on to the neighbour that is nearest to the direction of the step."""
        way = [point]
        for _ in range(8):
            ends = self.edges[(self.edges == way[-1]).any(axis=1)]
            ends = ends[ends != way[-1]]
            ahead = self.points[ends] - self.points[way[-1]]
            way.append(int(ends[np.argmax(ahead @ step / np.linalg.norm(ahead, axis=1))]))
        return way

    def on_edges(self, edges):
        """Points that stand for these edges: among them are, on a square grid, the feet of all others."""
        a, b = self.points[edges[:, 0]], self.points[edges[:, 1]]
        return np.vstack([a + t * (b - a) for t in np.linspace(0, 1, 5)])

    def open_cells(self, barrier):
        """The cells that the front can cross, by the barrier's name."""
        if barrier == "cells":
            return ~self.wall_cells
        closed = {"none": [], "points": np.flatnonzero(self.wall), "line": self.wall_line}[barrier]
        return ~np.isin(self.cells, closed).any(axis=1)

    def solve(self, wanted):
        """Asks for the rows of all (barrier, stand-ins of a seed): one program a barrier, side by side."""
        programs = []
        for barrier, group in itertools.groupby(sorted(wanted), key=lambda key: key[0]):
            keys = list(group)
            mesh = os.path.join(folder.name, f"{self.name}-{barrier}.off")
            cells = self.cells[self.open_cells(barrier)]
            with open(mesh, "w") as off:
                print("OFF", len(self.points), len(cells), 0, file=off)
                np.savetxt(off, self.points, "%.17g")
                np.savetxt(off, np.insert(cells, 0, 3, axis=1), "%d")
            seeds, rows = f"{mesh}.seeds", f"{mesh}.rows"
            with open(seeds, "w") as out:
                for _, positions in keys:
                    print(*positions, file=out)
            programs.append((keys, rows, subprocess.Popen(
                [EXACT_FIELD, mesh], stdin=open(seeds), stdout=open(rows, "w"))))
        for keys, rows, program in programs:
            assert program.wait() == 0
            found = np.loadtxt(rows, ndmin=2)
            self.rows.update(zip(keys, np.where(found < 0, np.inf, found)))


def flat(positions):
    return tuple(np.ravel(positions).tolist())


def cloud(name, positions):
    """A source of points without lines."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(np.array(positions), deep=True))
    file = os.path.join(folder.name, f"{name}.vtp")
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    simple.SaveData(file, proxy=source, DataMode="Binary")
    return simple.XMLPolyDataReader(FileName=file)


def selection(kind, ids):
    """A source of a selection; the state file keeps it as the filter's input."""
    return simple.IDSelectionSource(FieldType=kind, IDs=[n for i in ids for n in (0, int(i))])


def seeds_of(scene):
    """{name: (properties, the positions that stand for each seed in the order of their numbers)}"""
    at = scene.points
    first, second, third, _ = scene.seeds
    in_face = scene.center(scene.seed_cell)
    along_line = scene.on_edges(np.column_stack([scene.seed_line[:-1], scene.seed_line[1:]]))
    is_in_patch = np.isin(scene.edges, scene.cells[scene.patch_cells]).all(axis=1)
    all_patch = scene.on_edges(scene.edges[is_in_patch])
    positions = dict(SeedPositions=flat(in_face))
    ids = dict(SeedPointIds=[second, third])
    line = dict(SeedSource=testing.polyline(at[scene.seed_line]))
    cells = dict(SeedArray=["CELLS", "patch"])
    point = dict(SeedSelection=selection("POINT", [second]))
    return {
        "position": (positions, [in_face]),
        "point ids": (ids, [at[second], at[third]]),
        "a source's points": (
            dict(SeedSource=cloud(scene.name + "-cloud", at[[third, second]])), [at[third], at[second]]),
        "a line": (line, [along_line]),
        "points of an array": (dict(SeedArray=["POINTS", "patch"]), [all_patch]),
        "cells of an array": (cells, [all_patch]),
        "selected points": (point, [at[second]]),
        "selected cells": (
            dict(SeedSelection=selection("CELL", np.flatnonzero(scene.patch_cells))), [all_patch]),
        "all kinds": (
            {**positions, **ids, **line, **cells, **point},
            [in_face, at[second], at[third], along_line, all_patch, at[second]]),
    }


def barriers_of(scene):
    """{name of what is closed: properties}"""
    return {
        "none": {},
        "cells": dict(BarrierArray=["CELLS", "wall"]),
        "points": dict(BarrierArray=["POINTS", "wall"]),
        "line": dict(BarrierSource=testing.polyline(scene.points[scene.wall_line])),
    }


def others_of(scene):
    """{name: (properties, the distance in a field at which its front stops)}"""
    cells = scene.cells[scene.target_cells]
    point = int(cells[0, 0])
    in_faces = dict(DestinationPositions=flat([scene.center(cell) for cell in scene.target_cells]))
    maximum = dict(UseMaximumDistance=1, MaximumDistance=scene.limit)
    return {
        "no stop": ({}, lambda field: np.inf),
        "maximum distance": (maximum, lambda field: scene.limit),
        "any destination": (
            dict(DestinationMode="Any", **in_faces), lambda field: field[cells].max(axis=1).min()),
        "all destinations": (
            dict(DestinationMode="All", **in_faces), lambda field: field[cells].max()),
        "a destination point": (dict(DestinationPointIds=[point]), lambda field: field[point]),
        "all of these": (
            dict(DestinationMode="All", DestinationPointIds=[point], **in_faces, **maximum),
            lambda field: min(scene.limit, max(field[cells].max(), field[point]))),
        "cost 1": (dict(CostArray=["POINTS", "one"]), lambda field: np.inf),
        "speed 1": (dict(CostArray=["POINTS", "one"], CostMode="Speed"), lambda field: np.inf),
    }


def check(name, scene, barrier, rows, limit, field, number):
    """The field and its seeds' numbers against the rows of exact distances, one a seed."""
    truth = rows.min(axis=0)
    largest = truth[np.isfinite(truth)].max()
    most, mean = largest * np.array(scene.tolerances[barrier != "none"])
    stop = limit(truth)
    is_near = truth < stop - most
    assert (np.isnan(field) == (number == -1)).all(), name
    assert np.isfinite(field[is_near]).all(), name
    assert np.isnan(field[(truth > stop + most) | np.isinf(truth)]).all(), name
    error = np.abs(field - truth)[is_near]
    assert error.max() <= most and error.mean() <= mean, (name, error.max(), error.mean(), largest)
    of_number = rows[number[is_near], np.flatnonzero(is_near)]
    assert (of_number <= truth[is_near] + 2 * most).all(), name


plane = simple.Calculator(  # with points of double precision
    Input=simple.Triangulate(Input=simple.Plane(XResolution=20, YResolution=20)),
    CoordinateResults=1, Function="coords")
# On the plane exact, but round a barrier off by up to an edge, and by a fifth of one in the mean. First
# order on the Bunny, where a barrier costs another half of an edge in the mean.
SCENES = (
    Scene("plane", plane, seeds=[(-0.3, -0.3, 0), (0.3, 0.25, 0), (-0.25, 0.3, 0), (0.4, -0.4, 0)],
          targets=[(-0.1, -0.35, 0), (0.1, 0.4, 0)], wall=(0, 0, 0), radius=0.08, step=(0, 1, 0), limit=0.3001,
          tolerances=((1e-9, 1e-9), (5e-2, 1e-2))),
    # The truth of a row on all of the Bunny's points takes half a minute.
    Scene("Bunny", simple.Decimate(Input=testing.bunny(), TargetReduction=0.78, PreserveTopology=1),
          seeds=[(0, 0.085, 0.058), (0.059, 0.055, 0.01), (-0.05, 0.15, 0), (-0.06, 0.12, 0.04)],
          targets=[(-0.03, 0.05, 0.05), (-0.07, 0.13, 0.03)], wall=(-0.02, 0.11, 0.04), radius=0.006, step=(0, 1, 0), limit=0.0502,
          tolerances=((2.5e-2, 4e-3), (2.5e-2, 7e-3))),
)

cases = {}
for scene in SCENES:
    seeds, barriers, others = seeds_of(scene), barriers_of(scene), others_of(scene)
    for seed, barrier, other in itertools.product(seeds, barriers, others):
        if not scene.is_wanted(seed, barrier, other):
            continue
        properties, positions = seeds[seed]
        keys = [(barrier, flat(p)) for p in positions]
        name = f"{scene.name}: {seed}, barrier {barrier}, {other}"
        cases[name] = (scene, keys, others[other][1])
        simple.GeodesicDistance(registrationName=name, Input=scene.reader, ComputeNearestSeed=1,
                                **properties, **barriers[barrier], **others[other][0])
for scene in SCENES:
    scene.solve({key for owner, keys, _ in cases.values() if owner is scene for key in keys})


def check_all():
    for name, (scene, keys, limit) in cases.items():
        distance = simple.FindSource(name)
        field, number = (testing.array_of(distance, array) for array in ("GeodesicDistance", "NearestSeed"))
        check(name, scene, keys[0][0], np.array([scene.rows[key] for key in keys]), limit, field, number)


check_all()
state = os.path.join(folder.name, "cases.pvsm")
simple.SaveState(state)
simple.ResetSession()
testing.load(PLUGIN)
assert simple.FindSource(next(iter(cases))) is None
simple.LoadState(state)
check_all()
