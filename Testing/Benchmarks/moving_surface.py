# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times of Geodesic Distance on a surface whose points move, in a process of its own.

usage: pvpython moving_surface.py RESULT.json OUR_PLUGIN id|position [POINTS_ROUND=450]

A torus of POINTS_ROUND^2 points bends in 20 steps. Each step is followed by a warm run, another seed on the same
surface. Writes the processor seconds of all of both: where a step has the cells of the last one, as filters pass them
on, and where it has new ones of the same content, as readers make them; and those of the first Update().
"""

import json
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from filter_benchmark import polydata, seconds_of_update

STEPS = 20


def torus(around):
    """The two angles of each point, and the triangles."""
    i, j = np.meshgrid(np.arange(around), np.arange(around), indexing="ij")
    corner = lambda di, dj: ((i + di) % around * around + (j + dj) % around).ravel()
    triangles = np.vstack([np.stack([corner(0, 0), corner(1, 0), corner(1, 1)], axis=1),
                           np.stack([corner(0, 0), corner(1, 1), corner(0, 1)], axis=1)])
    angles = 2 * np.pi / around * np.stack([i.ravel(), j.ravel()], axis=1)
    return angles, triangles


def positions(angles, time):
    u, v = angles.T
    radius = 1 + 0.05 * np.sin(4 * u + time)
    tube = 0.4 + 0.03 * np.cos(3 * v - time)
    return np.stack([(radius + tube * np.cos(v)) * np.cos(u), (radius + tube * np.cos(v)) * np.sin(u),
                     tube * np.sin(v) + 0.1 * np.sin(2 * u + time)], axis=1)


def moved(data, angles, time, has_new_cells):
    step = vtkPolyData()
    step.ShallowCopy(data)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(positions(angles, time), deep=True))
    step.SetPoints(points)
    if has_new_cells:
        cells = vtkCellArray()
        cells.DeepCopy(data.GetPolys())
        step.SetPolys(cells)
    return step


def main(result, plugin, seed_by, around="450"):
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    angles, triangles = torus(int(around))
    data = polydata(positions(angles, 0.0), triangles)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    filter = simple.GeodesicDistance(Input=producer)
    random = np.random.default_rng(1)
    shown = data

    def choose_seed():
        seed = int(random.integers(len(angles)))
        if seed_by == "id":
            filter.SeedPointIds = [seed]
        else:
            filter.SeedPositions = list(shown.GetPoint(seed))

    choose_seed()
    values = {"points": len(angles), "first": seconds_of_update(filter)}
    for name, has_new_cells in (("same-cells", False), ("new-cells", True)):
        steps, warm = [], []
        for step in range(STEPS + 1):
            shown = moved(data, angles, 0.2 * step + 0.1, has_new_cells)
            producer.GetClientSideObject().SetOutput(shown)
            choose_seed()
            steps.append(seconds_of_update(filter))
            choose_seed()
            warm.append(seconds_of_update(filter))
        # The first step makes what all later ones use.
        values[name] = {"first": steps[0], "steps": sum(steps[1:]), "warm": sum(warm[1:])}
    with open(result, "w") as file:
        json.dump(values, file)


if __name__ == "__main__":
    main(*sys.argv[1:])
