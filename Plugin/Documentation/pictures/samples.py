# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws samples.png: samples on the Bunny with their regions, and samples that are denser where a cost is high.

usage: pvpython samples.py DATA PICTURE      (needs PV_PLUGIN_CONFIG_FILE)
"""

import os
import sys

from paraview.simple import *

data, picture = sys.argv[1:]
bunny = OpenDataFile(os.path.join(data, "Bunny.vtp"))


def scene(samples, scalars, preset):
    """A view of samples as balls on the surface, coloured by an array."""
    view = CreateRenderView(ViewSize=[420, 400], OrientationAxesVisibility=0)
    surface = Show(OutputPort(samples, 1), view, "GeometryRepresentation")
    ColorBy(surface, ("POINTS", scalars), separate=True)
    colors = GetColorTransferFunction(scalars, surface, separate=True)
    colors.ApplyPreset(preset, True)
    # Points that no face uses have -1.
    colors.RescaleTransferFunction(0, OutputPort(samples, 1).PointData[scalars].GetRange()[1])
    surface.SetScalarBarVisibility(view, False)
    balls = Glyph(Input=OutputPort(samples, 0), GlyphType="Sphere", ScaleFactor=0.004, GlyphMode="All Points",
                  ScaleArray=["POINTS", "No scale array"], OrientationArray=["POINTS", "No orientation array"])
    display = Show(balls, view, "GeometryRepresentation")
    ColorBy(display, None)
    display.AmbientColor = display.DiffuseColor = [0.1, 0.1, 0.1]
    Render(view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [-0.02, 0.16, 0.42], [-0.017, 0.1, 0], (0, 1, 0)
    return view


dear = Calculator(Input=bunny, ResultArrayName="Cost", Function="1 + 4 * (coordsY > 0.11)")
views = [scene(GeodesicSamples(Input=bunny, NumberOfSamples=64), "NearestSeed", "Rainbow Uniform"),
         scene(GeodesicSamples(Input=bunny, NumberOfSamples=300), "GeodesicDistance", "Cool to Warm"),
         scene(GeodesicSamples(Input=dear, NumberOfSamples=300, CostArray=["POINTS", "Cost"]), "Cost", "Cool to Warm")]
layout = CreateLayout("Samples")
for place, view in zip((1, 5, 6), views):
    if place == 1:
        layout.SplitHorizontal(0, 1 / 3)
        layout.SplitHorizontal(2, 1 / 2)
    AssignViewToLayout(view=view, layout=layout, hint=place)
SaveScreenshot(picture, layout, ImageResolution=[1260, 400])
