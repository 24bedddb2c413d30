# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A plane seen from z, and a path of three waypoints on it, not applied: 0.8 to the right, then 0.6 up."""

from paraview.simple import *

plane = Plane(registrationName="Plane", XResolution=8, YResolution=8)
view = GetActiveViewOrCreate("RenderView")
Show(plane, view)
view.CameraPosition = [0, 0, 3]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
SetActiveSource(GeodesicPath(registrationName="Path", Input=plane, WaypointPositions=[-0.4, -0.3, 0, 0.4, -0.3, 0, 0.4, 0.3, 0]))
Render()
