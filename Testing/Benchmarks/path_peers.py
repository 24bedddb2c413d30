"""Lengths and times of paths by our filter and its peers, between the same pairs of points.

usage: pvpython path_peers.py RESULT.json KIND PLUGIN FOLDER SURFACE...
KIND: ours, with our plugin; bundled, with ParaView's GeodesicMeasurement; dijkstra, with either

FOLDER holds what PathBenchmark --surfaces=FOLDER wrote. For each surface and each pair the result has
the length of the path, 0 where there is none, the seconds of the filter's Update() and those of the
whole: properties set, and all that ParaView does to have the output. Processor times.
"""

import json
import os
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


def measured(kind, points, triangles, pairs):
    tracer = {"ours": Ours, "bundled": Bundled, "dijkstra": Dijkstra}[kind](
        polydata(points, triangles))
    found = {"length": [], "update": [], "whole": []}
    for source, target in pairs[:, :2].astype(int).tolist():
        start = time.process_time()
        if kind == "dijkstra":
            tracer.set_ids(source, target)
        else:
            tracer.set_ends(points[[source, target]])
        update = time.process_time()
        tracer.filter.Update()
        found["update"].append(time.process_time() - update)
        tracer.finish()
        found["whole"].append(time.process_time() - start)
        found["length"].append(length(tracer.filter.GetOutputDataObject(0)))
    return found


def main(result, kind, plugin, folder, *surfaces):
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    found = {}
    for surface in surfaces:
        points, triangles, pairs = read(folder, surface)
        found[surface] = {"exact": pairs[:, 2].tolist(), **measured(kind, points, triangles, pairs)}
    with open(result, "w") as file:
        json.dump(found, file)


if __name__ == "__main__":
    main(*sys.argv[1:])
