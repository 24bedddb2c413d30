# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A server of several ranks gives its client the fields and paths of one rank, also while a waypoint moves and from a
state file.

usage: WithServer.py MPIEXEC PVSERVER pvpython Server.py URL OUR_PLUGIN FOLDER
After Fields.py and Paths.py with one rank, whose results are compared with.
"""

import os
import sys
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.append(os.path.dirname(__file__))
import cases
import harness

URL, PLUGIN, FOLDER = sys.argv[1:]
host, port = URL.removeprefix("cs://").split(":")
simple.Connect(host, int(port))
assert servermanager.ActiveConnection.GetNumberOfDataPartitions() == 2
simple.LoadPlugin(PLUGIN, remote=True, ns=vars(simple))
harness.load(PLUGIN)


def check_field(distance, case):
    points = servermanager.Fetch(distance).GetPointData()
    found = {points.GetArrayName(i): vtk_to_numpy(points.GetArray(i)) for i in range(points.GetNumberOfArrays())}
    with np.load(os.path.join(FOLDER, f"{case}.reference.npz")) as reference:
        cases.compare(case, [found], dict(reference))
        visited = len(reference["GeodesicDistance"])
    assert harness.informed(distance, "NumberOfVisitedPoints") == visited
    assert harness.informed(distance, "NumberOfRounds") > 1
    assert harness.informed(distance, "BytesExchanged") > 0
    # No rank has the whole of it.
    assert visited / 2 <= harness.informed(distance, "MostPointsOnARank") < 0.6 * visited


for case in ("bunny", "costs"):
    surface, options = cases.FIELDS[case]
    check_field(simple.GeodesicDistance(registrationName=case, Input=harness.surface(surface, "slabs"), **options), case)


def searches_of(path):
    """How many segments a run searches for."""
    path.UpdatePipeline()
    return harness.informed(path, "NumberOfSearches")


torus = harness.surface("torus", "slabs")
path = simple.GeodesicPath(registrationName="path", Input=torus, WaypointPositions=[1.3, 0.2, 0.3, -1.35, 0.1, 0.1])
line = servermanager.Fetch(path)
with np.load(os.path.join(FOLDER, "torus.path.npz")) as reference:
    assert line.GetNumberOfCells() == 1
    assert line.GetNumberOfPoints() == len(reference["points"])
    length = line.GetCellData().GetArray("Length").GetValue(0)
    assert abs(length - reference["Length"][0]) <= 1e-9 * length
    assert abs(harness.informed(path, "TotalLength") - length) <= 1e-12

# There and back, a step at a time.
there = list(path.WaypointPositions)
for step in (0.05, 0.1, 0.05, 0.0):
    path.WaypointPositions = [there[0], there[1] + step, *there[2:]]
    path.UpdatePipeline()
    moved = harness.informed(path, "TotalLength")
    assert (abs(moved - length) <= 1e-9 * length) == (step == 0.0), (step, moved, length)

# Of five segments a moved waypoint costs the two beside it, and what does not change the way none.
points = np.reshape(cases.points_on("torus", 7), (-1, 3))
many = simple.GeodesicPath(registrationName="many", Input=torus, WaypointPositions=points[:6].ravel().tolist())
assert searches_of(many) == 5
points[2] = points[6]
many.WaypointPositions = points[:6].ravel().tolist()
assert searches_of(many) == 2
many.HeightOffset = 0.001
assert searches_of(many) == 0
kept = harness.informed(many, "TotalLength")
new = simple.GeodesicPath(Input=torus, WaypointPositions=points[:6].ravel().tolist())
assert searches_of(new) == 5
assert harness.informed(new, "TotalLength") == kept

with tempfile.TemporaryDirectory() as folder:
    state = os.path.join(folder, "state.pvsm")
    simple.SaveState(state)
    while simple.GetSources():
        simple.Delete(next(iter(simple.GetSources().values())))
    simple.LoadState(state)
check_field(simple.FindSource("costs"), "costs")
path = simple.FindSource("path")
assert list(path.WaypointPositions) == there
path.UpdatePipeline()
assert abs(harness.informed(path, "TotalLength") - length) <= 1e-9 * length
simple.Disconnect()
