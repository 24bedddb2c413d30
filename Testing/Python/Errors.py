"""A script notices an error by an empty output; the message names value, limit and remedy.

usage: Errors.py OUR_PLUGIN
"""

import sys

from paraview import simple
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

import testing

testing.load(sys.argv[1])

sphere = simple.Sphere()
distance = simple.GeodesicDistance(Input=sphere, SeedPositions=[0, 0, 0.5])


def expect_error(named):
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    assert testing.is_empty(distance), named
    vtkOutputWindow.SetInstance(None)
    assert named in window.GetOutput(), window.GetOutput()


def expect_well():
    assert not testing.is_empty(distance)
    assert testing.array_of(distance) is not None


expect_well()

distance.SeedPositions = []
expect_error("SeedPositions")
distance.SeedPositions = [0, 0]
expect_error("2 numbers, which is no multiple of 3")
distance.SeedPositions = [0, 0, 1, 2]
expect_error("4 numbers, which is no multiple of 3")
distance.SeedPositions = [0, 0, 0.5, 0, float("nan"), 0]
expect_error("Point 1 of SeedPositions")
distance.SeedPositions = [0, 0, 0.5]
expect_well()

distance.UseMaximumDistance = 1
distance.MaximumDistance = -1
expect_error("maximum distance is -1")
distance.UseMaximumDistance = 0
expect_well()

# Inputs without a surface, or of several blocks.
distance.Input = simple.PointSource(NumberOfPoints=5)
expect_error("no surface")
distance.Input = simple.PolyLineSource()
expect_error("no surface")
distance.Input = simple.GroupDatasets(Input=[simple.Sphere(), simple.Plane()])
expect_error("Merge Blocks")
distance.Input = sphere
expect_well()
