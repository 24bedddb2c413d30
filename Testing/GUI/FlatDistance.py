# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A square of side 1 seen from z without light, and the filter, not applied, with a seed at its lower left corner: the
distances are those from the corner."""

from paraview.simple import *

plane = Plane(registrationName="Plane", XResolution=100, YResolution=100)
view = GetActiveViewOrCreate("RenderView")
view.CameraPosition = [0, 0, 3]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
distance = GeodesicDistance(registrationName="Distance", Input=plane, SeedPositions=[-0.5, -0.5, 0])
SetActiveSource(distance)
Render()
