# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parcels of a folded surface by seeds: each point belongs to the seed that is nearest along the folds.

usage: pvpython CortexParcels.py SurfaceGeodesics.so FOLDER

Writes Parcels.vtp to FOLDER, with NearestSeed at each point, and Parcels.csv: the area of each seed's parcel and the
largest distance in it.
"""

import csv
import os
import sys

from paraview.simple import *

plugin, folder = (os.path.abspath(argument) for argument in sys.argv[1:3])
LoadPlugin(plugin, remote=False, ns=globals())

# A ball of 60 mm with folds some 6 mm deep, in place of a cortex.
ball = Sphere(Radius=60, ThetaResolution=180, PhiResolution=180)
depth = Calculator(Input=ball, ResultArrayName="Depth", Function="6*sin(coordsX/5)*sin(coordsY/5)*cos(coordsZ/6)")
cortex = WarpByScalar(Input=depth, Scalars=["POINTS", "Depth"])

seeds = [60, 0, 0, -60, 0, 0, 0, 60, 0, 0, -60, 0, 0, 0, 60, 0, 0, -60, 35, 35, 35]
count = len(seeds) // 3
distance = GeodesicDistance(Input=cortex, SeedPositions=seeds, ComputeNearestSeed=1)
distance.UpdatePipeline()
if distance.GetDataInformation().GetNumberOfPoints() == 0:
    sys.exit("No parcels: see the message above.")

# A parcel's share of each point, 0 or 1. Its integral is the area; between points it goes down evenly.
shares = distance
for seed in range(count):
    shares = Calculator(Input=shares, ResultArrayName=f"Share{seed}", Function=f"if(NearestSeed=={seed},1,0)")
    shares = Calculator(Input=shares, ResultArrayName=f"Far{seed}", Function=f"GeodesicDistance*Share{seed}")
areas = IntegrateVariables(Input=shares)
areas.UpdatePipeline()
shares.UpdatePipeline()

with open(os.path.join(folder, "Parcels.csv"), "w", newline="", encoding="utf-8") as file:
    table = csv.writer(file)
    table.writerow(["Seed", "Area", "LargestDistance"])
    for seed in range(count):
        area = areas.PointData[f"Share{seed}"].GetRange()[0]
        farthest = shares.PointData[f"Far{seed}"].GetRange()[1]
        table.writerow([seed, area, farthest])
        print(f"Parcel {seed}: {area:.0f} mm2, no point farther than {farthest:.1f} mm from its seed")
SaveData(os.path.join(folder, "Parcels.vtp"), proxy=distance, DataMode="Binary")
