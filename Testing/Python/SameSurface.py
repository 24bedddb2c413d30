# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances are drawn as ParaView's own representation draws them, to the pixel, whatever is changed; and where only the
distances have changed, the surface in the view stays the same object.

usage: SameSurface.py PLUGIN
"""

import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

import testing

testing.load(sys.argv[1])

sphere = simple.Sphere(ThetaResolution=40, PhiResolution=40)
distance = simple.GeodesicDistance(Input=sphere, SeedPositions=[0, 0, 0.5])
views, shown = [], []
for name in (None, "GeometryRepresentation"):
    view = simple.CreateRenderView(ViewSize=[300, 300], OrientationAxesVisibility=0)
    views.append(view)
    shown.append(simple.Show(distance, view, *filter(None, [name])))
    simple.Render(view)
    view.CameraPosition = [1, 0.5, 2]
    view.CameraFocalPoint = [0, 0, 0]
ours = shown[0]
assert ours.SMProxy.GetXMLName() == "SurfaceFieldRepresentation", ours.SMProxy.GetXMLName()
assert sorted(ours.GetProperty("Representation").Available) == sorted(shown[1].GetProperty("Representation").Available)


def picture(view):
    simple.Render(view)
    grab = vtkWindowToImageFilter()
    grab.SetInput(view.GetRenderWindow())
    grab.ShouldRerenderOff()
    grab.Update()
    return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())


def geometry():
    data = ours.GetClientSideObject().GetActiveRepresentation().GetRenderedDataObject(0)
    return data.GetBlock(0) if data.IsA("vtkMultiBlockDataSet") and data.GetNumberOfBlocks() == 1 else data


def changed():
    """Whether the picture has changed since the last call; it is the same in both views."""
    global before
    a, b = (picture(view) for view in views)
    assert np.array_equal(a, b), f"{(a != b).any(axis=1).sum()} pixels differ"
    result = not np.array_equal(a, before)
    before = a
    return result


def set_display(**values):
    for display in shown:
        for name, value in values.items():
            setattr(display, name, value)


before = picture(views[0])
assert len(np.unique(before, axis=0)) > 100, "The sphere is not coloured"
assert not changed()
first = geometry()

# Only the distances change: the surface in the view stays.
for seed in ([0.5, 0, 0], [0, 0.5, 0], [0.3, 0.3, 0.3]):
    distance.SeedPositions = seed
    assert changed(), seed
    assert geometry() is first, "The geometry was extracted again"

# The property that moves what is shown; Position in ParaView 5.11.
PLACE = "Translation" if "Translation" in simple.GetDisplayProperties(simple.GetActiveSource()).ListProperties() \
    else "Position"
# What else changes is seen as well, and the distances after it.
map_ = simple.GetColorTransferFunction("GeodesicDistance")
turn = iter(np.random.default_rng(1).uniform(-1, 1, (30, 3)))
for what in (
        lambda: map_.SetPropertyWithName("RGBPoints", [0, 0.1, 0, 0.5, 0.2, 0.8, 0.2, 0.4, 0.5, 1, 0.9, 0.1]),
        lambda: map_.RescaleTransferFunction(0, 0.3),
        lambda: set_display(Representation="Surface With Edges"),
        lambda: set_display(Representation="Wireframe"),
        lambda: set_display(Representation="Points", PointSize=6),
        lambda: set_display(Representation="Surface", Opacity=0.5),
        lambda: set_display(Opacity=1.0, Interpolation="Flat"),
        lambda: set_display(**{PLACE: [0.1, 0, 0]}),
        lambda: set_display(InterpolateScalarsBeforeMapping=0),
        lambda: set_display(InterpolateScalarsBeforeMapping=1),
        lambda: set_display(CoordinateShiftScaleMethod="Focal Point Shift Scale"),
        lambda: [setattr(view, "CameraPosition", [200, 100, 400]) for view in views],
        lambda: [setattr(view, "CameraPosition", [1, 0.5, 2]) for view in views],
        lambda: set_display(CoordinateShiftScaleMethod="Always Auto Shift Scale"),
        lambda: set_display(ColorArrayName=[None, ""]),
        lambda: set_display(ColorArrayName=["POINTS", "GeodesicDistance"]),
        lambda: setattr(sphere, "PhiResolution", 31),
        lambda: setattr(sphere, "Center", [0.1, 0.2, 0]),
        lambda: setattr(distance, "UseMaximumDistance", 1) or setattr(distance, "MaximumDistance", 0.7),
        lambda: setattr(distance, "DistanceArrayName", "Other"),
        lambda: setattr(distance, "DistanceArrayName", "GeodesicDistance")):
    what()
    changed()
    distance.SeedPositions = np.add(sphere.Center, next(turn)).tolist()
    changed()

# What is selected in the view is the same.
selections = []
for view in views:
    simple.SetActiveView(view)
    for select in (simple.SelectSurfacePoints, simple.SelectSurfaceCells):
        simple.ClearSelection()
        select(Rectangle=[120, 120, 180, 180], View=view)
        combined = servermanager._getPyProxy(distance.SMProxy.GetSelectionInput(0))
        selections.append(list(combined.Input[0].IDs))
assert len(selections[0]) > 10 and selections[:2] == selections[2:], selections

# A grid, whose surface is another data set.
wavelet = simple.Wavelet(WholeExtent=[-4, 4] * 3)
skin = simple.GeodesicDistance(Input=wavelet, SeedPointIds=[0])
for view, display in zip(views, shown):
    display.Visibility = 0
    simple.SetActiveView(view)
shown[:] = [simple.Show(skin, views[0]), simple.Show(skin, views[1], "GeometryRepresentation")]
for view in views:
    view.CameraPosition = [30, 20, 40]
for seed in (0, 700, 20):
    skin.SeedPointIds = [seed]
    assert changed()
