# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every filter on 320,000 points: its progress never falls, a run that is aborted leaves nothing, and the next one is as if
it had not been.

usage: Progress.py OUR_PLUGIN [POINTS_ROUND]
With POINTS_ROUND, the number of points round the sphere, it tells how long each filter is silent at most.
"""

import sys
import time

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import testing

LEAST_REPORTS = 2


def bumpy_sphere(around):
    """An open sphere with bumps, of around by around / 2 points."""
    latitudes = np.linspace(-np.pi / 2, np.pi / 2, around // 2 + 2)[1:-1]
    v, u = np.meshgrid(latitudes, np.linspace(0, 2 * np.pi, around, endpoint=False), indexing="ij")
    radius = 1 + 0.05 * np.sin(5 * u) * np.cos(7 * v)
    positions = np.stack([radius * np.cos(u) * np.cos(v), radius * np.sin(u) * np.cos(v), radius * np.sin(v)], -1)
    rows = np.arange(around // 2 - 1)[:, None] * around
    here = rows + np.arange(around)
    next_one = rows + (np.arange(around) + 1) % around
    triangles = np.concatenate([np.stack(corners, -1).reshape(-1, 3) for corners in (
        (here, next_one, next_one + around), (here, next_one + around, here + around))])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(positions.reshape(-1, 3), deep=True))
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, triangles.size + 1, 3), deep=True),
                  numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


testing.load(sys.argv[1])
AROUND = int(sys.argv[2]) if len(sys.argv) > 2 else 800
SURFACE = bumpy_sphere(AROUND)
LINE = testing.polyline([[0.9, 0.1, 0.1], [0.1, 0.9, 0.3], [-0.9, 0.2, 0.1], [0.0, -0.9, 0.1]], closed=True)
FIELD = simple.GeodesicDistance(Input=SURFACE, SeedPositions=[1, 0, 0])
RUNS = (
    ("GeodesicDistance", dict(SeedPositions=[1, 0, 0])),
    ("GeodesicDistance", dict(SeedPointIds=list(range(0, AROUND * AROUND // 2, 999)), ComputeNearestSeed=1)),
    ("GeodesicDistance", dict(SeedSource=LINE, Signed=1)),
    ("GeodesicDistance", dict(SeedPositions=[0, 0, 1], BarrierSource=LINE)),
    ("GeodesicDistance", dict(SeedPositions=[1, 0, 0], Method="Dijkstra")),
    ("GeodesicDistance", dict(SeedPositions=[1, 0, 0], Method="VirtualSources")),
    ("GeodesicDistance", dict(SeedPositions=[1, 0, 0], Method="Bounded")),
    ("GeodesicDistance", dict(SeedPositions=[1, 0, 0], Method="Exact", UseMaximumDistance=1, MaximumDistance=0.5)),
    ("GeodesicPath", dict(WaypointPositions=[1, 0, 0, -1, 0, 0.1, 0, 0, 1])),
    ("GeodesicPath", dict(WaypointPositions=[1, 0, 0, 0.8, 0.5, 0.1], Method="Exact")),
    ("GeodesicPath", dict(WaypointPositions=[1, 0, 0, -1, 0, 0.1], InterpolationOrder=0)),
    ("GeodesicRegion", dict(Lines=LINE)),
    ("GeodesicDistanceMatrix", dict(LandmarkPositions=[1, 0, 0, -1, 0, 0.1, 0, 0, 1, 0, 1, 0])),
    ("GeodesicSamples", dict(NumberOfSamples=20)),
    ("GeodesicCentre", dict(MaximumNumberOfFields=8)),
    ("GeodesicIsolines", dict(Input=FIELD)),
)


def summary_of(algorithm):
    """What the output has: numbers of things, and the sum of each array."""
    output = algorithm.GetOutputDataObject(0)
    found = [output.GetNumberOfElements(kind) for kind in (0, 1, 6)]
    for kind in (0, 1, 6):
        attributes = output.GetAttributes(kind)
        for i in range(attributes.GetNumberOfArrays() if attributes else 0):
            if attributes.GetArray(i) is not None:
                found.append(float(np.nansum(vtk_to_numpy(attributes.GetArray(i)).astype(float))))
    return found


def run(algorithm, abort_at=None):
    """Updates the filter, which is aborted at a report. Returns the reports' times and progress."""
    reports = [(time.monotonic(), 0.0)]

    def hear(*_):
        reports.append((time.monotonic(), algorithm.GetProgress()))
        algorithm.SetAbortExecute(int(abort_at is not None and len(reports) > abort_at))

    tag = algorithm.AddObserver("ProgressEvent", hear)
    algorithm.Modified()
    algorithm.Update()
    algorithm.RemoveObserver(tag)
    algorithm.SetAbortExecute(0)
    reports.append((time.monotonic(), 1.0))
    return np.array(reports)


FIELD.UpdatePipeline()
for kind, options in RUNS:
    proxy = getattr(simple, kind)(**dict(dict(Input=SURFACE), **options))
    filter_ = proxy.GetClientSideObject()
    name = f"{kind} {', '.join(sorted(option for option in options))} {options.get('Method', '')}"
    reports = run(filter_)
    silence = np.diff(reports[:, 0]).max()
    print(f"{name}: {reports[-1, 0] - reports[0, 0]:.2f} s, {len(reports) - 2} reports, silent for {silence:.3f} s",
          flush=True)
    assert np.all(np.diff(reports[:, 1]) >= 0), (name, reports[:, 1])
    assert len(reports) - 2 >= LEAST_REPORTS, (name, len(reports))
    whole = summary_of(filter_)
    assert whole[0] > 0 or whole[2] > 0, (name, whole)
    for share in (0.2, 0.6):
        simple.Delete(proxy)
        proxy = getattr(simple, kind)(**dict(dict(Input=SURFACE), **options))
        filter_ = proxy.GetClientSideObject()
        aborted = run(filter_, abort_at=max(1, int(share * (len(reports) - 2))))
        left = summary_of(filter_)
        assert left[0] == 0 and left[2] == 0, (name, share, left)
        run(filter_)
        again = summary_of(filter_)
        assert len(again) == len(whole) and np.allclose(again, whole, rtol=1e-9), (name, share, whole, again)
    simple.Delete(proxy)
