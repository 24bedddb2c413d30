# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws signed.png: the signed distance of a closed path on the Bunny, and of an open line with its arrow on a terrain.

usage: pvpython signed.py DATA PICTURE      (needs PV_PLUGIN_CONFIG_FILE)
"""

import os
import sys

from paraview.simple import *

data, picture = sys.argv[1:]
bunny = OpenDataFile(os.path.join(data, "Bunny.vtp"))
neck = GeodesicPath(Input=bunny, Closed=1, WaypointPositions=[
    -0.0807, 0.0717, 0.0138, -0.0633, 0.0807, 0.0433, -0.0413, 0.1057, 0.0399, -0.0307, 0.1260, 0.0136,
    -0.0492, 0.1156, -0.0155, -0.0728, 0.0901, -0.0156])
ground = Plane(Origin=[-3, -2, 0], Point1=[3, -2, 0], Point2=[-3, 2, 0], XResolution=120, YResolution=80)
height = Calculator(Input=ground, Function="coordsX*0.1+coordsY^2*0.3+0.1*sin(3*coordsX)*cos(2*coordsY)",
                    ResultArrayName="Height")
terrain = WarpByScalar(Input=height, Scalars=["POINTS", "Height"], Normal=[0, 0, 1], UseNormal=1)
dam = GeodesicPath(Input=terrain, WaypointPositions=[0.4, -2.5, 1.3, 0.1, 0, 0, 0.4, 2.5, 1.3])
head = Cone(Center=[0.28, 1.25, 0.75], Direction=[0.1, 1, 0.7], Height=0.35, Radius=0.12, Resolution=24)


def scene(surface, line, spacing, reach, camera, focus, up, *more):
    view = CreateRenderView(ViewSize=[620, 400], OrientationAxesVisibility=0)
    distance = GeodesicDistance(Input=surface, SeedSource=line, Signed=1)
    # Each surface has its colours: an array of its own name.
    distance.DistanceArrayName = f"Signed{spacing}"
    display = Show(distance, view, "GeometryRepresentation")
    ColorBy(display, ("POINTS", distance.DistanceArrayName))
    colors = GetColorTransferFunction(distance.DistanceArrayName)
    colors.ApplyPreset("Cool to Warm", True)
    colors.RescaleTransferFunction(-reach, reach)
    display.SetScalarBarVisibility(view, False)
    offsets = Contour(Input=distance, ContourBy=["POINTS", distance.DistanceArrayName],
                      Isosurfaces=[spacing * i for i in range(-12, 13) if i])
    lines = Show(offsets, view, "GeometryRepresentation")
    ColorBy(lines, None)
    lines.AmbientColor = lines.DiffuseColor = [0.25, 0.25, 0.25]
    lines.LineWidth = 2
    lines.RenderLinesAsTubes = 1
    Show(line, view)
    for source in more:
        shown = Show(source, view)
        shown.AmbientColor = shown.DiffuseColor = [0.9, 0.6, 0.0]
    Render(view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = camera, focus, up
    return view


views = [scene(bunny, neck, 0.01, 0.08, [0.1, 0.16, 0.4], [-0.017, 0.1, 0], (0, 1, 0)),
         scene(terrain, dam, 0.25, 3.0, [0, -5.5, 8], [0, 0, 0.4], (0, 1, 0), head)]
layout = CreateLayout("Signed")
layout.SplitHorizontal(0, 1 / 2)
for place, view in zip((1, 2), views):
    AssignViewToLayout(view=view, layout=layout, hint=place)
SaveScreenshot(picture, layout, ImageResolution=[1240, 400])
