# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A cable over a car body: its length from the battery over bonnet and roof to the rear, past a sunroof.

usage: pvpython CarCable.py SurfaceGeodesics.so FOLDER

Writes Cable.vtp to FOLDER, and prints the length of the cable and what the way round the sunroof adds to it.
"""

import os
import sys

from paraview.simple import *

plugin, folder = (os.path.abspath(argument) for argument in sys.argv[1:3])
LoadPlugin(plugin, remote=False, ns=globals())

# A body 4.2 m long and 1.7 m wide, of one profile: bonnet, windscreen, roof, rear window, boot.
sheet = Plane(Origin=[0, -0.85, 0], Point1=[4.2, -0.85, 0], Point2=[0, 0.85, 0], XResolution=210, YResolution=85)
height = Calculator(
    Input=sheet, ResultArrayName="Height",
    Function="0.7+0.1*coordsX+0.5*max(0,min(1,(coordsX-1.1)/0.7))-0.45*max(0,min(1,(coordsX-3)/0.6))")
body = WarpByScalar(Input=height, Scalars=["POINTS", "Height"], Normal=[0, 0, 1], UseNormal=1)
marked = Calculator(Input=body, ResultArrayName="Sunroof",
                    Function="if((abs(coordsX-2.3)<0.29)*(abs(coordsY)<0.4),1,0)")

# From the battery, over a clip on the bonnet, to the boot; each point is moved to the body.
route = [0.3, -0.5, 0.73, 0.9, -0.2, 0.79, 3.8, 0.1, 1.13]
cable = GeodesicPath(Input=marked, WaypointPositions=route, BarrierArray=["POINTS", "Sunroof"])
straight = GeodesicPath(Input=marked, WaypointPositions=route)
for path in (cable, straight):
    path.UpdatePipeline()
    path.UpdatePropertyInformation()
if cable.GetDataInformation().GetNumberOfPoints() == 0:
    sys.exit("No cable: see the message above.")

print(f"Length of the cable: {cable.TotalLength:.6f} m")
print(f"Without the sunroof: {straight.TotalLength:.6f} m")
SaveData(os.path.join(folder, "Cable.vtp"), proxy=cable, DataMode="Binary")
