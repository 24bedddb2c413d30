# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A closed path through three waypoints on a torus. ParaView loads this by File > Load State."""

from paraview.simple import *

torus = Superquadric(registrationName="Torus", Toroidal=1, ThetaResolution=80, PhiResolution=80)
path = GeodesicPath(registrationName="Path", Input=torus, Closed=1,
                    WaypointPositions=[0.5, 0, 0, -0.281, 0.108, 0.335, -0.128, 0.125, -0.352])

view = GetActiveViewOrCreate("RenderView")
Show(torus, view)
Show(path, view)
view.CameraPosition = [1.5, 2.2, 2.4]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
ResetCamera(view)
SetActiveSource(path)
