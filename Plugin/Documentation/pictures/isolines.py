# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws isolines.png: curves round a seed on a coarse sphere, by Contour and by Geodesic Isolines.

usage: pvpython isolines.py DATA PICTURE      (needs PV_PLUGIN_CONFIG_FILE)
"""

import sys

from paraview.simple import *

picture = sys.argv[2]
ball = Sphere(ThetaResolution=14, PhiResolution=11)
distance = GeodesicDistance(Input=ball, SeedPositions=[0.04, 0.1, 0.5])
LEVELS = [0.035, 0.1, 0.2, 0.3]


def scene(curves):
    view = CreateRenderView(ViewSize=[420, 400], OrientationAxesVisibility=0)
    surface = Show(distance, view, "GeometryRepresentation")
    surface.SetRepresentationType("Surface With Edges")
    ColorBy(surface, None)
    surface.AmbientColor = surface.DiffuseColor = [0.66, 0.72, 0.78]
    surface.EdgeColor = [0.45, 0.5, 0.55]
    surface.Interpolation = "Flat"
    lines = Show(curves, view, "GeometryRepresentation")
    ColorBy(lines, None)
    lines.AmbientColor = lines.DiffuseColor = [0.75, 0.2, 0.15]
    lines.LineWidth = 3
    lines.RenderLinesAsTubes = 1
    Render(view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.1, 0.25, 1.75], [0.02, 0.05, 0.4], (0, 1, 0)
    return view


views = [scene(Contour(Input=distance, ContourBy=["POINTS", "GeodesicDistance"], Isosurfaces=LEVELS)),
         scene(GeodesicIsolines(Input=distance, DistanceArray=["POINTS", "GeodesicDistance"], Values=LEVELS))]
layout = CreateLayout("Isolines")
layout.SplitHorizontal(0, 1 / 2)
for place, view in zip((1, 2), views):
    AssignViewToLayout(view=view, layout=layout, hint=place)
SaveScreenshot(picture, layout, ImageResolution=[840, 400])
