# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Paths as they are seen, counted in pictures from 8 directions, from near and far, in both projections: what Show
gives a script is a line of 4 pixels that no face cuts, and nothing of a path that is hidden.

Where the path is hidden is found without any picture, by rays from the camera to its points.

usage: SeenPaths.py PLUGIN
"""

import itertools
import math
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

import testing

SIZE = 600
# At least so much of what is to be seen is drawn, so wide; at most so much of what is hidden.
DRAWN, WIDTH, HIDDEN = 0.95, 3.0, 0.01
# The sine of 7 degrees.
EDGE_ON = 0.12
testing.load(sys.argv[1])


def dense(path):
    """Points along the segments of the path, and the directions there."""
    points = vtk_to_numpy(path.GetPoints().GetData())
    places, along = [], []
    for cell in range(path.GetNumberOfCells()):
        ids = path.GetCell(cell).GetPointIds()
        ends = points[[ids.GetId(i) for i in range(ids.GetNumberOfIds())]]
        for a, b in zip(ends[:-1], ends[1:]):
            length = np.linalg.norm(b - a)
            if length > 0:
                steps = (np.arange(max(int(length / path.GetLength() * SIZE / 2), 1)) + 0.5)[:, None]
                places.append(a + (b - a) * steps / len(steps))
                along.append(np.repeat([(b - a) / length], len(steps), axis=0))
    return np.concatenate(places), np.concatenate(along)


class Picture:
    def __init__(self, view, color):
        simple.Render(view)
        self.renderer = view.GetRenderer()
        self.camera = self.renderer.GetActiveCamera()
        grab = vtkWindowToImageFilter()
        grab.SetInput(view.GetRenderWindow())
        grab.ShouldRerenderOff()
        grab.Update()
        image = grab.GetOutput()
        width, height, _ = image.GetDimensions()
        rgb = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3]
        # More path than anything else is in the pixel.
        self.path = np.abs(rgb / 255 - color).sum(axis=2) < 0.5
        matrix = self.camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
        self.matrix = np.reshape([matrix.GetElement(i, j) for i in range(4) for j in range(4)], (4, 4))
        self.size = np.array([width, height])

    def pixels(self, places):
        seen = np.c_[places, np.ones(len(places))] @ self.matrix.T
        return (seen[:, :2] / seen[:, 3:] + 1) / 2 * self.size

    def at(self, pixels):
        i = np.floor(pixels).astype(int)
        inside = ((i >= 0) & (i < self.size)).all(axis=-1)
        x, y = np.moveaxis(np.clip(i, 0, self.size - 1), -1, 0)
        return self.path[y, x] & inside

    def eye_of(self, place):
        if not self.camera.GetParallelProjection():
            return np.array(self.camera.GetPosition())
        ahead = np.array(self.camera.GetDirectionOfProjection())
        return place - 4 * self.camera.GetDistance() * ahead

    def pixel_size(self):
        """The size of a pixel in space, at the camera's focus."""
        if self.camera.GetParallelProjection():
            return 2 * self.camera.GetParallelScale() / self.size[1]
        return 2 * self.camera.GetDistance() * math.tan(math.radians(self.camera.GetViewAngle()) / 2) / self.size[1]


def gap(locator, picture, place):
    """How far in front of a place the first face on its ray is, in pixels; 0 where nothing hides it."""
    eye = picture.eye_of(place)
    t, x, p, sub, cell = mutable(0.0), [0.0] * 3, [0.0] * 3, mutable(0), mutable(0)
    length = np.linalg.norm(place - eye)
    if not locator.IntersectWithLine(eye, place, 0.0, t, x, p, sub, cell):
        return 0.0
    before = (1 - t.get()) * length
    return 0.0 if before < 1e-4 * length else before / picture.pixel_size()


def turned(surface, locator, picture, place):
    """How far the face at a place is turned to the camera: a sine, 0 where it is seen edge on."""
    cell, part, distance2 = mutable(0), mutable(0), mutable(0.0)
    locator.FindClosestPoint(place, [0.0] * 3, cell, part, distance2)
    points = vtk_to_numpy(surface.GetCell(cell.get()).GetPoints().GetData()).astype(float)
    normal = np.cross(points[1] - points[0], points[2] - points[0])
    ray = place - picture.eye_of(place)
    return abs(normal @ ray) / (np.linalg.norm(normal) * np.linalg.norm(ray))


