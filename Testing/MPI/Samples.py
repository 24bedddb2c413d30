# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Samples on several ranks are those on one rank, however the surface is cut.

usage: mpiexec -n N pvbatch [--sym] Samples.py OUR_PLUGIN FOLDER
The run with one rank leaves the samples in FOLDER that the others are compared with.
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

SAMPLINGS = {
    "bunny": ("bunny", dict(NumberOfSamples=40)),
    "edges": ("torus", dict(NumberOfSamples=60, Method="Dijkstra")),
    "spaced": ("torus", dict(Spacing=0.4)),
    "first": ("torus", dict(NumberOfSamples=30, FirstPositions=[1.3, 0.2, 0.3, -1.35, 0.1, 0.1])),
    "cost": ("torus", dict(NumberOfSamples=30, CostArray=["POINTS", "Cost"])),
    "parts": ("parts", dict(NumberOfSamples=20)),
}


def found(source, options):
    """The first rank's samples, those of the others are empty; each with position and distance."""
    proxy = simple.GeodesicSamples(Input=source, **options)
    assert harness.messages_of(proxy.UpdatePipeline) == ""
    samples = proxy.GetClientSideObject().GetOutputDataObject(0)
    assert harness.IS_FIRST or samples.GetNumberOfPoints() == 0
    radius = harness.informed(proxy, "CoveringRadius")
    rows = np.zeros((0, 5))
    if harness.IS_FIRST:
        distances = vtk_to_numpy(samples.GetPointData().GetArray("GeodesicDistance"))
        places = vtk_to_numpy(samples.GetPoints().GetData())
        rows = np.column_stack([places, distances, np.full(len(places), radius)])
    simple.Delete(proxy)
    return rows


for name, (surface, options) in SAMPLINGS.items():
    # A piece of the Bunny whose triangles lie anywhere takes some hundred rounds for each sample.
    for cut in ("whole", ) if harness.RANKS == 1 else ("slabs", ) if name == "bunny" else ("slabs", "random"):
        rows = found(harness.surface(surface, cut), options)
        file = os.path.join(FOLDER, f"{name}.samples.npy")
        if harness.RANKS == 1:
            np.save(file, rows)
        elif harness.IS_FIRST:
            reference = np.load(file)
            assert reference.shape == rows.shape, (name, cut, reference.shape, rows.shape)
            error = np.abs(reference - rows).max() / np.abs(reference[:, 4]).max()
            print(f"{name:8s} {cut:8s} {error:7.1e}", flush=True)
            assert error <= 1e-9, (name, cut, error)

# Lines as barriers need the surface on one rank.
if harness.RANKS > 1:
    wall = simple.PolyLineSource(Points=[0.03, 0.75, -0.3, 0.02, 0.61, 0, 0.03, 1, 0.4])
    lined = simple.GeodesicSamples(Input=harness.surface("torus", "slabs"), BarrierSource=wall)
    messages = harness.messages_of(lined.UpdatePipeline)
    assert f"it is spread over {harness.RANKS} ranks" in messages and "Aggregate Dataset" in messages, messages
