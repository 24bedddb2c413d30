# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances from two seeds on a torus. ParaView loads this by File > Load State."""

from paraview.simple import *

torus = Superquadric(registrationName="Torus", Toroidal=1, ThetaResolution=80, PhiResolution=80)
distance = GeodesicDistance(registrationName="Distance", Input=torus, SeedPositions=[0.5, 0, 0, -0.281, 0.108, 0.335])

view = GetActiveViewOrCreate("RenderView")
display = Show(distance, view)
ColorBy(display, ("POINTS", "GeodesicDistance"))
display.RescaleTransferFunctionToDataRange()
display.SetScalarBarVisibility(view, True)
view.CameraPosition = [1.5, 2.2, 2.4]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
ResetCamera(view)
SetActiveSource(distance)
