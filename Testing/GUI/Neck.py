# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Bunny seen from the side, and a closed path round its neck, which is the active source."""

import os

import checks
from paraview.simple import *

data = os.path.join(os.path.dirname(checks.__file__), "..", "Data")
bunny = OpenDataFile(os.path.join(data, "Bunny.vtp"))
view = GetActiveViewOrCreate("RenderView")
Show(bunny, view)
neck = GeodesicPath(registrationName="Neck", Input=bunny, Closed=1, WaypointPositions=[
    -0.0807, 0.0717, 0.0138, -0.0633, 0.0807, 0.0433, -0.0413, 0.1057, 0.0399, -0.0307, 0.1260, 0.0136,
    -0.0492, 0.1156, -0.0155, -0.0728, 0.0901, -0.0156])
Show(neck, view)
view.CameraPosition = [-0.07, 0.16, 0.35]
view.CameraFocalPoint = [-0.07, 0.15, 0.0]
view.CameraViewUp = [0, 1, 0]
SetActiveSource(neck)
Render()
