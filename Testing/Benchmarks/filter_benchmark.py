# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times and memory of one ParaView filter on an icosphere, in a process of its own.

usage: pvpython filter_benchmark.py RESULT.json LEVELS ours-by-id|ours-by-position OUR_PLUGIN
       pvpython filter_benchmark.py RESULT.json LEVELS bundled BUNDLED_PLUGIN

Writes the processor seconds of the first Update(), of our filter also those of later ones with other seeds; the
bytes a point held after all of them and the most at any time, both beyond what was there before the
first; and the mean error of the first in parts of the largest distance.
"""

import ctypes
import json
import sys
import time

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

WARM_RUNS = 5


def icosphere(levels):
    """Points of the unit sphere and triangles: an icosahedron cut in four again and again."""
    golden = (1 + 5 ** 0.5) / 2
    points = np.array([p for a in (-1, 1) for b in (-golden, golden)
                       for p in ((a, b, 0), (0, a, b), (b, 0, a))])
    # The triangles of an icosahedron are the triples of corners that are an edge of 2 apart.
    near = np.abs(np.linalg.norm(points[:, None] - points[None], axis=2) - 2) < 1e-9
    triangles = np.array([(a, b, c) for a in range(12) for b in range(a) for c in range(b)
                          if near[a, b] and near[b, c] and near[c, a]])
    inward = np.linalg.det(points[triangles]) < 0
    triangles[inward] = triangles[inward, ::-1]
    points /= np.linalg.norm(points, axis=1)[:, None]
    for _ in range(levels):
        sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        edges, middles = np.unique(sides[:, 0] * len(points) + sides[:, 1], return_inverse=True)
        ab, bc, ca = (middles.reshape(-1, 3) + len(points)).T
        a, b, c = triangles.T
        sums = points[edges // len(points)] + points[edges % len(points)]
        points = np.vstack([points, sums / np.linalg.norm(sums, axis=1)[:, None]])
        triangles = np.vstack([np.stack(t, axis=1) for t in
                               ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
    return points, triangles


def polydata(points, triangles):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(triangles.astype(np.int64).ravel(), deep=True))
    data.SetPolys(cells)
    return data


def status(field):
    """A size from /proc/self/status, in bytes."""
    with open("/proc/self/status") as file:
        return next(int(line.split()[1]) * 1024 for line in file if line.startswith(field))


def settled():
    """What the process holds, without what the allocator keeps for later."""
    ctypes.CDLL("libc.so.6").malloc_trim(0)
    return status("VmRSS")


def seconds_of_update(filter):
    """Runs the filter itself; what ParaView gathers about the output afterwards is not part of it."""
    filter.UpdateVTKObjects()
    start = time.process_time()
    filter.GetClientSideObject().Update()
    return time.process_time() - start


def filter_of(kind, source, seed, position):
    if kind == "bundled":
        return simple.FastMarchingGeodesicDistanceFieldFromBinaryField(
            Input=source, SeedsNonZeroField=["POINTS", "Seed"])
    if kind == "ours-by-id":
        return simple.GeodesicDistance(Input=source, SeedPointIds=[seed])
    return simple.GeodesicDistance(Input=source, SeedPositions=position.tolist())


def main(result, levels, kind, plugin):
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    points, triangles = icosphere(int(levels))
    data = polydata(points, triangles)
    seed = len(points) // 3
    flags = numpy_to_vtk((np.arange(len(points)) == seed).astype(float), deep=True)
    flags.SetName("Seed")
    data.GetPointData().AddArray(flags)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    filter = filter_of(kind, source, seed, points[seed])
    filter.UpdateVTKObjects()
    random = np.random.default_rng(1)

    before = settled()
    with open("/proc/self/clear_refs", "w") as file:
        file.write("5")  # The peak counts from here.
    first = seconds_of_update(filter)
    peak = status("VmHWM") - before
    output = filter.GetClientSideObject().GetOutputDataObject(0)
    found = vtk_to_numpy(output.GetPointData().GetArray(
        "DistanceField" if kind == "bundled" else "GeodesicDistance"))
    held = settled() - before
    truth = 2 * np.arcsin(np.minimum(np.linalg.norm(points - points[seed], axis=1) / 2, 1))
    values = {
        "points": len(points),
        "first": first,
        "held": held / len(points),
        "peak": peak / len(points),
        "error": float(np.abs(found - truth).mean() / truth.max()),
    }
    if kind == "ours-by-position":
        values["warm"] = []
        for _ in range(WARM_RUNS):
            filter.SeedPositions = random.normal(size=3).tolist()
            values["warm"].append(seconds_of_update(filter))
    with open(result, "w") as file:
        json.dump(values, file)


if __name__ == "__main__":
    main(*sys.argv[1:])
