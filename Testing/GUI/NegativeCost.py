# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A square with an array Cost that is negative on one half, and the filter, not applied, that has it as its cost."""

from paraview.simple import *

plane = Plane(registrationName="Plane", XResolution=8, YResolution=8)
cost = Calculator(registrationName="Cost", Input=plane, ResultArrayName="Cost", Function="coordsX")
cost.UpdatePipeline()
GetActiveViewOrCreate("RenderView")
distance = GeodesicDistance(registrationName="Distance", Input=cost, SeedPositions=[0, 0, 0], CostArray=["POINTS", "Cost"])
SetActiveSource(distance)
Render()
