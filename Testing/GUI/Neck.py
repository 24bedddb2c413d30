# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Bunny seen from the side, and a closed path round its neck, which is the active source."""

import os

from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Data")
bunny = OpenDataFile(os.path.join(data, "Bunny.vtp"))
view = GetActiveViewOrCreate("RenderView")
Show(bunny, view)
neck = GeodesicPath(registrationName="Neck", Input=bunny, Closed=1, WaypointPositions=[
    -0.05, 0.115, 0.035, -0.088, 0.105, 0.0, -0.06, 0.115, -0.03, -0.02, 0.128, -0.005])
Show(neck, view)
view.CameraPosition = [-0.07, 0.16, 0.35]
view.CameraFocalPoint = [-0.07, 0.15, 0.0]
view.CameraViewUp = [0, 1, 0]
SetActiveSource(neck)
Render()
