# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A server of several ranks gives its client the fields and paths of one rank.

usage: WithServer.py MPIEXEC PVSERVER pvpython Server.py URL OUR_PLUGIN FOLDER
After Fields.py and Paths.py with one rank, whose results are compared with.
"""

import os
import sys

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

for case in ("bunny", "costs"):
    surface, options = cases.FIELDS[case]
    distance = simple.GeodesicDistance(Input=harness.surface(surface, "slabs"), **options)
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

path = simple.GeodesicPath(Input=harness.surface("torus", "slabs"), WaypointPositions=[1.3, 0.2, 0.3, -1.35, 0.1, 0.1])
line = servermanager.Fetch(path)
with np.load(os.path.join(FOLDER, "torus.path.npz")) as reference:
    assert line.GetNumberOfCells() == 1
    assert line.GetNumberOfPoints() == len(reference["points"])
    length = line.GetCellData().GetArray("Length").GetValue(0)
    assert abs(length - reference["Length"][0]) <= 1e-9 * length
    assert abs(harness.informed(path, "TotalLength") - length) <= 1e-12
simple.Disconnect()
