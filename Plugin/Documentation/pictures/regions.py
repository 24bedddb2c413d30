# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws regions.png: a closed path round the Bunny's neck, the two regions, the head alone, and its edges at the cut.

usage: pvpython regions.py DATA PICTURE      (needs PV_PLUGIN_CONFIG_FILE)
"""

import os
import sys

from paraview.simple import *

data, picture = sys.argv[1:]
bunny = OpenDataFile(os.path.join(data, "Bunny.vtp"))
neck = GeodesicPath(Input=bunny, Closed=1, WaypointPositions=[
    -0.0807, 0.0717, 0.0138, -0.0633, 0.0807, 0.0433, -0.0413, 0.1057, 0.0399, -0.0307, 0.1260, 0.0136,
    -0.0492, 0.1156, -0.0155, -0.0728, 0.0901, -0.0156])
NOSE = [-0.0755, 0.1245, 0.052]
SIDE = [0.1, 0.16, 0.4], [-0.017, 0.1, 0]


def scene(camera, focus, *shown):
    """A view of sources, drawn in these ways."""
    view = CreateRenderView(ViewSize=[420, 400], OrientationAxesVisibility=0)
    for source, representation in shown:
        display = Show(source, view, *([] if source is neck else ["GeometryRepresentation"]))
        if source is not neck:
            display.SetRepresentationType(representation)
            ColorBy(display, ("CELLS", "GeodesicRegion"))
            colors = GetColorTransferFunction("GeodesicRegion")
            colors.RGBPoints = [0, 0.90, 0.60, 0.0, 1, 0.55, 0.63, 0.70]
            display.EdgeColor = [0.2, 0.2, 0.2]
            HideScalarBarIfNotNeeded(colors, view)
            display.SetScalarBarVisibility(view, False)
    Render(view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = camera, focus, (0, 1, 0)
    return view


whole = GeodesicRegion(Input=bunny, Lines=neck, InsidePositions=NOSE)
head = GeodesicRegion(Input=bunny, Lines=neck, InsidePositions=NOSE, Extract="Inside")
views = [
    scene(*SIDE, (whole, "Surface"), (neck, "")),
    scene([0.12, 0.02, 0.3], [-0.055, 0.125, 0.01], (head, "Surface")),
    scene([-0.03, 0.11, 0.105], [-0.044, 0.103, 0.04], (whole, "Surface With Edges"))]
layout = CreateLayout("Regions")
for place, view in zip((1, 5, 6), views):
    if place == 1:
        layout.SplitHorizontal(0, 1 / 3)
        layout.SplitHorizontal(2, 1 / 2)
    AssignViewToLayout(view=view, layout=layout, hint=place)
SaveScreenshot(picture, layout, ImageResolution=[1260, 400])
