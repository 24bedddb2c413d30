# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws one of the pictures of the guide's tasks: two or three views beside each other.

usage: pvpython tasks.py DATA PICTURE      (needs PV_PLUGIN_CONFIG_FILE)
The name of PICTURE says which: curves.png, costs.png, barriers.png, blocks.png, methods.png or plots.png.
"""

import os
import sys

from paraview.simple import *

data, picture = sys.argv[1:]
NECK = [-0.0807, 0.0717, 0.0138, -0.0633, 0.0807, 0.0433, -0.0413, 0.1057, 0.0399,
        -0.0307, 0.1260, 0.0136, -0.0492, 0.1156, -0.0155, -0.0728, 0.0901, -0.0156]
BUNNY_SIDE = [0.1, 0.16, 0.4], [-0.017, 0.1, 0], [0, 1, 0]
ABOVE = [0, 0, 2], [0, 0, 0], [0, 1, 0]


def opened(name):
    return OpenDataFile(os.path.join(data, name))


def scene(camera, surface, array=None, lines=(), bands=16, up_to=None):
    """A view of a surface, coloured by an array in bands, and of lines on it."""
    view = CreateRenderView(ViewSize=[420, 400], OrientationAxesVisibility=0)
    display = Show(surface, view, "GeometryRepresentation")
    if array:
        ColorBy(display, ("POINTS", array), separate=True)
        colors = GetColorTransferFunction(array, display, separate=True)
        low, high = surface.PointData[array].GetRange()
        colors.RescaleTransferFunction(low, up_to or high)
        colors.NanColor = [0.8, 0.8, 0.8]
        colors.Discretize, colors.NumberOfTableValues = 1, bands
        display.SetScalarBarVisibility(view, False)
    else:
        display.ColorArrayName = ["POINTS", ""]
    for line in lines:
        shown = Show(line, view, "GeometryRepresentation")
        shown.ColorArrayName = ["POINTS", ""]
        shown.AmbientColor = shown.DiffuseColor = [0.85, 0.1, 0.1]
        shown.LineWidth = 4
        shown.RenderLinesAsTubes = 1
    Render(view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = camera
    return view


def distance(surface, **properties):
    filter = GeodesicDistance(Input=surface, **properties)
    filter.UpdatePipeline()
    return filter


def curves():
    bunny = opened("Bunny.vtp")
    cut = Slice(Input=bunny)
    cut.SliceType.Origin, cut.SliceType.Normal = [0, 0.11, 0], [0, 1, 0]
    half = Clip(Input=Sphere(ThetaResolution=64, PhiResolution=64))
    half.ClipType.Normal = [0, 0, -1]
    dome = ExtractSurface(Input=half)
    rim = FeatureEdges(Input=dome, BoundaryEdges=1, FeatureEdges=0, NonManifoldEdges=0)
    return [scene(BUNNY_SIDE, distance(bunny, SeedSource=cut), "GeodesicDistance", [cut]),
            scene(([0, -2, 1.2], [0, 0, 0.2], [0, 0, 1]), distance(dome, SeedSource=rim), "GeodesicDistance", [rim])]


def costs():
    plane = Plane(XResolution=100, YResolution=100)
    hill = Calculator(Input=plane, ResultArrayName="Cost", Function="1 + 4 * exp(-20 * (coordsX^2 + coordsY^2))")
    hill.UpdatePipeline()
    ends = [-0.4, -0.1, 0, 0.4, -0.1, 0]
    return [scene(ABOVE, plane, None, [GeodesicPath(Input=plane, WaypointPositions=ends, HeightOffset=0.01)]),
            scene(ABOVE, hill, "Cost", [GeodesicPath(
                Input=hill, WaypointPositions=ends, CostArray=["POINTS", "Cost"], HeightOffset=0.01)])]


def barriers():
    plane = Plane(XResolution=50, YResolution=50)
    wall = PolyLineSource(Points=[0, -0.5, 0, 0, 0.3, 0])
    bunny = opened("Bunny.vtp")
    loop = GeodesicPath(Input=bunny, WaypointPositions=NECK, Closed=1)
    head = distance(bunny, SeedPositions=[-0.0755, 0.1245, 0.052], BarrierSource=loop)
    return [scene(ABOVE, distance(plane, SeedPositions=[-0.3, -0.3, 0], BarrierSource=wall), "GeodesicDistance",
                  [wall]),
            scene(BUNNY_SIDE, head, "GeodesicDistance", [loop])]


def blocks():
    sphere = Sphere(ThetaResolution=64, PhiResolution=64)
    halves = []
    for side in (1, -1):
        clip = Clip(Input=sphere)
        clip.ClipType.Normal = [side, 0, 0]
        halves.append(ExtractSurface(Input=clip))
    both = GroupDatasets(Input=halves)
    camera = [0.6, -2, 0.6], [0, 0, 0], [0, 0, 1]
    return [scene(camera, distance(both, SeedPositions=[0.35, -0.35, 0], ConnectBlocks=connect), "GeodesicDistance")
            for connect in (1, 0)]


def methods():
    sphere = Sphere(ThetaResolution=48, PhiResolution=48)
    exact = distance(sphere, SeedPositions=[0.1, -0.45, 0.2], Method="Exact", DistanceArrayName="Exact")
    camera = [-0.6, -2, 0.9], [0, 0, 0], [0, 0, 1]
    errors = []
    for method in ("FastMarching", "Dijkstra"):
        other = distance(exact, SeedPositions=[0.1, -0.45, 0.2], Method=method, DistanceArrayName="Other")
        error = Calculator(Input=other, ResultArrayName="Error", Function="abs(Other - Exact)")
        error.UpdatePipeline()
        errors.append(error)
    largest = max(error.PointData["Error"].GetRange()[1] for error in errors)
    return [scene(camera, error, "Error", bands=256, up_to=largest) for error in errors]


def plots():
    spot = opened("Spot.vtp")
    height = Calculator(Input=spot, ResultArrayName="Height", Function="coordsY")
    path = GeodesicPath(Input=spot, WaypointPositions=[0.13, 0.2, 0.6, 0.29, 0.45, -0.49])
    profile = CreateView("XYChartView", ViewSize=[420, 400], LeftAxisTitle="Height", BottomAxisTitle="ArcLength")
    display = Show(PlotData(Input=ResampleWithDataset(
        SourceDataArrays=height, DestinationMesh=path, PassPointArrays=1)), profile)
    display.UseIndexForXAxis, display.XArrayName, display.SeriesVisibility = 0, "ArcLength", ["Height"]
    bars = CreateView("XYBarChartView", ViewSize=[420, 400], LeftAxisTitle="Points", BottomAxisTitle="GeodesicDistance")
    Show(Histogram(Input=distance(spot, SeedPositions=[0, 0.3, 0.7]),
                   SelectInputArray=["POINTS", "GeodesicDistance"], BinCount=20), bars)
    return [profile, bars]


draw = {task.__name__: task for task in (curves, costs, barriers, blocks, methods, plots)}
views = draw[os.path.splitext(os.path.basename(picture))[0]]()
layout = CreateLayout("Tasks")
for place, view in enumerate(views, start=1):
    if place == 1:
        layout.SplitHorizontal(0, 1 / 2)
    AssignViewToLayout(view=view, layout=layout, hint=place)
SaveScreenshot(picture, layout, ImageResolution=[840, 400])
