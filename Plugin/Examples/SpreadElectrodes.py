# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Evenly spread electrodes: 64 points over the upper half of a head-like ellipsoid, after three that are given.

usage: pvpython SpreadElectrodes.py SurfaceGeodesics.so FOLDER

Writes Electrodes.csv to FOLDER: the position of each electrode, in the order in which they were taken, and its
distance along the surface from the nearest one before it. The first n of them are evenly spread too.
"""

import os
import sys

from paraview.simple import *

plugin, folder = (os.path.abspath(argument) for argument in sys.argv[1:3])

# ns=globals() makes the plugin's filters functions of this script. The path must be absolute.
LoadPlugin(plugin, remote=False, ns=globals())

# A head of half axes 75, 95 and 90 mm. Below the cap no electrode may be: there the points are a barrier.
sphere = Sphere(Radius=1, ThetaResolution=96, PhiResolution=96)
head = Transform(Input=sphere)
head.Transform.Scale = [75, 95, 90]
marked = Calculator(Input=head, ResultArrayName="BelowCap", Function="coordsZ < -10")

# Those that the others depend on: the vertex, and one before each ear.
given = [0, 0, 90, 75, 0, 0, -75, 0, 0]
electrodes = GeodesicSamples(
    Input=marked, NumberOfSamples=64, FirstPositions=given, BarrierArray=["POINTS", "BelowCap"])
electrodes.UpdatePipeline()

# An error raises nothing in pvpython: the message is on stderr and the output is empty.
if electrodes.GetDataInformation().GetNumberOfPoints() == 0:
    sys.exit("No electrodes: see the message above.")

electrodes.UpdatePropertyInformation()
print(f"No point of the cap is farther than {electrodes.CoveringRadius:.1f} mm from an electrode")
SaveData(os.path.join(folder, "Electrodes.csv"), proxy=electrodes, Precision=6)
print(f"Wrote {folder}/Electrodes.csv")
