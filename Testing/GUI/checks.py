# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts of this folder check from ParaView's Python shell. A failure ends ParaView with the result 1,
because an exception in the shell would not fail a playback.
"""

import ctypes
import os
import subprocess
import sys
import time
import traceback

import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkCellLocator


def expect(condition, *seen):
    if not condition:
        os.write(2, f"FAILED: {seen}\n".encode())
        os._exit(1)


def fail(kind, error, trace):
    traceback.print_exception(kind, error, trace, file=sys.__stderr__)
    os._exit(1)


# The shell asks this for what to do with an exception.
sys.excepthook = fail


def let_paint():
    """
    Has Qt paint what it has not painted yet, as a view that a state file made. If the first painting of a view falls
    in an update of a server's filter, which its progress can bring about, ParaView ends by "Wrong tag", whatever
    filter it is.
    """
    process = ctypes.CDLL(None)["_ZN16QCoreApplication13processEventsE6QFlagsIN10QEventLoop17ProcessEventsFlagEE"]
    end = time.monotonic() + 0.5
    while time.monotonic() < end:
        process(1)  # all but what the user does


def shown(name="SeedPositions"):
    """The points in the panel, applied or not."""
    source = GetActiveSource().SMProxy.GetProperty(name)
    values = [source.GetUncheckedElement(i) for i in range(source.GetNumberOfUncheckedElements())]
    return np.reshape(values, (-1, 3))


def applied(name="SeedPositions"):
    return np.reshape(GetActiveSource().GetPropertyValue(name), (-1, 3))


def surface():
    return servermanager.Fetch(GetActiveSource().Input)


def expect_points(points, name="SeedPositions"):
    """The points in the panel are these, to the last bit."""
    found = shown(name)
    expect(np.array_equal(found, np.reshape(points, (-1, 3))), found, points)


def expect_on_surface(count, name="SeedPositions"):
    """So many points are in the panel, and all lie on the input to 1e-6 of its bounding box."""
    data = surface()
    locator = vtkCellLocator()
    locator.SetDataSet(data)
    locator.BuildLocator()
    points = shown(name)
    expect(len(points) == count, points)
    for point in points:
        cell, part, distance2 = mutable(0), mutable(0), mutable(0.0)
        locator.FindClosestPoint(point, [0.0, 0.0, 0.0], cell, part, distance2)
        expect(distance2.get() < (1e-6 * data.GetLength()) ** 2, point, distance2)


def expect_mesh_point(row, name="SeedPositions"):
    """A point in the panel is a point of the mesh and not one between them."""
    corners = vtk_to_numpy(surface().GetPoints().GetData()).astype(float)
    distances = np.linalg.norm(corners - shown(name)[row], axis=1)
    expect(distances.min() == 0.0, distances.min())


def expect_between_mesh_points(row, name="SeedPositions"):
    corners = vtk_to_numpy(surface().GetPoints().GetData()).astype(float)
    expect(np.linalg.norm(corners - shown(name)[row], axis=1).min() > 1e-3)


def expect_seen_at(row, x, y, name="SeedPositions"):
    """The view draws a point at this place, in parts of its width and height from the upper left."""
    view = GetActiveView()
    renderer = view.GetRenderer()
    renderer.SetWorldPoint(*shown(name)[row], 1.0)
    renderer.WorldToDisplay()
    pixel = renderer.GetDisplayPoint()
    width, height = view.GetRenderWindow().GetSize()
    expect(abs(pixel[0] - x * width) < 2 and abs(height - pixel[1] - y * height) < 2, pixel, x * width, (1 - y) * height)


def pixels_of(*color, area="1366x768+0+0"):
    """How many pixels of exactly this colour, in parts of 1, are on the screen or in an area of it."""
    raw = subprocess.run(["import", "-window", "root", "-crop", area, "-depth", "8", "rgb:-"],
                         stdout=subprocess.PIPE, check=True)
    rgb = np.frombuffer(raw.stdout, np.uint8).reshape(-1, 3)
    return int((np.abs(rgb - np.multiply(color, 255)) < 1).all(axis=1).sum())


def magenta_pixels():
    """How many pixels of the screen are as strongly magenta as a path, also in a picture that was made smaller."""
    raw = subprocess.run(["import", "-window", "root", "-depth", "8", "rgb:-"], stdout=subprocess.PIPE, check=True)
    red, green, blue = np.frombuffer(raw.stdout, np.uint8).reshape(-1, 3).astype(int).T
    return int((np.minimum(red, blue) - green > 100).sum())


def picture():
    """The colours of the view's pixels on the screen: rows x columns x 3, from 0 to 255."""
    raw = subprocess.run(["import", "-window", "root", "-crop", "1000x520+330+205", "-depth", "8", "rgb:-"],
                         stdout=subprocess.PIPE, check=True)
    return np.frombuffer(raw.stdout, np.uint8).reshape(520, 1000, 3).astype(int)


