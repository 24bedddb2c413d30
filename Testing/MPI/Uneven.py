# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ranks with much larger triangles or much higher costs than others come to an end, with the distances of one rank.

usage: mpiexec -n N pvbatch --sym Uneven.py OUR_PLUGIN        (N > 1)
"""

import os
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkDummyController, vtkMultiProcessController

sys.path.append(os.path.dirname(__file__))
import harness
import pieces

harness.load(sys.argv[1])
RANK = pieces.controller().GetLocalProcessId()


def strip(rank, squares, cost):
    """A rank's square of as many squares in each direction, right of that of the rank before."""
    x, y = np.meshgrid(np.arange(squares + 1) / squares, np.arange(squares + 1) / squares, indexing="ij")
    points = np.stack([x.ravel() + rank, y.ravel(), 0 * x.ravel()], -1)
    data = pieces.polydata(points, pieces.grid(squares + 1, squares + 1))
    costs = numpy_to_vtk(np.full(len(points), float(cost)), deep=True)
    costs.SetName("Cost")
    data.GetPointData().AddArray(costs)
    return data


def solved(data):
    """The proxy after a run, and the largest distance that this rank has."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    distance = simple.GeodesicDistance(Input=source, SeedPositions=[0.3, 0.2, 0], CostArray=["POINTS", "Cost"])
    distance.UpdateVTKObjects()
    algorithm = distance.GetClientSideObject()
    assert harness.messages_of(algorithm.Update) == ""
    array = algorithm.GetOutputDataObject(0).GetPointData().GetArray("GeodesicDistance")
    return distance, np.nanmax(vtk_to_numpy(array))


def farthest_alone(strips):
    """The largest distance on the whole on this rank, which then sees no other one."""
    whole = vtkAppendPolyData()
    for data in strips:
        whole.AddInputData(data)
    whole.Update()
    together = vtkMultiProcessController.GetGlobalController()
    vtkMultiProcessController.SetGlobalController(vtkDummyController())
    try:
        return solved(whole.GetOutput())[1]
    finally:
        vtkMultiProcessController.SetGlobalController(together)


def largest_of_ranks(value):
    own, largest = numpy_to_vtk(np.array([value]), deep=True), vtkDoubleArray()
    largest.SetNumberOfTuples(1)
    pieces.controller().AllReduce(own, largest, vtkCommunicator.MAX_OP)
    return largest.GetValue(0)


for name, squares, costs in (("even", [10, 10], [1, 1]), ("few large squares", [10, 2], [1, 1]),
                             ("dear", [10, 10], [1, 30])):
    strips = [strip(rank, *(kind[rank == harness.RANKS - 1] for kind in (squares, costs))) for rank in range(harness.RANKS)]
    distance, farthest = solved(strips[RANK])
    farthest = largest_of_ranks(farthest)
    rounds = harness.informed(distance, "NumberOfRounds")
    truth = farthest_alone(strips)
    if harness.IS_FIRST:
        print(f"{name}: {rounds} rounds", flush=True)
    # A shared point has the cost of one of its ranks.
    assert name == "dear" or abs(farthest - truth) <= 1e-9 * truth, (name, farthest, truth)
    assert rounds <= 100, (name, rounds)
