# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces cut into a piece a rank, for the tests of this folder; runs on every rank.

Each rank makes the whole small surface and keeps its part of the triangles. What comes out is compared
by the point array PointNumber, the number that a point has in the whole surface.
"""

import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, VTK_TETRA, vtkCellArray, vtkDataSetAttributes, vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

DATA = os.path.join(os.path.dirname(__file__), "..", "Data")

HIDDEN = vtkDataSetAttributes.HIDDENCELL


def controller():
    return vtkMultiProcessController.GetGlobalController()


def bunny():
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(DATA, "Bunny.vtp"))
    reader.Update()
    data = reader.GetOutput()
    return (vtk_to_numpy(data.GetPoints().GetData()),
            vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def grid(rows, columns, is_periodic=False):
    """The triangles of a grid of points, two a square."""
    i, j = np.meshgrid(np.arange(rows if is_periodic else rows - 1),
                       np.arange(columns if is_periodic else columns - 1), indexing="ij")
    a = i * columns + j
    b = (i + 1) % rows * columns + j
    c = (i + 1) % rows * columns + (j + 1) % columns
    d = i * columns + (j + 1) % columns
    return np.vstack([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])


def icosahedron():
    t = (1 + 5 ** 0.5) / 2
    points = np.array([[-1, t, 0], [1, t, 0], [-1, -t, 0], [1, -t, 0], [0, -1, t], [0, 1, t],
                       [0, -1, -t], [0, 1, -t], [t, 0, -1], [t, 0, 1], [-t, 0, -1], [-t, 0, 1]], float)
    cells = np.array([[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4],
                      [11, 10, 2], [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8],
                      [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1]])
    return points, cells


def subdivided(points, cells, times):
    """Each triangle cut into four; the same points come out of every part of a surface."""
    for _ in range(times):
        ends = np.sort(np.vstack([cells[:, [0, 1]], cells[:, [1, 2]], cells[:, [2, 0]]]), axis=1)
        keys, middles = np.unique(ends[:, 0] * len(points) + ends[:, 1], return_inverse=True)
        ab, bc, ca = middles.ravel().reshape(3, -1) + len(points)
        points = np.vstack([points, (points[keys // len(points)] + points[keys % len(points)]) / 2])
        a, b, c = cells.T
        cells = np.vstack([np.stack(t, -1) for t in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
    return points, cells


def on_sphere(points):
    return points / np.sqrt((points * points).sum(axis=1))[:, None]


def sphere(subdivisions=5):
    points, cells = subdivided(*icosahedron(), subdivisions)
    return on_sphere(points), cells


def torus(rows=120, columns=60):
    u, v = np.meshgrid(2 * np.pi * np.arange(rows) / rows, 2 * np.pi * np.arange(columns) / columns,
                       indexing="ij")
    r = 1 + 0.4 * np.cos(v)
    points = np.stack([r * np.cos(u), r * np.sin(u), 0.4 * np.sin(v)], -1).reshape(-1, 3)
    return points, grid(rows, columns, is_periodic=True)


def large():
    """So large that on its pieces, too, fronts of many seeds are in groups that take turns."""
    return torus(480, 240)


def thin(rows=60, columns=60):
    """A plane of triangles fifty times as long as wide."""
    u, v = np.meshgrid(np.arange(rows) / rows, np.arange(columns) / columns / 50, indexing="ij")
    jitter = np.random.default_rng(1).uniform(-0.3, 0.3, (2, rows, columns)) / columns / 50
    points = np.stack([u + jitter[0], v + jitter[1], np.zeros_like(u)], -1).reshape(-1, 3)
    return points, grid(rows, columns)


def flat():
    """A torus flattened so much that most of its triangles are thin."""
    points, cells = torus()
    return points * [1.0, 1.0 / 40, 1.0], cells


def square():
    u, v = np.meshgrid(np.arange(8.0), np.arange(8.0), indexing="ij")
    return np.stack([u, v, 0 * u], -1).reshape(-1, 3), grid(8, 8)


def triangle():
    return np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]), np.array([[0, 1, 2]])


def edge():
    """Two squares that have one edge in common: the lower one's last row is bent away from the upper one."""
    points, cells = square()
    other = points + [0, 7, 0]
    other[(points[:, 1] == 0) & ((points[:, 0] < 3) | (points[:, 0] > 4)), 2] = -0.5
    return weld(np.vstack([points, other]), np.vstack([cells, cells + len(points)]))


def corner():
    """Two squares that have one point in common."""
    points, cells = square()
    return weld(np.vstack([points, points + [7, 7, 0]]), np.vstack([cells, cells + len(points)]))


def parts():
    """Two squares that have nothing in common."""
    points, cells = square()
    return np.vstack([points, points + [0, 0, 5]]), np.vstack([cells, cells + len(points)])


def weld(points, cells):
    points, numbers = np.unique(points, axis=0, return_inverse=True)
    return points, numbers.ravel()[cells]