def smoothed(values):
    return np.convolve(values, np.ones(9) / 9, mode="same")


def check(name, picture, places, along, surface, locator):
    pixels = picture.pixels(places)
    sideways = picture.pixels(places + 1e-3 * along * picture.pixel_size()) - pixels
    sideways /= np.maximum(np.linalg.norm(sideways, axis=1), 1e-300)[:, None]
    across = sideways[:, ::-1] * [1, -1]
    gaps = np.array([gap(locator, picture, place) for place in places])
    # Beside a line in a face that is seen edge on there is no face to see the line on.
    seen = gaps == 0
    visible = np.array([s and turned(surface, locator, picture, p) > EDGE_ON for s, p in zip(seen, places)])
    # The run of the path's pixels across the line, in tenths.
    steps = np.arange(-40, 41) / 10
    runs = picture.at(pixels[:, None] + across[:, None] * steps[:, None])
    middle = len(steps) // 2
    left = np.argmin(np.c_[runs[:, middle::-1], np.zeros(len(runs), bool)], axis=1)
    right = np.argmin(np.c_[runs[:, middle:], np.zeros(len(runs), bool)], axis=1)
    # A line that is no row of pixels has stairs: its width is the mean over some pixels of its length.
    widths = smoothed(np.maximum(left + right - 1, 0) / 10 * visible) / np.maximum(smoothed(visible), 1e-9)
    drawn = (widths[visible] >= WIDTH).mean()
    # What is hidden by something well in front, and not beside what is seen.
    hidden = gaps > 20
    hidden[hidden] = [np.abs(pixels[seen] - pixel).max(axis=1).min(initial=SIZE) > 6 for pixel in pixels[hidden]]
    shining = picture.at(pixels[hidden]).mean() if hidden.any() else 0.0
    print(f"{name}: {visible.sum()} of {len(places)} visible, {drawn:.1%} drawn, median width "
          f"{np.median(widths[visible]):.2f}; {hidden.sum()} hidden, {shining:.1%} drawn")
    assert drawn >= DRAWN, (name, drawn)
    assert shining <= HIDDEN, (name, shining)


def look(name, surface, waypoints):
    path = simple.GeodesicPath(Input=surface, WaypointPositions=list(np.ravel(waypoints)), Closed=1)
    view = simple.CreateRenderView(ViewSize=[SIZE, SIZE], OrientationAxesVisibility=0)
    simple.Show(surface, view)
    display = simple.Show(path, view)
    data = servermanager.Fetch(surface)
    locator = vtkStaticCellLocator()
    locator.SetDataSet(data)
    locator.BuildLocator()
    places, along = dense(servermanager.Fetch(path))
    center, length = np.array(data.GetCenter()), data.GetLength()
    for number, direction in enumerate(itertools.product((-1, 1), (-0.6, 0.7), (-1.3, 1))):
        near = number % 2 == 0
        view.CameraParallelProjection = number % 3 == 0
        view.CameraFocalPoint = center
        view.CameraPosition = center + np.array(direction) / np.linalg.norm(direction) * length * (2 if near else 4)
        view.CameraParallelScale = length * (0.5 if near else 1)
        view.CameraViewUp = [0, 1, 0]
        picture = Picture(view, display.DiffuseColor)
        check(f"{name} from {direction}", picture, places, along, data, locator)
    simple.Delete(view)


look("plane", simple.Plane(XResolution=4, YResolution=4), [[-0.4, -0.3, 0], [0.4, -0.2, 0], [0.1, 0.4, 0]])
look("coarse", simple.Sphere(ThetaResolution=8, PhiResolution=6),
     [[0.5, 0, 0], [0, 0.5, 0.1], [-0.4, -0.1, 0.3], [0, -0.3, -0.4]])
look("Spot", simple.XMLPolyDataReader(FileName=testing.DATA + "/Spot.vtp"),
     [[0.3, 0.5, -0.3], [-0.3, 0.3, 0.5], [0, -0.5, -0.6], [0.3, -0.2, 0.6]])
look("Bunny", testing.bunny(), [[-0.09, 0.12, 0.01], [0, 0.1, 0.05], [0.05, 0.06, 0], [-0.02, 0.08, -0.06]])
