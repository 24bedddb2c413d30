# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A dam line on terrain: the signed distance over the ground to it, and the lines half a unit up and down the valley.

usage: pvpython DamLine.py SurfaceGeodesics.so FOLDER

Writes DamDistance.vtp and DamOffsets.vtp to FOLDER.
"""

import os
import sys

from paraview.simple import *

if __name__ == "__main__":
    LoadPlugin(os.path.abspath(sys.argv[1]), remote=False, ns=globals())
else:
    # The plugin is loaded: its filters are in paraview.simple.
    import paraview.simple
    GeodesicDistance, GeodesicPath = paraview.simple.GeodesicDistance, paraview.simple.GeodesicPath

# A valley along x between two slopes, with hills.
ground = Plane(Origin=[-3, -2, 0], Point1=[3, -2, 0], Point2=[-3, 2, 0], XResolution=120, YResolution=80)
height = Calculator(Input=ground, Function="coordsX*0.1+coordsY^2*0.3+0.1*sin(3*coordsX)*cos(2*coordsY)",
                    ResultArrayName="Height")
terrain = WarpByScalar(Input=height, Scalars=["POINTS", "Height"], Normal=[0, 0, 1], UseNormal=1)

# Over the ground from border to border through the dam's middle. Both ends are beyond the border, so that their
# nearest points are on it.
dam = GeodesicPath(Input=terrain, WaypointPositions=[0.4, -2.5, 1.3, 0.1, 0, 0, 0.4, 2.5, 1.3])

# Seen from above, the line runs towards larger y: on its left, towards smaller x, the distance is positive.
distance = GeodesicDistance(Input=terrain, SeedSource=dam, Signed=1)
offsets = Contour(Input=distance, ContourBy=["POINTS", "GeodesicDistance"], Isosurfaces=[-0.5, 0.5])

if __name__ == "__main__":
    folder = os.path.abspath(sys.argv[2])
    SaveData(os.path.join(folder, "DamDistance.vtp"), proxy=distance, DataMode="Binary")
    SaveData(os.path.join(folder, "DamOffsets.vtp"), proxy=offsets, DataMode="Binary")
