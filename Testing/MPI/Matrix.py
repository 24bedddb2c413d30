# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A distance matrix on several ranks is that on one rank, however the surface is cut.

usage: mpiexec -n N pvbatch [--sym] Matrix.py OUR_PLUGIN FOLDER
The run with one rank leaves the tables in FOLDER that the others are compared with.
"""

import os
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.append(os.path.dirname(__file__))
import cases
import harness

PLUGIN, FOLDER = sys.argv[1:]
os.makedirs(FOLDER, exist_ok=True)
harness.load(PLUGIN)

ON_TORUS = [1.3, 0.2, 0.3, -1.35, 0.1, 0.1, 0.2, -1.3, 0.1]
WALL = simple.PolyLineSource(Points=[0.03, 0.75, -0.3, 0.02, 0.61, 0, 0.03, 1, 0.4])
# Inside of the torus, below ridges where planes of its points meet: the places on both sides of a ridge are as near.
TURNS = np.radians(np.arange(0, 360, 30))
BELOW_RIDGES = np.stack([1.3 * np.cos(TURNS), 1.3 * np.sin(TURNS), 0 * TURNS + 0.2], -1).ravel().tolist()
MATRICES = {
    "bunny": ("bunny", dict(LandmarkPositions=cases.points_on("bunny", 5))),
    "edges": ("bunny", dict(LandmarkPositions=cases.points_on("bunny", 4), Method="Dijkstra")),
    "sets": ("torus", dict(LandmarkPositions=ON_TORUS, SecondLandmarkPositions=[1.4, 0, 0, 0, 1.3, 0.2])),
    "equal": ("torus", dict(LandmarkPositions=ON_TORUS[:3] * 2 + ON_TORUS[3:])),
    "ridges": ("torus", dict(LandmarkPositions=ON_TORUS[:3], SecondLandmarkPositions=BELOW_RIDGES)),
    "line": ("torus", dict(LandmarkPositions=ON_TORUS, BarrierSource=WALL)),
    "parts": ("parts", dict(LandmarkPositions=[0.3, 0.2, 0, 6.3, 5.2, 0, 0.3, 0.2, 5])),
}


def found(source, options):
    """The first rank's table; those of the others are empty."""
    proxy = simple.GeodesicDistanceMatrix(Input=source, **options)
    assert harness.messages_of(proxy.UpdatePipeline) == ""
    table = proxy.GetClientSideObject().GetOutputDataObject(0)
    assert harness.IS_FIRST or table.GetNumberOfColumns() == 0
    columns = [np.array(vtk_to_numpy(table.GetColumn(i))) for i in range(1, table.GetNumberOfColumns())]
    unjoined = harness.informed(proxy, "NumberOfUnjoinedPairs")
    simple.Delete(proxy)
    return np.array(columns), unjoined


for name, (surface, options) in MATRICES.items():
    for cut in ("whole", ) if harness.RANKS == 1 else ("slabs", "random"):
        lengths, unjoined = found(harness.surface(surface, cut), options)
        assert unjoined == (2 if name == "parts" else 0), (name, unjoined)
        file = os.path.join(FOLDER, f"{name}.matrix.npy")
        if harness.RANKS == 1:
            np.save(file, lengths)
        elif harness.IS_FIRST:
            reference = np.load(file)
            assert np.array_equal(np.isnan(reference), np.isnan(lengths)), (name, cut, reference, lengths)
            error = np.nanmax(np.abs(reference - lengths)) / np.nanmax(reference)
            print(f"{name:8s} {cut:8s} {error:7.1e}", flush=True)
            assert error <= 1e-9, (name, cut, error)