def brick(size=12):
    """A bent brick of hexahedra, and its lower half cut into tetrahedra: points, hexahedra, tetrahedra."""
    i, j, k = (a.ravel() for a in np.meshgrid(*[np.arange(size + 1)] * 3, indexing="ij"))
    number = np.arange(len(i)).reshape([size + 1] * 3)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = np.stack([number[a:a + size, b:b + size, c:c + size].ravel() for a, b, c in corners], -1)
    is_low = np.stack([i, j, k], -1)[cells[:, 0], 2] < size // 2
    tetrahedra = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
    points = np.stack([i, j + 0.1 * i, k], -1) / size
    return points, cells[~is_low], np.vstack([cells[is_low][:, t] for t in tetrahedra])


def in_boxes(middles, ranks):
    """The rank of each cell: boxes with equally many cells, cut across their longest side again and again."""
    owner = np.zeros(len(middles), int)

    def cut(cells, first, count):
        if count == 1:
            owner[cells] = first
            return
        axis = np.ptp(middles[cells], axis=0).argmax() if len(cells) else 0
        order = cells[np.argsort(middles[cells, axis], kind="stable")]
        half = len(cells) * (count // 2) // count
        cut(order[:half], first, count // 2)
        cut(order[half:], first + count // 2, count - count // 2)

    cut(np.arange(len(middles)), 0, ranks)
    return owner


SURFACES = {f.__name__: f for f in (bunny, sphere, torus, large, thin, flat, triangle, edge, corner, parts)}


def owners(points, cells, cut, ranks):
    """The rank of each triangle."""
    middles = points[cells].mean(axis=1)
    if cut == "random":
        return np.random.default_rng(7).integers(ranks, size=len(cells))
    if cut == "boxes":
        return in_boxes(middles, ranks)
    if cut == "halves":
        return np.arange(len(cells)) * ranks // len(cells)
    if cut == "first":
        return np.zeros(len(cells), int)
    if cut == "last":
        return np.full(len(cells), ranks - 1)
    order = np.argsort(middles @ [1.0, 0.1, 0.01], kind="stable")
    owner = np.empty(len(cells), int)
    owner[order] = np.arange(len(cells)) * ranks // len(cells)
    return owner


def polydata(points, corners):
    data = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(coordinates)
    polygons = vtkCellArray()
    polygons.SetData(3, numpy_to_vtkIdTypeArray(corners.ravel().astype(np.int64), deep=True))
    data.SetPolys(polygons)
    return data


def make_large(output, subdivisions):
    """This rank's slab of an icosphere, of which no rank ever makes more."""
    rank, ranks = controller().GetLocalProcessId(), controller().GetNumberOfProcesses()
    coarse = min(4, subdivisions)
    points, cells = subdivided(*icosahedron(), coarse)
    mine = cells[owners(points, cells, "slabs", ranks) == rank]
    used, corners = np.unique(mine, return_inverse=True)
    points, cells = subdivided(points[used], corners.reshape(-1, 3), subdivisions - coarse)
    output.ShallowCopy(polydata(on_sphere(points), cells))


def make_large_bunny(output, subdivisions):
    """This rank's box of the Bunny, whose triangles are cut in four several times."""
    rank, ranks = controller().GetLocalProcessId(), controller().GetNumberOfProcesses()
    points, cells = bunny()
    mine = cells[owners(points, cells, "boxes", ranks) == rank]
    used, corners = np.unique(mine, return_inverse=True)
    output.ShallowCopy(polydata(*subdivided(points[used].astype(float), corners.reshape(-1, 3), subdivisions)))


def make(output, surface, cut, with_ids=False, bad_rank=-1):
    """Fills a polydata with this rank's part; on the bad rank it has no costs."""
    rank, ranks = controller().GetLocalProcessId(), controller().GetNumberOfProcesses()
    output.ShallowCopy(part(surface, cut, rank, ranks, with_ids, bad_rank != rank))


def part(surface, cut, rank, ranks, with_ids=False, with_cost=True):
    """
    One of as many parts of a surface as there are ranks, with arrays to compute with.
    with_ids: whether there are global ids, 10, 13, 16, ...; or the first of them.
    """
    points, cells = SURFACES[surface]()
    mine = np.flatnonzero(owners(points, cells, cut, ranks) == rank)
    used, corners = np.unique(cells[mine], return_inverse=True)
    data = polydata(points[used], corners)

    def add(attributes, name, values):
        array = numpy_to_vtk(np.ascontiguousarray(values, float), deep=True)
        array.SetName(name)
        attributes.AddArray(array)
        return array

    where = points[used].astype(float)
    size = np.ptp(points, axis=0).max()
    along = (where @ [1.0, 0.3, 0.2]) / size
    add(data.GetPointData(), "PointNumber", used)
    if with_cost:
        add(data.GetPointData(), "Cost", 1.5 + np.sin(5 * along))
        # By orders of magnitude, so that a march is in the order of values.
        add(data.GetPointData(), "SpreadCost", np.exp(4 * np.sin(12.9898 * used)))
    add(data.GetPointData(), "BadCost", np.where(used == len(points) // 2, -1.0, 1.0))
    add(data.GetPointData(), "Region", np.where(np.abs(along - 0.1) < 0.05, 2.0, used % 997 == 5))
    add(data.GetPointData(), "Wall", (np.abs(along + 0.02) < 0.02) & (where[:, 1] > points[:, 1].mean()))
    add(data.GetCellData(), "CellRegion", mine % 1000 == 3)
    middles = points[cells[mine]].mean(axis=1)
    add(data.GetCellData(), "CellWall",
        ((np.abs(middles[:, 0] / size) < 0.05) & (middles[:, 1] > points[:, 1].mean())))
    if with_ids:
        first = 10 if with_ids is True else with_ids
        ids = numpy_to_vtkIdTypeArray(used.astype(np.int64) * 3 + first, deep=True)
        ids.SetName("GlobalIds")
        data.GetPointData().SetGlobalIds(ids)
    return data


def make_brick(output, cut):
    """Fills an unstructured grid: whole on the first rank, in boxes, or the cells of all dealt out at random."""
    rank, ranks = controller().GetLocalProcessId(), controller().GetNumberOfProcesses()
    points, *kinds = brick()
    random = np.random.default_rng(11)
    owners = [random.integers(ranks if cut == "random" else 1, size=len(kind)) for kind in kinds]
    if cut == "boxes":
        middles = np.vstack([points[kind].mean(axis=1) for kind in kinds])
        owners = np.split(in_boxes(middles, ranks), [len(kinds[0])])
    kinds = [kind[owner == rank] for kind, owner in zip(kinds, owners)]
    used = np.unique(np.concatenate([kind.ravel() for kind in kinds]))
    types = np.concatenate([np.full(len(kind), type) for kind, type in zip(kinds, (VTK_HEXAHEDRON, VTK_TETRA))])
    sizes = np.concatenate([np.full(len(kind), kind.shape[1]) for kind in kinds])
    corners = np.concatenate([np.searchsorted(used, kind).ravel() for kind in kinds])
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(corners.astype(np.int64), deep=True))
    grid_of_rank = vtkUnstructuredGrid()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points[used]), deep=True))
    grid_of_rank.SetPoints(coordinates)
    grid_of_rank.SetCells(numpy_to_vtk(types.astype(np.uint8), deep=True), cells)
    numbers = numpy_to_vtk(used.astype(float), deep=True)
    numbers.SetName("PointNumber")
    grid_of_rank.GetPointData().AddArray(numbers)
    output.ShallowCopy(grid_of_rank)


def make_blocks(output, surface):
    """Fills partitioned data with the two parts that this rank has of twice as many as there are ranks."""
    rank, ranks = controller().GetLocalProcessId(), controller().GetNumberOfProcesses()
    output.SetNumberOfPartitions(2)
    for i in range(2):
        output.SetPartition(i, part(surface, "slabs", 2 * rank + i, 2 * ranks))


def make_multiblock(output, surface):
    """Fills blocks: of the first one each rank has a part, and each has one that is empty on the others."""
    rank, ranks = controller().GetLocalProcessId(), controller().GetNumberOfProcesses()
    output.SetNumberOfBlocks(1 + ranks)
    for block, slab in ((0, 2 * rank), (1 + rank, 2 * rank + 1)):
        output.SetBlock(block, part(surface, "slabs", slab, 2 * ranks))


def part_path(path, rank):
    return f"{path}.{rank}.npz"


def blocks_of(data):
    """The data sets of a composite one; another is its only block."""
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    place = data.NewIterator()
    blocks = []
    while not place.IsDoneWithTraversal():
        blocks.append(place.GetCurrentDataObject())
        place.GoToNextItem()
    return blocks


def is_visible(block):
    """Which points have a value: all but those that only hidden faces use."""
    ghosts = block.GetCellData().GetArray("vtkGhostType")
    if ghosts is None or block.GetNumberOfPolys() == 0:
        return slice(None)
    sizes = np.diff(vtk_to_numpy(block.GetPolys().GetOffsetsArray()))
    is_shown = (vtk_to_numpy(ghosts) & HIDDEN) == 0
    visible = np.zeros(block.GetNumberOfPoints(), bool)
    visible[vtk_to_numpy(block.GetPolys().GetConnectivityArray())[np.repeat(is_shown, sizes)]] = True
    return visible


def store(data, path):
    """Writes what this rank has, and waits for the others to have done so."""
    rank = controller().GetLocalProcessId()
    blocks = blocks_of(data)
    arrays = {}
    for name in ("PointNumber", "GeodesicDistance", "NearestSeed"):
        of_blocks = [block.GetPointData().GetArray(name) for block in blocks]
        if all(array is not None for array in of_blocks):
            arrays[name] = np.concatenate(
                [vtk_to_numpy(array)[is_visible(block)] for array, block in zip(of_blocks, blocks)])
    np.savez(part_path(path, rank), points=sum(block.GetNumberOfPoints() for block in blocks), **arrays)
    controller().Barrier()
