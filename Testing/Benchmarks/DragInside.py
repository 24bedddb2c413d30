# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""What DragBenchmark.py runs in ParaView: a wavy square of so many points, a filter on it with a point in the middle of
the view, and a log of what the filter and the view do. Environment: KIND (distance or path), POINTS, LOG."""

import os
import time

from paraview.simple import *

side = round(int(os.environ["POINTS"]) ** 0.5)
square = ProgrammableSource(registrationName="Square", OutputDataSetType="vtkPolyData", Script=f"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
side = {side}
x, y = np.meshgrid(np.linspace(-1, 1, side), np.linspace(-1, 1, side))
z = 0.1 * np.cos(4 * x) * np.cos(4 * y)
points = vtkPoints()
points.SetData(numpy_to_vtk(np.column_stack([x.ravel(), y.ravel(), z.ravel()]), deep=1))
first = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
corners = np.concatenate([np.column_stack([first, first + 1, first + side]),
                          np.column_stack([first + 1, first + side + 1, first + side])])
triangles = vtkCellArray()
triangles.SetData(3, numpy_to_vtkIdTypeArray(corners.ravel(), deep=1))
self.GetPolyDataOutput().SetPoints(points)
self.GetPolyDataOutput().SetPolys(triangles)
""")
view = GetActiveViewOrCreate("RenderView")
view.CameraPosition = [0, 0, 6.1]
view.CameraFocalPoint = [0, 0, 0.1]
view.CameraViewUp = [0, 1, 0]
view.CameraViewAngle = 20
if os.environ["KIND"] == "distance":
    result = GeodesicDistance(registrationName="Result", Input=square, SeedPositions=[0, 0, 0.1])
else:
    result = GeodesicPath(registrationName="Result", Input=square, WaypointPositions=[-0.8, -0.8, 0, 0, 0, 0.1])
    Show(square, view)
Show(result, view)
SetActiveSource(result)
log = open(os.environ["LOG"], "w", buffering=1, encoding="utf-8")


def note(event):
    """Logs an event, when it was, and what processor time ParaView has taken until then."""
    return lambda *_: log.write(f"{event} {time.perf_counter()} {time.process_time()}\n")


algorithm = result.GetClientSideObject()
algorithm.AddObserver("StartEvent", note("solve"))
algorithm.AddObserver("EndEvent", note("solved"))
Render()
