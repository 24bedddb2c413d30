# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Geodesic distance on an ellipsoid with mean curvature as cost: paths through flat parts are cheap.

usage: pvpython CurvatureCost.py SurfaceGeodesics.so FOLDER

Writes CurvatureCost.vtp to FOLDER, with the arrays Mean_Curvature, Cost and GeodesicDistance.
"""

import os
import sys

from paraview.simple import *

plugin, folder = (os.path.abspath(argument) for argument in sys.argv[1:3])

# ns=globals() makes the plugin's filters functions of this script. The path must be absolute.
LoadPlugin(plugin, remote=False, ns=globals())

# An ellipsoid with the half axes 1, 0.7 and 0.5.
sphere = Sphere(Radius=1, ThetaResolution=128, PhiResolution=128)
ellipsoid = Transform(Input=sphere)
ellipsoid.Transform.Scale = [1, 0.7, 0.5]

# Mean curvature can be negative, by the side that the surface shows and on saddles, and 0 where it
# is flat; a cost must be positive. So: its absolute value, plus a small constant.
curvature = Curvature(Input=ellipsoid, CurvatureType="Mean")
cost = Calculator(Input=curvature, ResultArrayName="Cost", Function="abs(Mean_Curvature) + 0.01")

distance = GeodesicDistance(
    Input=cost, SeedPositions=[1, 0, 0], CostArray=["POINTS", "Cost"], CostMode="Cost")
distance.UpdatePipeline()

# An error raises nothing in pvpython: the message is on stderr and the output is empty.
if distance.GetDataInformation().GetNumberOfPoints() == 0:
    sys.exit("No distances: see the message above.")

# Binary: what ParaView writes by default (appended), Debian 12 cannot read back.
SaveData(os.path.join(folder, "CurvatureCost.vtp"), proxy=distance, DataMode="Binary")
print(f"Wrote {folder}/CurvatureCost.vtp")
