# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Seeds and lines that move with time on a surface at rest: keyframes of an animation, and sources with time steps.

usage: Time.py OUR_PLUGIN
"""

import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import testing

TIMES = (0.0, 1.0, 2.0, 3.0)
# On a plane of 1 by 1, from its left side to its right one.
PLACE = "-0.4 + 0.8 * time / 3"
INFORMATION = f"""
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
information = self.GetOutputInformation(0)
for time in {TIMES}:
    information.Append(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), time)
information.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), {[TIMES[0], TIMES[-1]]}, 2)
"""
SCRIPT = f"""
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
time = self.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
points = vtkPoints()
for y in HEIGHTS:
    points.InsertNextPoint({PLACE}, y, 0)
output = self.GetPolyDataOutput()
output.SetPoints(points)
if len(HEIGHTS) > 1:
    lines = vtkCellArray()
    lines.InsertNextCell(len(HEIGHTS), range(len(HEIGHTS)))
    output.SetLines(lines)
"""


def moving(*heights):
    """A point, or a line, that moves from left to right."""
    return simple.ProgrammableSource(OutputDataSetType="vtkPolyData", ScriptRequestInformation=INFORMATION,
                                     Script=SCRIPT.replace("HEIGHTS", str(heights)))


def at(proxy, time):
    """The output at a time, as ParaView's views ask for it."""
    proxy.UpdatePipeline(time)
    return servermanager.Fetch(proxy)


testing.load(sys.argv[1])
plane = simple.Plane(XResolution=20, YResolution=20)

# Keyframes of a coordinate of a seed.
distance = simple.GeodesicDistance(Input=plane, SeedPositions=[-0.4, 0, 0, 0.5, 0.5, 0])
track = simple.GetAnimationTrack("SeedPositions", 0, distance)
track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=0, KeyValues=[-0.4]), simple.CompositeKeyFrame(KeyTime=1, KeyValues=[0.4])]
scene = simple.GetAnimationScene()
scene.PlayMode = "Sequence"
scene.NumberOfFrames = 4
for frame in range(4):
    scene.AnimationTime = frame / 3
    x, y, _ = testing.points_of(distance).T
    place = -0.4 + 0.8 * frame / 3
    assert np.isclose(distance.SeedPositions[0], place)
    truth = np.minimum(np.hypot(x - place, y), np.hypot(x - 0.5, y - 0.5))
    assert np.abs(testing.array_of(distance) - truth).max() < 1e-6, frame

# Sources with time steps at the other inputs.
of_point = simple.GeodesicDistance(Input=plane, SeedSource=moving(0))
of_line = simple.GeodesicDistance(Input=plane, SeedSource=moving(-0.5, 0.5), Signed=1)
path = simple.GeodesicPath(Input=plane, WaypointSource=moving(-0.2, 0.3))
region = simple.GeodesicRegion(Input=plane, Lines=moving(-0.5, 0.5))


def check(time):
    """The programmable source runs its script among this module's names, so all names are local."""
    place = -0.4 + 0.8 * time / 3
    output = at(of_point, time)
    x, y, _ = vtk_to_numpy(output.GetPoints().GetData()).T
    found = vtk_to_numpy(output.GetPointData().GetArray("GeodesicDistance"))
    assert np.abs(found - np.hypot(x - place, y)).max() < 1e-6, (time, place)
    found = vtk_to_numpy(at(of_line, time).GetPointData().GetArray("GeodesicDistance"))
    assert np.abs(np.abs(found) - np.abs(x - place)).max() < 1e-6, (time, place)
    found = vtk_to_numpy(at(path, time).GetPoints().GetData())
    assert np.abs(found[:, 0] - place).max() < 1e-6 and np.isclose(np.ptp(found[:, 1]), 0.5), (time, place)
    at(region, time)
    areas = sorted(testing.informed(region, "RegionAreas"))
    assert np.allclose(areas, sorted((0.5 + place, 0.5 - place)), atol=1e-6), (time, areas)


for moment in (0.0, 3.0, 1.0, 1.0, 2.0, 0.0):
    check(moment)
