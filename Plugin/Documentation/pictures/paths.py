# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws paths.png: paths as a script's Show gives them, on Spot, on a plane and on the Bunny from behind.

usage: pvpython paths.py DATA PICTURE [--before]      (needs PV_PLUGIN_CONFIG_FILE)
With --before they are drawn as ParaView draws lines by itself.
"""

import os
import sys

from paraview.simple import *

data, picture, *before = sys.argv[1:]


def scene(surface, waypoints, camera, focus, up=(0, 1, 0)):
    """A view of a closed path on a surface."""
    view = CreateRenderView(ViewSize=[420, 400], OrientationAxesVisibility=0)
    Show(surface, view)
    path = GeodesicPath(Input=surface, WaypointPositions=waypoints, Closed=1)
    Show(path, view, *["GeometryRepresentation"] * len(before))
    Render(view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = camera, focus, up
    return view


def opened(name):
    return OpenDataFile(os.path.join(data, name))


views = [
    scene(opened("Spot.vtp"), [0.13, 0.2, 0.6, 0.29, 0.45, -0.49, 0.37, -0.05, 0.12], [3.4, 1.6, -2.8], [0, 0.1, 0.1]),
    scene(Plane(XResolution=10, YResolution=10), [-0.3, -0.3, 0, 0.35, -0.1, 0, 0, 0.35, 0], [0.5, -1.6, 1.6], [0, 0, 0]),
    scene(opened("Bunny.vtp"), [-0.06, 0.15, -0.03, 0.02, 0.06, -0.04, -0.08, 0.05, -0.02], [0.05, 0.2, -0.42],
          [-0.02, 0.1, 0])]
layout = CreateLayout("Paths")
for place, view in zip((1, 5, 6), views):
    if place == 1:
        layout.SplitHorizontal(0, 1 / 3)
        layout.SplitHorizontal(2, 1 / 2)
    AssignViewToLayout(view=view, layout=layout, hint=place)
SaveScreenshot(picture, layout, ImageResolution=[1260, 400])
