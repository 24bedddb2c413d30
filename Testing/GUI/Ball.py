# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A ball seen from z, so that its middle is the view's middle, and the filter, not applied, to pick on it."""

from paraview.simple import *

ball = Sphere(registrationName="Ball", ThetaResolution=32, PhiResolution=32)
view = GetActiveViewOrCreate("RenderView")
Show(ball, view)
view.CameraPosition = [0, 0, 4]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraViewAngle = 20
SetActiveSource(GeodesicDistance(registrationName="Distance", Input=ball))
Render()
