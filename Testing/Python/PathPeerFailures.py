# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView's bundled plugin GeodesicMeasurement gets wrong about paths, each named by what should
be right, and right by the class vtkFastMarchingGeodesicPath of our Python package.

usage: PathPeerFailures.py
"""

import numpy as np
from surfacegeodesics import vtkFastMarchingGeodesicDistance, vtkFastMarchingGeodesicPath
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersModeling import vtkGeodesicPath

import testing

CELLS = 20


def ids(*numbers):
    result = vtkIdList()
    for number in numbers:
        result.InsertNextId(number)
    return result


def list_of(ids):
    return [ids.GetId(i) for i in range(ids.GetNumberOfIds())]


def surface_of(points, polygons=(), strips=()):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetDataTypeToDouble()
    for point in points:
        data.GetPoints().InsertNextPoint(point)
    for set_cells, cells in ((data.SetPolys, polygons), (data.SetStrips, strips)):
        array = vtkCellArray()
        for cell in cells:
            array.InsertNextCell(len(cell), cell)
        set_cells(array)
    return data


def square(scale=1.0):
    """Points and triangles of [0, scale]^2, points row by row."""
    n = CELLS + 1
    points = [(scale * i / CELLS, scale * j / CELLS, 0) for j in range(n) for i in range(n)]
    cells = []
    for j in range(CELLS):
        for i in range(CELLS):
            a = j * n + i
            cells += [(a, a + 1, a + n + 1), (a, a + n + 1, a + n)]
    return points, cells


# Neither along edges nor along diagonals.
BEGIN, END = 2 * (CELLS + 1) + 1, 15 * (CELLS + 1) + 18


def path_on(surface, begin=BEGIN, seed=END, **options):
    path = vtkFastMarchingGeodesicPath()
    path.SetInputData(surface)
    path.SetBeginPointId(begin)
    path.SetSeeds(ids(seed))
    for name, value in options.items():
        getattr(path, f"Set{name}")(value)
    return path


def expect_straight(surface, begin=BEGIN, seed=END):
    truth = np.linalg.norm(np.subtract(surface.GetPoint(begin), surface.GetPoint(seed)))
    for straighten in (False, True):
        path = path_on(surface, begin, seed, Straighten=straighten)
        assert testing.messages_of(path.Update) == ""
        assert abs(path.GetGeodesicLength() / truth - 1) < 1e-9, path.GetGeodesicLength() / truth


def the_class_is_vtks_own_kind():
    path = path_on(surface_of(*square()))
    assert isinstance(path, vtkGeodesicPath)
    assert type(path.GetGeodesic()) is vtkFastMarchingGeodesicDistance
    path.Update()
    points = vtk_to_numpy(path.GetOutput().GetPoints().GetData())
    assert points.dtype == float
    assert len(list_of(path.GetFirstOrderPathPointIds())) == 2 * len(points)
    path.SetInterpolationOrder(0)
    path.Update()
    corners = list_of(path.GetZerothOrderPathPointIds())
    assert (corners[0], corners[-1]) == (BEGIN, END)


def costs_count_on_the_first_run_and_can_be_taken_back():  # 1, 2
    surface = surface_of(*square())
    points = vtk_to_numpy(surface.GetPoints().GetData())
    # Dear, but for a lane along the border.
    weights = numpy_to_vtk(np.where(points[:, 0] > 0.1, 100.0, 1.0), deep=True)
    path = path_on(surface, begin=0, seed=CELLS * (CELLS + 1) + 3)
    path.GetGeodesic().SetPropagationWeights(weights)
    path.Update()
    assert np.mean(vtk_to_numpy(path.GetOutput().GetPoints().GetData())[:, 0] < 0.11) > 0.9
    path.GetGeodesic().SetPropagationWeights(None)
    path.Update()
    assert abs(path.GetGeodesicLength() - np.hypot(1, 0.15)) < 1e-9


def where_there_is_no_way_is_an_error():  # 3
    points, cells = square()
    far = len(points)
    surface = surface_of([*points, (5, 0, 0), (6, 0, 0), (5, 1, 0)], [*cells, (far, far + 1, far + 2)])
    path = path_on(surface, seed=far)
    messages = testing.messages_of(path.Update)
    assert f"no path from begin point {BEGIN} to seed point {far}" in messages, messages
    assert path.GetOutput().GetNumberOfPoints() == 0
    path.SetSeeds(ids(END))
    assert testing.messages_of(path.Update) == ""
    assert path.GetOutput().GetNumberOfPoints() > 1


def all_kinds_of_cells_are_served():  # 4
    ladder = [(i // 2, i % 2, 0) for i in range(10)]
    expect_straight(surface_of(ladder, strips=[range(10)]), 0, 9)
    expect_straight(surface_of(
        ladder, polygons=[(2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1) for i in range(4)]), 0, 9)
    points, cells = square()
    expect_straight(surface_of([*points, (7, 7, 7)], cells))
    assert "no surface" in testing.messages_of(path_on(surface_of([])).Update)


def a_path_between_equal_points_has_length_zero():  # 5
    path = path_on(surface_of(*square()), seed=BEGIN)
    assert testing.messages_of(path.Update) == ""
    assert path.GetGeodesicLength() == 0
    assert path.GetOutput().GetNumberOfCells() == 1
    assert list_of(path.GetZerothOrderPathPointIds()) == [BEGIN]


def the_unit_of_length_does_not_matter():  # 8
    for scale in (1, 1000, 1e-6, 1e6):
        expect_straight(surface_of(*square(scale)))


def all_sheets_of_an_edge_are_crossed():  # 10
    # Three half planes that meet in the edge x = z = 0: from one to another as if they were flat.
    points, cells = [(0, y / 10, 0) for y in range(11)], []
    sheets = []
    for angle in (0, 2, 4):
        last, sheet = list(range(11)), [list(range(11))]
        for step in range(1, 11):
            new = list(range(len(points), len(points) + 11))
            points += [(step / 10 * np.cos(angle), y / 10, step / 10 * np.sin(angle)) for y in range(11)]
            cells += [(last[i], new[i], new[i + 1]) for i in range(10)]
            cells += [(last[i], new[i + 1], last[i + 1]) for i in range(10)]
            sheet.append(new)
            last = new
        sheets.append(sheet)
    for a, b in ((0, 1), (1, 2), (2, 0)):
        path = path_on(surface_of(points, cells), sheets[a][7][1], sheets[b][4][9], Straighten=True)
        path.Update()
        assert abs(path.GetGeodesicLength() - np.hypot(1.1, 0.8)) < 1e-12


def doubled_triangles_change_nothing():  # 10
    points, cells = square()
    expect_straight(surface_of(points, cells + cells[::2]))


def a_triangle_with_a_repeated_point_changes_nothing():  # 10
    points, cells = square()
    expect_straight(surface_of(points, [(4, 4, 9), *cells, (30, 31, 31)]))


def a_point_that_does_not_exist_is_an_error():  # 19
    count = (CELLS + 1) ** 2
    for id in (-1, count, 1 << 40):
        for ends in ((id, END), (BEGIN, id)):
            messages = testing.messages_of(path_on(surface_of(*square()), *ends).Update)
            assert f"id {id} does not exist: the input has {count} points" in messages, messages


for failure in [
        the_class_is_vtks_own_kind,
        costs_count_on_the_first_run_and_can_be_taken_back,
        where_there_is_no_way_is_an_error,
        all_kinds_of_cells_are_served,
        a_path_between_equal_points_has_length_zero,
        the_unit_of_length_does_not_matter,
        all_sheets_of_an_edge_are_crossed,
        doubled_triangles_change_nothing,
        a_triangle_with_a_repeated_point_changes_nothing,
        a_point_that_does_not_exist_is_an_error]:
    print(failure.__name__, flush=True)
    failure()
