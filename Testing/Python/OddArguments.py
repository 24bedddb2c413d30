# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every method of our classes takes whatever Python hands it: it is refused, or the run says what is wrong, or
gives an output. Nothing ends the process, as an exception of C++ that comes through would. The last line that is
printed is the call.

usage: OddArguments.py
"""

import itertools
import math

import surfacegeodesics
from vtkmodules.vtkCommonCore import (
    vtkDoubleArray, vtkIdList, vtkIntArray, vtkObject, vtkOutputWindow, vtkStringArray, vtkStringOutputWindow)
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput
from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource, vtkSphereSource

# Refusals of Python's wrappers.
REFUSALS = (TypeError, ValueError, OverflowError, AttributeError)
# Methods that run or that Python's own machinery calls, not options.
SKIPPED = {"SafeDownCast", "NewInstance", "IsA", "IsTypeOf"}
MOST_ARGUMENTS = 4


def odd_values():
    """Made anew for each object, which may keep them."""
    ids = vtkIdList()
    for number in (-1, 0, 2**40, 2**63 - 1, -2**63):
        ids.InsertNextId(number)
    short = vtkDoubleArray()
    short.InsertNextValue(math.nan)
    wide = vtkDoubleArray()
    wide.SetNumberOfComponents(7)
    return [
        None, True, 0, -1, 3, 2**31 - 1, -2**31, 2**62, 2**63 - 1, -2**63, 2**64, 0.5, math.nan, math.inf, -math.inf,
        1e308, -1e308, 5e-324, "", "no such array", "\"quoted\" \n é %s {0} \0", "x" * 1000000, b"\xff\xfe", [], [1.0],
        [math.nan] * 3, (1.0, 2.0, 3.0, 4.0), {}, object(), ids, vtkIdList(), short, wide, vtkIntArray(),
        vtkStringArray(), vtkPolyData(), vtkAlgorithmOutput(), vtkSphereSource().GetOutputPort()]


def sphere():
    source = vtkSphereSource()
    source.Update()
    surface = source.GetOutput()
    heights = vtkDoubleArray()
    heights.SetName("height")
    for i in range(surface.GetNumberOfPoints()):
        heights.InsertNextValue(surface.GetPoint(i)[2])
    surface.GetPointData().SetScalars(heights)
    return surface


def ids_of(*numbers):
    ids = vtkIdList()
    for number in numbers:
        ids.InsertNextId(number)
    return ids


def prepare(made):
    """Gives an object what it needs to run, and returns what runs it and says whether that gave something."""
    name = made.GetClassName()
    if name in ("vtkSurfacePointPicker", "vtkNearestOnLines"):
        made.SetInputConnection(KEPT_SPHERE.GetOutputPort())
        return lambda: getattr(made, "Pick" if name == "vtkSurfacePointPicker" else "Find")() or True
    if not isinstance(made, vtkAlgorithm):
        return lambda: True
    made.SetInputDataObject(SURFACE)
    if name == "vtkSurfaceGeodesicDistance":
        made.AddSeedPosition(0, 0, 0.5)
    elif name == "vtkSurfaceGeodesicPath":
        for coordinate in (0, 0, 0.5, 0.5, 0, 0):
            made.AddWaypointCoordinate(coordinate)
    elif name == "vtkSurfaceGeodesicDistanceMatrix":
        for coordinate in (0, 0, 0.5, 0.5, 0, 0):
            made.AddLandmarkCoordinate(coordinate)
    elif name == "vtkSurfaceGeodesicSamples":
        made.SetNumberOfSamples(3)
    elif name == "vtkSurfaceGeodesicRegion":
        made.SetLinesConnection(CIRCLE.GetOutputPort())
    elif name == "vtkFastMarchingGeodesicDistance":
        made.SetSeeds(ids_of(0))
        made.SetFieldDataName("distance")
    elif name == "vtkFastMarchingGeodesicPath":
        made.SetSeeds(ids_of(0))
        made.SetBeginPointId(7)

    def run():
        made.Modified()
        made.Update()
        output = made.GetOutputDataObject(0)
        return output.GetNumberOfElements(0) > 0 or output.GetNumberOfElements(6) > 0

    return run


def own_methods(kind):
    """The names of the methods of a class and of its bases that are ours."""
    ours = [base for base in kind.__mro__ if base.__module__.startswith("surfacegeodesics")]
    names = {name for base in ours for name in vars(base) if not name.startswith("_")}
    return sorted(name for name in names - SKIPPED if callable(getattr(kind, name)))


def messages_of(run):
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    result = run()
    vtkOutputWindow.SetInstance(None)
    return result, window.GetOutput()


def try_method(kind, name):
    """Calls a method with each odd value in each place, and runs the object after each call that it takes."""
    taken = 0
    for number in range(MOST_ARGUMENTS + 1):
        for index in range(len(odd_values()) if number else 1):
            made = kind()
            run = prepare(made)
            arguments = [odd_values()[index]] * number
            print(kind.__name__, name, number, index, flush=True)
            try:
                messages_of(lambda: getattr(made, name)(*arguments))
            except REFUSALS:
                continue
            taken += 1
            gave, messages = messages_of(run)
            assert gave or len(messages) > 20, (kind.__name__, name, arguments, "gives nothing and says nothing")
            str(made)
            made.GetMTime() if isinstance(made, vtkObject) else None
    return taken


SURFACE = sphere()
KEPT_SPHERE = vtkSphereSource()
KEPT_SPHERE.Update()
CIRCLE = vtkRegularPolygonSource()
CIRCLE.SetRadius(0.4)
CIRCLE.GeneratePolygonOff()

classes = [kind for kind in vars(surfacegeodesics).values()
           if isinstance(kind, type) and kind.__module__.startswith("surfacegeodesics")]
classes = [kind for kind in classes if hasattr(kind, "NewInstance")]
assert len(classes) >= 12, classes
counts = {}
for kind in classes:
    try:
        kind()
    except TypeError:
        continue  # An abstract class; its methods are those of the others.
    gave, messages = messages_of(prepare(kind()))
    assert gave and not messages, (kind, messages)
    counts[kind.__name__] = sum(try_method(kind, name) for name in own_methods(kind))
print(counts)
assert min(counts.values()) > 5 and sum(counts.values()) > 3000, counts
