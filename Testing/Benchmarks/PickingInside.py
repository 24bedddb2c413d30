# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""What PickingBenchmark.py runs in ParaView: a sphere with so many triangles, and a log of what the filter and the
view do. Environment: TRIANGLES, LOG, LIVE (1: with live update and a result to show)."""

import json
import os
import time

from paraview import servermanager
from paraview.simple import *

resolution = int((int(os.environ["TRIANGLES"]) / 2) ** 0.5) + 1
ball = Sphere(registrationName="Ball", ThetaResolution=resolution, PhiResolution=resolution)
view = GetActiveViewOrCreate("RenderView")
distance = GeodesicDistance(registrationName="Distance", Input=ball)
view.CameraPosition = [0, 0, 4]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraViewAngle = 20
events = []


def log(name):
    return lambda *_: events.append((name, time.perf_counter()))


def write(*_):
    part = os.environ["LOG"] + ".part"
    with open(part, "w", encoding="utf-8") as file:
        json.dump(events, file)
    os.replace(part, os.environ["LOG"])


if os.environ["LIVE"] == "1":
    distance.SeedPositions = [0, 0, 0.5]
    Show(distance, view)
    Hide(ball, view)
    algorithm = distance.GetClientSideObject()
    algorithm.AddObserver("StartEvent", log("solve"))
    algorithm.AddObserver("EndEvent", log("solved"))
else:
    Show(ball, view)
SetActiveSource(distance)
Render()
view.SMProxy.AddObserver("StartEvent", log("draw"))
view.SMProxy.AddObserver("EndEvent", log("drawn"))
view.SMProxy.AddObserver("EndEvent", write)
Render()