def expect_alike(sketched, drawn):
    """Two pictures differ by rounding alone, but for one pixel in 200: outlines are smoothed in the finished picture."""
    away = np.abs(sketched - drawn).max(axis=2)
    expect((away > 3).mean() < 0.005, (away > 3).sum(), away.max())


def path_length(segments):
    """The length of the active path, which has so many segments and is shown together with its input."""
    path = GetActiveSource()
    data = servermanager.Fetch(path)
    expect(data.GetNumberOfCells() == segments, data.GetNumberOfCells())
    expect(all(GetRepresentation(source).Visibility for source in (path, path.Input)))
    path.UpdatePropertyInformation()
    return path.TotalLength


def expect_bands(spacing):
    """The active distances, those of FlatDistance.py, are drawn in bands of this width: each ring has its colour alone. The
    marker of the seed hides a part of the first."""
    renderer = GetActiveView().GetRenderer()
    across = []
    for x in (-0.5, 0.5):
        renderer.SetWorldPoint(x, 0, 0, 1)
        renderer.WorldToDisplay()
        across.append(renderer.GetDisplayPoint()[0])
    colors = GetColorTransferFunction("GeodesicDistance").GetClientSideObject()
    for band in range(1, int(1 / spacing + 1e-9)):
        inner, outer = spacing * band, spacing * (band + 1)
        expected = np.pi / 4 * (outer**2 - inner**2) * (across[1] - across[0]) ** 2
        rgb = [0.0] * 3
        colors.GetColor((inner + outer) / 2, rgb)
        found = pixels_of(*np.round(np.multiply(rgb, 255)) / 255, area="1000x520+330+205")
        expect(abs(found - expected) < 0.03 * expected, spacing, band, found, expected)


def place(representation, translation, scale):
    """Moves and scales what a view shows. ParaView 5.13 renamed the property."""
    name = "Translation" if representation.SMProxy.GetProperty("Translation") else "Position"
    representation.SetPropertyWithName(name, translation)
    representation.Scale = scale


def aim():
    """Moves the camera so that 0 is drawn where the playback's pointer is at (0.5, 0.5): at whole pixels."""
    view = GetActiveView()
    renderer = view.GetRenderer()
    width, height = view.GetRenderWindow().GetSize()
    renderer.SetWorldPoint(0, 0, 0, 1)
    renderer.WorldToDisplay()
    renderer.SetDisplayPoint(width // 2, height - height // 2, renderer.GetDisplayPoint()[2])
    renderer.DisplayToWorld()
    x, y, _, w = renderer.GetWorldPoint()
    view.CameraPosition = np.subtract(view.CameraPosition, [x / w, y / w, 0])
    view.CameraFocalPoint = np.subtract(view.CameraFocalPoint, [x / w, y / w, 0])
    Render()


def on_ball(a, b):
    """The distance of two points over the ball of Ball.py."""
    a, b = (point / np.linalg.norm(point) for point in (a, b))
    return 0.5 * np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)


def expect_distances_on_ball():
    """The active distances on the ball of Ball.py are those from the seed in the panel, to 4 % of the largest."""
    data = servermanager.Fetch(GetActiveSource())
    found = vtk_to_numpy(data.GetPointData().GetArray("GeodesicDistance"))
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    error = np.abs(found - [on_ball(point, shown()[0]) for point in points]).max()
    expect(error < 0.02 * np.pi, error)


def expect_path_on_ball():
    """The active path on the ball of Ball.py runs through the waypoints in the panel, and is shortest to 1 %."""
    points = shown("WaypointPositions")
    lengths = vtk_to_numpy(servermanager.Fetch(GetActiveSource()).GetCellData().GetArray("Length"))
    truth = np.array([on_ball(a, b) for a, b in zip(points, points[1:])])
    expect(len(lengths) == len(truth) and np.all(np.abs(lengths - truth) < 0.01 * truth), lengths, truth)
