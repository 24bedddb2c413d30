# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""What several ranks keep from run to run, as one rank does: segments of paths, lines with their cuts, and the structure
of a surface whose points move.

usage: mpiexec -n N pvbatch --sym Kept.py OUR_PLUGIN        (N > 1)
The plugin must be built with SURFACEGEODESICS_INJECT_FAULTS.
"""

import os
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

sys.path.append(os.path.dirname(__file__))
import cases
import harness
import pieces

harness.load(sys.argv[1])
RANK = pieces.controller().GetLocalProcessId()


def source_of(surface):
    """This rank's slab of a surface, which does not change by itself."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(pieces.part(surface, "slabs", RANK, harness.RANKS))
    return source


def searches_of(path):
    """How many segments a run searches for; the same on all ranks."""
    path.GetClientSideObject().Update()
    return harness.informed(path, "NumberOfSearches")


def lengths(algorithm):
    array = algorithm.GetOutputDataObject(0).GetCellData().GetArray("Length")
    return None if array is None else vtk_to_numpy(array).copy()


def set_points(path, points):
    path.WaypointPositions = np.ravel(points).tolist()
    path.UpdateVTKObjects()


def check_segments(**options):
    """A moved waypoint is searched for by its two segments alone, and all are as of a new filter."""
    source = source_of("bunny")
    points = np.reshape(cases.points_on("bunny", 7), (-1, 3))
    path = simple.GeodesicPath(Input=source, WaypointPositions=points[:6].ravel().tolist(), **options)
    path.UpdateVTKObjects()
    algorithm = path.GetClientSideObject()
    assert searches_of(path) == 5
    points[2] = points[6]
    set_points(path, points[:6])
    assert searches_of(path) == 2
    moved = lengths(algorithm)
    path.HeightOffset = 0.001
    path.UpdateVTKObjects()
    assert searches_of(path) == 0
    new = simple.GeodesicPath(Input=source, WaypointPositions=points[:6].ravel().tolist(), **options)
    new.UpdateVTKObjects()
    new.GetClientSideObject().Update()
    if harness.IS_FIRST:
        assert np.array_equal(moved, lengths(new.GetClientSideObject())), (moved, lengths(new.GetClientSideObject()))
    return source, path


def check_normals():
    """Normals that change on one rank alone are those of the path, so that all ranks search again."""
    source, path = check_segments()
    data = source.GetClientSideObject().GetOutputDataObject(0)
    if RANK == 1:
        normals = numpy_to_vtk(np.tile([0.0, 0.0, 1.0], (data.GetNumberOfPoints(), 1)), deep=True)
        normals.SetName("Normals")
        data.GetPointData().SetNormals(normals)
    algorithm = path.GetClientSideObject()
    algorithm.Modified()
    assert searches_of(path) == 5


def fails_in_phase(algorithm, phase):
    """Whether a run comes to a phase: one that it does not come to can't fail."""
    os.environ["SURFACEGEODESICS_FAULT"] = str(phase)
    messages = harness.messages_of(algorithm.Update)
    del os.environ["SURFACEGEODESICS_FAULT"]
    assert messages == "" or "A fault was injected" in messages, messages
    return messages != ""


def field_of(distance):
    return vtk_to_numpy(distance.GetClientSideObject().GetOutputDataObject(0).GetPointData().GetArray("GeodesicDistance"))


def check_lines():
    """Lines that stay are neither joined nor cut again: a run has far fewer phases beside its rounds."""
    points = [1.1, 0.3, 0.38, 0.2, 1.2, 0.3, -1.15, 0.25, -0.35]
    torus = source_of("torus")
    for name in ("SeedSource", "BarrierSource"):
        source = simple.PolyLineSource(Points=points)
        distance = simple.GeodesicDistance(Input=torus, SeedPositions=[-1, -0.9, 0.2], **{name: source})
        distance.UpdateVTKObjects()
        algorithm = distance.GetClientSideObject()
        assert harness.messages_of(algorithm.Update) == ""
        few = harness.informed(distance, "NumberOfRounds") + 250
        algorithm.Modified()
        assert not fails_in_phase(algorithm, few), name
        # Costs move along with the triangles round the lines.
        distance.CostArray = ["POINTS", "Cost"]
        distance.UpdateVTKObjects()
        assert harness.messages_of(algorithm.Update) == ""
        new = simple.GeodesicDistance(
            Input=torus, SeedPositions=[-1, -0.9, 0.2], CostArray=["POINTS", "Cost"], **{name: source})
        new.UpdateVTKObjects()
        new.GetClientSideObject().Update()
        assert np.array_equal(field_of(distance), field_of(new))
        source.Points = [1.12, *points[1:]]
        source.UpdateVTKObjects()
        assert fails_in_phase(algorithm, few), name


def check_motion():
    """A surface that turns and grows keeps its structure, on each rank if its cells there are the same: distances grow
    along."""
    surface = source_of("torus")
    first = surface.GetClientSideObject().GetOutputDataObject(0)
    seed = np.array([-1, -0.9, 0.2])
    distance = simple.GeodesicDistance(Input=surface, SeedPositions=seed.tolist())
    distance.UpdateVTKObjects()
    assert harness.messages_of(distance.GetClientSideObject().Update) == ""
    still = field_of(distance).copy()
    for step in range(1, 5):
        turn = 0.3 * step
        size = 1 + 0.2 * step
        matrix = size * np.array([[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1]])
        moved = vtkPolyData()
        moved.ShallowCopy(first)
        points = vtkPoints()
        points.SetData(numpy_to_vtk(vtk_to_numpy(first.GetPoints().GetData()).astype(float) @ matrix.T, deep=True))
        moved.SetPoints(points)
        if RANK == step % harness.RANKS:
            # Cells in another order are another structure.
            cells = vtkCellArray()
            ids = vtkIdList()
            count = first.GetNumberOfPolys()
            for cell in range(count):
                first.GetPolys().GetCellAtId((cell + step) % count, ids)
                cells.InsertNextCell(ids)
            moved.SetPolys(cells)
        elif RANK == (step + 1) % harness.RANKS:
            cells = vtkCellArray()
            cells.DeepCopy(first.GetPolys())
            moved.SetPolys(cells)
        surface.GetClientSideObject().SetOutput(moved)
        distance.SeedPositions = (matrix @ seed).tolist()
        distance.UpdateVTKObjects()
        assert harness.messages_of(distance.GetClientSideObject().Update) == ""
        assert np.allclose(field_of(distance), size * still, rtol=0, atol=1e-6), np.abs(field_of(distance) - size * still).max()


check_segments()
check_segments(BarrierSource=simple.PolyLineSource(Points=np.reshape(cases.points_on("bunny", 9), (-1, 3))[7:].ravel().tolist()))
check_normals()
check_lines()
check_motion()
if harness.IS_FIRST:
    print("segments, lines and the structure of moved surfaces are kept")
