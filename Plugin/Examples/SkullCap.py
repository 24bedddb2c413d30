# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A cut cap: a closed path through picked points round the Bunny's head, and the piece above it, cut exactly along it.

usage: pvpython SkullCap.py SurfaceGeodesics.so Bunny.vtp FOLDER

Writes SkullCap.vtp to FOLDER, and prints the area of the cap and the length of its rim.
"""

import os
import sys

from paraview.simple import *

plugin, mesh, folder = (os.path.abspath(argument) for argument in sys.argv[1:4])
LoadPlugin(plugin, remote=False, ns=globals())

bunny = XMLPolyDataReader(FileName=[mesh])
rim = GeodesicPath(Input=bunny, Closed=1, WaypointPositions=[
    -0.0807, 0.0717, 0.0138, -0.0633, 0.0807, 0.0433, -0.0413, 0.1057, 0.0399, -0.0307, 0.1260, 0.0136,
    -0.0492, 0.1156, -0.0155, -0.0728, 0.0901, -0.0156])
cap = GeodesicRegion(Input=bunny, Lines=rim, InsidePositions=[-0.0755, 0.1245, 0.052], Extract="Inside")
cap.UpdatePipeline()
if cap.GetDataInformation().GetNumberOfPoints() == 0:
    sys.exit("No cap: see the message above.")
rim.UpdatePropertyInformation()
cap.UpdatePropertyInformation()
print(f"Area of the cap: {cap.RegionAreas[0]:.8f}")
print(f"Rim of the cap: {cap.RegionPerimeters[0]:.8f}, the path: {rim.TotalLength:.8f}")
SaveData(os.path.join(folder, "SkullCap.vtp"), proxy=cap, DataMode="Binary")
