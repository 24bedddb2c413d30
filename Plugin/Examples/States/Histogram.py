# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""How many points of a torus lie how far from a seed. ParaView loads this by File > Load State."""

from paraview.simple import *

torus = Superquadric(registrationName="Torus", Toroidal=1, ThetaResolution=80, PhiResolution=80)
distance = GeodesicDistance(registrationName="Distance", Input=torus, SeedPositions=[0.5, 0, 0])
histogram = Histogram(registrationName="Histogram", Input=distance, SelectInputArray=["POINTS", "GeodesicDistance"],
                      BinCount=20)

view = CreateView("XYBarChartView")
Show(histogram, view)
view.BottomAxisTitle = "Distance from the seed"
view.LeftAxisTitle = "Points"
AssignViewToLayout(view)
SetActiveSource(histogram)
