# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws centre.png: the Bunny coloured by the distance from its centre, and the path between its two points farthest apart.

usage: pvpython centre.py DATA PICTURE      (needs PV_PLUGIN_CONFIG_FILE)
"""

import os
import sys

from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

data, picture = sys.argv[1:]
bunny = OpenDataFile(os.path.join(data, "Bunny.vtp"))
found = servermanager.Fetch(GeodesicCentre(Input=bunny))
center, *farthest = vtk_to_numpy(found.GetPoints().GetData()).astype(float)
# From behind, where the centre is.
CAMERA = [0.16, 0.12, -0.4]
RADIUS = found.GetPointData().GetArray("Radius").GetValue(0)


def ball(position, color, view):
    display = Show(Sphere(Center=position.tolist(), Radius=0.004, ThetaResolution=24, PhiResolution=24), view)
    display.AmbientColor = display.DiffuseColor = color


def scene(surface, camera, up_to=None):
    view = CreateRenderView(ViewSize=[420, 400], OrientationAxesVisibility=0)
    display = Show(surface, view, "GeometryRepresentation")
    if up_to:
        ColorBy(display, ("POINTS", "GeodesicDistance"))
        colors = GetColorTransferFunction("GeodesicDistance")
        colors.RescaleTransferFunction(0, up_to)
        colors.Discretize, colors.NumberOfTableValues = 1, 12
        display.SetScalarBarVisibility(view, False)
    else:
        display.ColorArrayName = ["POINTS", ""]
    Render(view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = camera, [-0.017, 0.1, 0], [0, 1, 0]
    return view


field = GeodesicDistance(Input=bunny, SeedPositions=center.tolist())
path = GeodesicPath(Input=bunny, WaypointPositions=[x for point in farthest for x in point], Method="Exact")
views = [scene(field, CAMERA, RADIUS), scene(bunny, CAMERA)]
ball(center, [0.1, 0.1, 0.1], views[0])
for position in farthest:
    ball(position, [0.85, 0.1, 0.1], views[1])
Show(path, views[1])
layout = CreateLayout("Centre")
layout.SplitHorizontal(0, 1 / 2)
for place, view in zip((1, 2), views):
    AssignViewToLayout(view=view, layout=layout, hint=place)
SaveScreenshot(picture, layout, ImageResolution=[840, 400])
