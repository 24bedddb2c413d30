# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The distance from a triangle on a plane, active."""

from paraview.simple import *

plane = Plane(XResolution=40, YResolution=40)
loop = PolyLineSource(Points=[-0.3, -0.21, 0, 0.31, -0.2, 0, 0.01, 0.3, 0], Closed=1)
distance = GeodesicDistance(Input=plane, SeedSource=loop)
Show(distance)
SetActiveSource(distance)
Render()
