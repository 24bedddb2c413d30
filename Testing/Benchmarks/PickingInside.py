# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""What PickingBenchmark.py runs in ParaView: a sphere with 1M triangles. The file that SHOWN names is made when it is
drawn."""

import os

from paraview.simple import *

ball = Sphere(registrationName="Ball", ThetaResolution=708, PhiResolution=708)
view = GetActiveViewOrCreate("RenderView")
distance = GeodesicDistance(registrationName="Distance", Input=ball)
view.CameraPosition = [0, 0, 4]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraViewAngle = 20
Show(ball, view)
SetActiveSource(distance)
Render()
open(os.environ["SHOWN"], "w").close()
