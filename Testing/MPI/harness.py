# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a filter on pieces.py's surfaces, in pvbatch with and without --sym, and collects the results."""

import os
import sys
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

sys.path.append(os.path.dirname(__file__))
import pieces

RANKS = pieces.controller().GetNumberOfProcesses()
IS_FIRST = pieces.controller().GetLocalProcessId() == 0
HERE = f"import sys; sys.path.append({os.path.dirname(os.path.abspath(__file__))!r}); import pieces; "


# ParaView 5.13 renamed these filters.
if hasattr(simple, "GlobalPointAndCellIds"):
    GLOBAL_IDS_FILTER = "Global Point And Cell Ids"
    make_ids = simple.GlobalPointAndCellIds
    make_ghosts = simple.GhostCells
else:
    GLOBAL_IDS_FILTER = "Generate Global Ids"
    make_ids = simple.GenerateGlobalIds
    make_ghosts = simple.GhostCellsGenerator


def end_all_ranks(kind, error, traceback):
    """Ranks that wait for one that failed would wait for ever."""
    sys.__excepthook__(kind, error, traceback)
    sys.stderr.flush()
    os._exit(1)


sys.excepthook = end_all_ranks


def some(all_cases):
    """On three ranks every second of some cases, in the order of their names: all of them run on two, and three take
    turns on two processors."""
    return {name: all_cases[name] for name in sorted(all_cases)[::2]} if RANKS == 3 else all_cases


def load(plugin):
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))


def surface(name, cut, with_ids=False, bad_rank=-1):
    """The source of a surface's pieces."""
    return simple.ProgrammableSource(
        OutputDataSetType="vtkPolyData",
        Script=HERE + f"pieces.make(self.GetOutput(), {name!r}, {cut!r}, {with_ids}, {bad_rank})")


def in_blocks(name):
    """Partitioned data: each rank has its part of the surface in two partitions."""
    return simple.ProgrammableSource(
        OutputDataSetType="vtkPartitionedDataSet", Script=HERE + f"pieces.make_blocks(self.GetOutput(), {name!r})")


def in_multiblock(name):
    """Blocks that several ranks have parts of, and blocks of one rank each."""
    return simple.ProgrammableSource(
        OutputDataSetType="vtkMultiblockDataSet", Script=HERE + f"pieces.make_multiblock(self.GetOutput(), {name!r})")


def can_redistribute():
    """
    Whether RedistributeDataSet can move cells: it sends them as .vtu files with appended data, which Debian 12's
    present libexpat1 (2.5.0-1+deb12u2) rejects, so that cells are lost.
    """
    sphere = vtkSphereSource()
    sphere.Update()
    with tempfile.TemporaryDirectory() as folder:
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(os.path.join(folder, "sphere.vtp"))
        writer.SetInputData(sphere.GetOutput())
        writer.EncodeAppendedDataOff()
        writer.SetCompressorTypeToNone()
        writer.Write()
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(writer.GetFileName())
        messages_of(reader.Update)
    works = reader.GetOutput().GetNumberOfPoints() == sphere.GetOutput().GetNumberOfPoints()
    if IS_FIRST and not works:
        print("RedistributeDataSet loses cells with this libexpat1: its cases are left out", flush=True)
    return works


def redistributed(name):
    """A surface that ParaView cut, where that works; the cut "boxes" of pieces.py is much the same."""
    parts = simple.RedistributeDataSet(Input=surface(name, "first"))
    return simple.ExtractSurface(Input=parts)


def brick(cut):
    """The source of a grid of volume cells."""
    return simple.ProgrammableSource(
        OutputDataSetType="vtkUnstructuredGrid", Script=HERE + f"pieces.make_brick(self.GetOutput(), {cut!r})")


def image():
    """An image, which each rank has a part of, with PointNumber."""
    wavelet = simple.Wavelet(WholeExtent=[0, 16, 0, 12, 0, 9])
    return simple.Calculator(Input=wavelet, ResultArrayName="PointNumber", Function="coordsX+17*coordsY+17*13*coordsZ")


def ghosted(source):
    return make_ghosts(Input=source, BuildIfRequired=0)


def with_made_ids(source):
    return make_ids(Input=source)


def run(proxy, path):
    """The arrays of the proxy's output on all ranks, one part a rank; None but on the first rank."""
    check = simple.ProgrammableFilter(
        Input=proxy, Script=HERE + f"pieces.store(self.GetInput(), {path!r}); self.GetOutput().ShallowCopy(self.GetInput())")
    check.UpdatePipeline()
    return [np.load(pieces.part_path(path, rank)) for rank in range(RANKS)] if IS_FIRST else None


def joined(parts, name, size):
    """By PointNumber: the least and largest value over all ranks."""
    least, most = np.full(size, np.inf), np.full(size, -np.inf)
    for part in parts:
        if "PointNumber" in part and name in part:
            numbers = part["PointNumber"].astype(int)
            values = np.nan_to_num(part[name], nan=1e300)
            np.minimum.at(least, numbers, values)
            np.maximum.at(most, numbers, values)
    return least, most


def messages_of(action):
    """What this rank reports while a function runs."""
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    action()
    vtkOutputWindow.SetInstance(None)
    return window.GetOutput()


def informed(proxy, name):
    proxy.UpdatePropertyInformation()
    return proxy.GetPropertyValue(name)
