# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every wrapped method of every class, called with arguments as nobody should give them, and runs after it: no crash, no
run without end, and no exception of C++ that crosses VTK, which would end the program.

usage: pvpython OddArguments.py [FIRST_SEED [ROUNDS]]
"""

import math
import random
import sys

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkFloatArray, vtkIdList, vtkObject, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData, vtkSelection, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkSphereSource

import surfacegeodesics

FIRST_SEED = int(sys.argv[1]) if len(sys.argv) > 1 else 0
ROUNDS = int(sys.argv[2]) if len(sys.argv) > 2 else 200
CLASSES = [value for _, value in sorted(vars(surfacegeodesics).items())
           if isinstance(value, type) and issubclass(value, vtkObject)]


# What vtkTypeMacro() makes. In VTK's classes, too, IsTypeOf(None) reads through a null pointer.
OF_TYPE_MACRO = {"IsTypeOf", "IsA", "SafeDownCast", "NewInstance", "GetNumberOfGenerationsFromBase",
                 "GetNumberOfGenerationsFromBaseType"}


def surface(resolution=12):
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(resolution)
    sphere.SetPhiResolution(resolution)
    sphere.Update()
    data = sphere.GetOutput()
    for array, components in ((vtkDoubleArray(), 1), (vtkFloatArray(), 3)):
        array.SetNumberOfComponents(components)
        array.SetNumberOfTuples(data.GetNumberOfPoints())
        array.Fill(1.0)
        array.SetName(f"Of{components}")
        data.GetPointData().AddArray(array)
    return data


def line():
    source = vtkLineSource()
    source.SetResolution(5)
    source.Update()
    return source.GetOutput()


SURFACE = surface()
BROKEN = vtkPoints()
BROKEN.InsertNextPoint(math.nan, math.inf, 1e308)
IDS = vtkIdList()
for number in (-1, 0, 0, 5, 2**62):
    IDS.InsertNextId(number)
OBJECTS = [SURFACE, surface(3), line(), vtkPolyData(), vtkUnstructuredGrid(), vtkMultiBlockDataSet(), vtkSelection(), IDS,
           vtkIdList(), vtkPoints(), BROKEN, vtkDoubleArray(), vtkFloatArray(), SURFACE.GetPointData().GetArray("Of1"),
           SURFACE.GetPointData().GetArray("Of3")]
NUMBERS = [True, -1, 0, 1, 2, 3, 5, 100, 2**31 - 1, 2**31, -2**31, 2**62, -2**63, 0.5, -0.5, 1e308, -1e308, 1e-320, math.nan,
           math.inf, -math.inf]
OTHERS = [None, "", "Of1", "GeodesicDistance", "é\n\"'\\", "x" * 1_000_000, [], (1,), [0.0, 0.0, 0.5], [math.nan] * 3,
          [1e308] * 6, object()]


def odd_value(rng):
    return rng.choice(rng.choice((OBJECTS, NUMBERS, NUMBERS, OTHERS)))


def own_methods(cls):
    """Those that it inherits from another class of ours, too, but not VTK's own."""
    for base in cls.__mro__:
        if base in CLASSES:
            for name, method in vars(base).items():
                if callable(method) and not name.startswith("_") and name not in OF_TYPE_MACRO:
                    yield name


def call(instance, name, rng):
    """Whether the arguments fit the method."""
    arguments = [odd_value(rng) for _ in range(rng.choice((0, 1, 1, 1, 2, 3, 4)))]
    try:
        getattr(instance, name)(*arguments)
    except (TypeError, ValueError, OverflowError):
        return False
    return True


def is_abstract(cls):
    try:
        cls()
    except TypeError:
        return True
    return False


def run(instance, rng):
    if isinstance(instance, vtkAlgorithm):
        for port in range(instance.GetNumberOfInputPorts()):
            if port == 0 or rng.random() < 0.3:
                instance.SetInputDataObject(port, SURFACE if port == 0 else rng.choice((SURFACE, line(), vtkPolyData())))
        instance.Update()


# Errors are what most of this makes.
vtkObject.GlobalWarningDisplayOff()
calls = runs = 0
for cls in CLASSES:
    if is_abstract(cls):
        continue
    names = sorted(set(own_methods(cls)))
    setters = [name for name in names if name.startswith(("Set", "Add", "Insert", "Clear", "Remove"))]
    for seed in range(FIRST_SEED, FIRST_SEED + ROUNDS):
        rng = random.Random(f"{cls.__name__} {seed}")
        print(cls.__name__, seed, file=sys.stderr, flush=True)
        instance = cls()
        # All methods, or a few, after which more of the run is reached.
        for name in rng.sample(names, len(names)) if seed % 4 == 0 else rng.choices(setters or names, k=3):
            calls += sum(call(instance, name, rng) for _ in range(5))
        run(instance, rng)
        str(instance)
        runs += 1
print(f"{len(CLASSES)} classes, {calls} calls whose arguments fit, {runs} runs")
assert len(CLASSES) > 10 and calls > 20 * runs / 4
