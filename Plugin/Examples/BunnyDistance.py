# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Geodesic distance on the Stanford Bunny and a closed path round its neck, as files and as a picture.

usage: pvpython BunnyDistance.py SurfaceGeodesics.so Bunny.vtp FOLDER

Writes BunnyDistance.vtp, BunnyPath.vtp and BunnyDistance.png to FOLDER, and prints how long each step took.
Rendering needs a display; without one: xvfb-run -a pvpython ...
"""

import os
import sys
import time

from paraview.simple import *

plugin, mesh, folder = (os.path.abspath(argument) for argument in sys.argv[1:4])

HAUNCH = [0.000, 0.085, 0.058]
TAIL = [0.059, 0.055, 0.010]
ROUND_THE_NECK = [
    [-0.044, 0.122, 0.040], [-0.070, 0.106, 0.036], [-0.094, 0.118, 0.000], [-0.080, 0.122, -0.040],
    [-0.048, 0.130, -0.020]]


def timed(what, step):
    start = time.perf_counter()
    step()
    print(f"{what}: {time.perf_counter() - start:.3f} s")


# ns=globals() makes the plugin's filters functions of this script. The path must be absolute.
timed("Load the plugin", lambda: LoadPlugin(plugin, remote=False, ns=globals()))

bunny = XMLPolyDataReader(FileName=[mesh])
timed("Read the surface", bunny.UpdatePipeline)

# Seeds are x, y, z of one after the other; each is moved to the nearest point of the surface.
distance = GeodesicDistance(Input=bunny, SeedPositions=TAIL)
timed("First solve", distance.UpdatePipeline)

# The filter keeps what it has learnt about the surface: other seeds are faster.
distance.SeedPositions = HAUNCH
timed("Second solve, another seed", distance.UpdatePipeline)

# An error raises nothing in pvpython: the message is on stderr and the output is empty.
if distance.GetDataInformation().GetNumberOfPoints() == 0:
    sys.exit("No distances: see the message above.")

# Not the default, appended data: with Debian 12's libexpat ParaView can't read those back.
SaveData(os.path.join(folder, "BunnyDistance.vtp"), proxy=distance, DataMode="Binary")

# The shortest paths from waypoint to waypoint and back to the first. The height offset lifts them a little,
# so that the picture shows all of the line.
path = GeodesicPath(
    Input=bunny, WaypointPositions=[x for point in ROUND_THE_NECK for x in point], Closed=1, HeightOffset=0.0003)
timed("Closed path", path.UpdatePipeline)
path.UpdatePropertyInformation()
print(f"Length of the path: {path.TotalLength:.6f}")
SaveData(os.path.join(folder, "BunnyPath.vtp"), proxy=path, DataMode="Binary")

# --- the picture ---

distance.UpdatePropertyInformation()
farthest = distance.MaximumDistanceReached

view = CreateView("RenderView", ViewSize=[1600, 1200])
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
view.UseFXAA = 1
view.KeyLightIntensity = 0.8
view.FillLightKFRatio = 2
view.CameraPosition = [-0.090, 0.160, 0.500]
view.CameraFocalPoint = [0.007, 0.107, 0.000]
view.CameraViewUp = [0, 1, 0]
view.CameraViewAngle = 20.5

# Normals at the points, none split at an edge, make the shading smooth.
# ParaView 5.13 renamed the filter.
normals = SurfaceNormals if "SurfaceNormals" in globals() else GenerateSurfaceNormals
smooth = normals(Input=distance, Splitting=0)
surface = Show(smooth, view)
ColorBy(surface, ("POINTS", "GeodesicDistance"))
surface.Ambient = 0.1
surface.Specular = 0.2

# Near is light and far is dark.
colors = GetColorTransferFunction("GeodesicDistance")
# ParaView 6.1 renamed the preset.
colors.ApplyPreset("Plasma" if GetParaViewVersion() >= (6, 1) else "Plasma (matplotlib)", True)
colors.InvertTransferFunction()
colors.RescaleTransferFunction(0, farthest)

# The spacing is, as the distance, in the unit of length of the surface.
spacing = 0.005
isolines = Contour(
    Input=distance,
    ContourBy=["POINTS", "GeodesicDistance"],
    Isosurfaces=[spacing * i for i in range(1, int(farthest / spacing) + 1)],
)
lines = Show(Tube(Input=isolines, Radius=0.0002, NumberofSides=12), view)
ColorBy(lines, None)
lines.AmbientColor = lines.DiffuseColor = [0.10, 0.05, 0.20]

loop = Show(Tube(Input=path, Radius=0.0009, NumberofSides=16), view)
ColorBy(loop, None)
loop.AmbientColor = loop.DiffuseColor = [0.0, 0.55, 0.35]

marker = Show(Sphere(Center=HAUNCH, Radius=0.0022, ThetaResolution=32, PhiResolution=32), view)
marker.AmbientColor = marker.DiffuseColor = [0.0, 0.35, 0.8]
marker.Specular = 0.5

scale = GetScalarBar(colors, view)
scale.Title = "Geodesic distance"
scale.ComponentTitle = ""
scale.HorizontalTitle = 1
scale.TitleColor = scale.LabelColor = [0, 0, 0]
scale.TitleFontSize = scale.LabelFontSize = 34
scale.WindowLocation = "Any Location"
scale.Position = [0.80, 0.22]
scale.ScalarBarLength = 0.5
scale.ScalarBarThickness = 32
scale.UseCustomLabels = 1
scale.CustomLabels = [0.05 * i for i in range(int(farthest / 0.05) + 1)]
# ParaView 6 writes formats as Python does, those before as C does.
scale.LabelFormat = "{:.2f}" if "{" in scale.LabelFormat else "%.2f"
scale.AutomaticLabelFormat = 0
scale.AddRangeLabels = 0
surface.SetScalarBarVisibility(view, True)

picture = os.path.join(folder, "BunnyDistance.png")
timed("Draw", lambda: SaveScreenshot(picture, view))
print(f"Wrote {folder}/BunnyDistance.vtp and {picture}")
