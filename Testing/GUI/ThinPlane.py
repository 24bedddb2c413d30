# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The distance on a plane of thin triangles, active and not applied."""

from paraview.simple import *

plane = Plane(Point1=[0.5, -0.5, 0], Point2=[-0.5, -0.49, 0], XResolution=20, YResolution=20)
distance = GeodesicDistance(registrationName="Distance", Input=plane, SeedPositions=[0, -0.495, 0])
SetActiveSource(distance)
