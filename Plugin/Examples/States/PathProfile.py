# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The height of a torus along a path over it, against the path's length. ParaView loads this by File > Load State."""

from paraview.simple import *

strips = Superquadric(registrationName="Strips", Toroidal=1, ThetaResolution=80, PhiResolution=80)
# Resample With Dataset is wrong within triangle strips.
torus = Triangulate(registrationName="Torus", Input=strips)
height = Calculator(registrationName="Height", Input=torus, ResultArrayName="Height", Function="coordsY")
path = GeodesicPath(registrationName="Path", Input=torus,
                    WaypointPositions=[0.5, 0, 0, -0.281, 0.108, 0.335, -0.128, 0.125, -0.352])
profile = ResampleWithDataset(registrationName="Profile", SourceDataArrays=height, DestinationMesh=path,
                              PassPointArrays=1)
plot = PlotData(registrationName="Plot", Input=profile)

view = CreateView("XYChartView")
display = Show(plot, view)
display.UseIndexForXAxis = 0
display.XArrayName = "ArcLength"
display.SeriesVisibility = ["Height"]
view.BottomAxisTitle = "Length along the path"
view.LeftAxisTitle = "Height"
AssignViewToLayout(view)
SetActiveSource(plot)
