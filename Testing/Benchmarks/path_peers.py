# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lengths and times of paths by our filter and its peers, between the same pairs of points.

usage: pvpython path_peers.py RESULT KIND PLUGIN FOLDER SURFACE FIRST_PAIR
KIND: ours, with our plugin; bundled, with ParaView's GeodesicMeasurement; dijkstra, with either

FOLDER holds what PathBenchmark --surfaces=FOLDER wrote. For each pair from the first one on, a line of
JSON is appended to the result: the length of the path, 0 where there is none, the seconds of the
filter's Update() and those of the whole: properties set, and all that ParaView does to have the output.
Processor times. A filter that takes far too long on a pair is ended with the process.
"""

import json
import os
import signal
import sys
import time

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath

from filter_benchmark import polydata


def read(folder, surface):
    """Points, triangles, and pairs as rows of source, target and exact distance."""
    def values(suffix, kind):
        return np.fromfile(os.path.join(folder, surface + suffix), kind).reshape(-1, 3)

    return values(".points", float), values(".triangles", np.uint32), values(".pairs", float)


def producer(data):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


class Ours:
    def __init__(self, surface):
        self.proxy = simple.GeodesicPath(Input=producer(surface))
        self.filter = self.proxy.GetClientSideObject()

    def set_ends(self, ends):
        self.proxy.WaypointPositions = ends.ravel().tolist()
        self.proxy.UpdateVTKObjects()

    def finish(self):
        self.proxy.UpdatePipeline()


class Bundled:
    def __init__(self, surface):
        self.ends = producer(vtkPolyData())
        self.proxy = simple.GeodesicMeasurement(Input=producer(surface), Endpoints=self.ends)
        self.filter = self.proxy.GetClientSideObject()

    def set_ends(self, ends):
        data = vtkPolyData()
        data.SetPoints(vtkPoints())
        data.GetPoints().SetData(numpy_to_vtk(ends, deep=True))
        self.ends.GetClientSideObject().SetOutput(data)
        self.ends.MarkModified(self.ends)
        self.proxy.UpdateVTKObjects()

    def finish(self):
        self.proxy.UpdatePipeline()


class Dijkstra:
    def __init__(self, surface):
        self.points = vtk_to_numpy(surface.GetPoints().GetData())
        self.filter = vtkDijkstraGraphGeodesicPath()
        self.filter.SetInputData(surface)
        self.filter.StopWhenEndReachedOn()

    def set_ids(self, source, target):
        self.filter.SetStartVertex(source)
        self.filter.SetEndVertex(target)

    def finish(self):
        pass


def length(path):
    """Over all lines of a path."""
    if path.GetNumberOfPoints() == 0:
        return 0.0
    points = vtk_to_numpy(path.GetPoints().GetData()).astype(float)
    lines = path.GetLines()
    offsets = vtk_to_numpy(lines.GetOffsetsArray())
    ids = vtk_to_numpy(lines.GetConnectivityArray())
    return float(sum(np.linalg.norm(np.diff(points[ids[a:b]], axis=0), axis=1).sum()
                     for a, b in zip(offsets[:-1], offsets[1:])))


def limit_time(points):
    """Several times what the slowest filter needs: what takes longer does not end."""
    # A limit of processor time would make the processor clock coarse.
    signal.alarm(20 + points // 20000)


def measured(tracer, points, source, target):
    start = time.process_time()
    if isinstance(tracer, Dijkstra):
        tracer.set_ids(source, target)
    else:
        tracer.set_ends(points[[source, target]])
    update = time.process_time()
    tracer.filter.Update()
    updated = time.process_time()
    tracer.finish()
    end = time.process_time()
    return {"length": length(tracer.filter.GetOutputDataObject(0)), "update": updated - update,
            "whole": end - start}


def main(result, kind, plugin, folder, surface, first):
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    points, triangles, pairs = read(folder, surface)
    tracer = {"ours": Ours, "bundled": Bundled, "dijkstra": Dijkstra}[kind](polydata(points, triangles))
    with open(result, "a") as file:
        for source, target in pairs[int(first):, :2].astype(int).tolist():
            limit_time(len(points))
            print(json.dumps(measured(tracer, points, source, target)), file=file, flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
