# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The proxy GeodesicRegion: areas against formulas, what of the surface stays, arrays, blocks, grids and errors.

usage: GeodesicRegion.py OUR_PLUGIN
"""

import collections
import math
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkStripper, vtkTriangleFilter

import testing

testing.load(sys.argv[1])

NOSE = [-0.0755, 0.1245, 0.052]


def output_of(proxy):
    """The output itself: its client and server are one process."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def source_of(data):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def cells_of(data):
    """The points of each polygon and each triangle of a strip."""
    polys = data.GetPolys()
    offsets = vtk_to_numpy(polys.GetOffsetsArray())
    points = vtk_to_numpy(polys.GetConnectivityArray())
    cells = [points[a:b] for a, b in zip(offsets, offsets[1:])]
    strips = data.GetStrips()
    offsets = vtk_to_numpy(strips.GetOffsetsArray())
    points = vtk_to_numpy(strips.GetConnectivityArray())
    for a, b in zip(offsets, offsets[1:]):
        cells += [points[i:i + 3] for i in range(a, b - 2)]
    return cells


def border_edges(data, names=None):
    """How many edges have one cell, and the most cells that an edge has."""
    count = collections.Counter()
    for cell in cells_of(data):
        ends = cell if names is None else names[cell]
        count.update(tuple(sorted((a, b))) for a, b in zip(ends, np.roll(ends, -1)))
    return sum(n == 1 for n in count.values()), max(count.values())


def array(data, name, of="Cell"):
    found = getattr(data, f"Get{of}Data")().GetAbstractArray(name)
    assert found is not None, name
    return vtk_to_numpy(found)


def areas_of(data):
    """The area of each polygon, which is flat."""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    areas = []
    for cell in cells_of(data):
        corners = points[cell] - points[cell[0]]
        areas.append(0.5 * np.linalg.norm(np.cross(corners[1:-1], corners[2:]).sum(axis=0)))
    return np.array(areas)


def circle(centre, radius, corners, turn=0.1):
    angles = turn + 2 * math.pi * np.arange(corners) / corners
    points = np.column_stack([np.cos(angles), np.sin(angles), 0 * angles])
    return np.asarray(centre) + radius * points


def plane(cells=10):
    """The unit square, of quadrilaterals, with double points."""
    return simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0], XResolution=cells, YResolution=cells)


def precise(proxy):
    """The same with double points."""
    data = output_of(proxy)
    copy = data.NewInstance()
    copy.DeepCopy(data)
    points = data.GetPoints().NewInstance()
    points.SetDataTypeToDouble()
    points.DeepCopy(data.GetPoints())
    double = np.round(vtk_to_numpy(data.GetPoints().GetData()).astype(float), 6)
    points.SetNumberOfPoints(len(double))
    for i, p in enumerate(double):
        points.SetPoint(i, *p)
    copy.SetPoints(points)
    return source_of(copy)


def area_of_polygon(radius, corners):
    return 0.5 * corners * radius**2 * math.sin(2 * math.pi / corners)


def measures(region):
    output_of(region)
    areas = testing.informed(region, "RegionAreas")
    perimeters = testing.informed(region, "RegionPerimeters")
    return list(np.atleast_1d(areas)), list(np.atleast_1d(perimeters))


# Nested polygons on a plane: areas and perimeters by formula; polygons beside the lines stay.
surface = precise(plane())
loops = simple.AppendDatasets(Input=[testing.polyline(circle([0.5, 0.5, 0], 0.4, 7), closed=True),
                                     testing.polyline(circle([0.5, 0.5, 0], 0.2, 5), closed=True)])
region = simple.GeodesicRegion(Input=surface, Lines=loops)
data = output_of(region)
areas, perimeters = measures(region)
outer, inner = area_of_polygon(0.4, 7), area_of_polygon(0.2, 5)
expected = sorted([1 - outer, outer - inner, inner], reverse=True)
# Lines come with single precision, so their corners are off by 1e-8.
assert np.allclose(areas, expected, atol=1e-7), (areas, expected)
assert abs(sum(areas) - 1) < 1e-12, areas
numbers = array(data, "GeodesicRegion")
own = areas_of(data)
for number in range(3):
    assert abs(own[numbers == number].sum() - areas[number]) < 1e-12
sizes = [len(cell) for cell in cells_of(data)]
assert set(sizes) == {3, 4}
assert border_edges(data) == (40, 2), border_edges(data)
assert testing.informed(region, "NumberOfRegions") == 3
assert np.allclose(array(data, "RegionArea", "Field"), areas)
assert np.allclose(array(data, "RegionPerimeter", "Field"), perimeters)
originals = array(data, "vtkOriginalCellIds")
input_cells = cells_of(output_of(surface))
for cell, original in zip(cells_of(data), originals):
    if len(cell) == 4:
        assert list(cell) == list(input_cells[original])
assert list(originals) == sorted(originals)

# A line of double points: to rounding. The square [0.25, 0.75] x [0.15, 0.65], and a cross.
square = vtkPolyData()
points = output_of(loops).GetPoints().NewInstance()
points.SetDataTypeToDouble()
for x, y in ((0.25, 0.15), (0.75, 0.15), (0.75, 0.65), (0.25, 0.65)):
    points.InsertNextPoint(x, y, 0)
square.SetPoints(points)
square.AllocateExact(1, 5)
square.InsertNextCell(4, 5, [0, 1, 2, 3, 0])
region = simple.GeodesicRegion(Input=surface, Lines=source_of(square))
areas, perimeters = measures(region)
assert np.allclose(areas, [0.75, 0.25], rtol=0, atol=1e-12), areas
assert np.allclose(perimeters, [6, 2], rtol=0, atol=1e-12), perimeters

# Inside first, then by area; extraction; an array that is linear in space stays so.
surface = precise(testing.with_arrays(plane(), points={"Linear": 3 * testing.points_of(plane())[:, 0] + 1},
                                      cells={"Cell": range(100)}))
region = simple.GeodesicRegion(Input=surface, Lines=source_of(square), InsidePositions=[0.5, 0.3, 0])
assert np.allclose(measures(region)[0], [0.25, 0.75], atol=1e-12)
data = output_of(region)
x = vtk_to_numpy(data.GetPoints().GetData())[:, 0]
assert np.allclose(array(data, "Linear", "Point"), 3 * x + 1, atol=1e-9)
assert np.array_equal(array(data, "Cell"), array(data, "vtkOriginalCellIds"))
ids = array(data, "vtkOriginalPointIds", "Point")
assert np.array_equal(ids[:121], np.arange(121)) and (ids[121:] == -1).all() and len(ids) > 121
whole = data.GetNumberOfCells()
parts = {}
for extract in ("Inside", "Outside"):
    region.Extract = extract
    parts[extract] = vtkPolyData()
    parts[extract].ShallowCopy(output_of(region))
    numbers = array(parts[extract], "GeodesicRegion")
    assert (numbers == 0).all() if extract == "Inside" else (numbers == 1).all()
    used = np.unique(np.concatenate(cells_of(parts[extract])))
    assert np.array_equal(used, np.arange(parts[extract].GetNumberOfPoints()))
    x = vtk_to_numpy(parts[extract].GetPoints().GetData())[:, 0]
    assert np.allclose(array(parts[extract], "Linear", "Point"), 3 * x + 1, atol=1e-9)
assert parts["Inside"].GetNumberOfCells() + parts["Outside"].GetNumberOfCells() == whole
assert abs(areas_of(parts["Inside"]).sum() - 0.25) < 1e-12
region.InsidePositions = [0.5, 0.3, 0, 0.01, 0.01, 0]
region.Extract = "Inside"
assert output_of(region).GetNumberOfCells() == whole
region.RegionArrayName = "Part"
assert output_of(region).GetCellData().GetArray("GeodesicRegion") is None
array(output_of(region), "Part")
region.RegionArrayName = ""
assert output_of(region).GetCellData().GetArray("Part") is None

# No lines: each component is a region.
two = simple.AppendGeometry(Input=[simple.Sphere(Center=[5, 0, 0]), plane()])
region = simple.GeodesicRegion(Input=two)
assert testing.informed(region, "NumberOfRegions") == 0
output_of(region)
assert testing.informed(region, "NumberOfRegions") == 2
assert output_of(region).GetNumberOfCells() == output_of(two).GetNumberOfCells()

# The equator of a sphere with normals: they have length 1 again, and the parts are watertight together.
sphere = simple.Sphere(ThetaResolution=24, PhiResolution=17)
ring = testing.polyline(0.6 * np.array([[1, 0, 0.1], [-0.4, 0.9, 0], [-0.6, -0.8, -0.1]]), closed=True)
region = simple.GeodesicRegion(Input=sphere, Lines=ring)
data = output_of(region)
assert testing.informed(region, "NumberOfRegions") == 2
normals = vtk_to_numpy(data.GetPointData().GetNormals())
assert np.allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)
assert border_edges(data) == (0, 2)
assert all(len(set(cell)) == len(cell) for cell in cells_of(data))

# A seam of texture coordinates: each side has its own point there, with its own coordinates.
halves = vtkAppendPolyData()
for x in (0, 1):
    half = output_of(simple.Plane(Origin=[x, 0, 0], Point1=[x + 1, 0, 0], Point2=[x, 1, 0], XResolution=4, YResolution=4))
    halves.AddInputData(half)
halves.Update()
across = testing.polyline([[0.1, 0.33, 0], [1.9, 0.47, 0]])
region = simple.GeodesicRegion(Input=source_of(halves.GetOutput()), Lines=simple.AppendDatasets(Input=[
    testing.polyline([[0, 0.33, 0], [2, 0.47, 0]])]))
data = output_of(region)
assert testing.informed(region, "NumberOfRegions") == 2, testing.informed(region, "ErrorText")
points = vtk_to_numpy(data.GetPoints().GetData())
seam = np.flatnonzero((points[:, 0] == 1) & (array(data, "vtkOriginalPointIds", "Point") == -1))
assert len(seam) == 2, points[seam]
coordinates = vtk_to_numpy(data.GetPointData().GetTCoords())[seam]
assert sorted(coordinates[:, 0]) == [0, 1], coordinates
assert np.allclose(coordinates[0, 1], coordinates[1, 1])
_, names = np.unique(points, axis=0, return_inverse=True)
assert border_edges(data, names.ravel())[1] == 2

# Strips: those that no line cuts stay.
triangles = vtkTriangleFilter()
triangles.SetInputData(output_of(plane(12)))
stripper = vtkStripper()
stripper.SetInputConnection(triangles.GetOutputPort())
stripper.SetMaximumLength(6)
stripper.Update()
strips = stripper.GetOutput()
region = simple.GeodesicRegion(Input=source_of(strips), Lines=source_of(square))
data = output_of(region)
assert 0 < data.GetNumberOfStrips() < strips.GetNumberOfStrips()
assert np.allclose(measures(region)[0], [0.75, 0.25], atol=1e-6)
assert len(array(data, "GeodesicRegion")) == data.GetNumberOfCells()
assert border_edges(data)[1] == 2

# Blocks that share points, by coordinates and by global ids, which new points get as well.
blocks = vtkMultiBlockDataSet()
for i in range(2):
    half = output_of(simple.Plane(Origin=[i, 0, 0], Point1=[i + 1, 0, 0], Point2=[i, 1, 0], XResolution=4, YResolution=4))
    copy = vtkPolyData()
    copy.ShallowCopy(half)
    points = vtk_to_numpy(half.GetPoints().GetData())
    ids = numpy_to_vtkIdTypeArray((100 * np.round(points[:, 0], 3) + 1000 * np.round(points[:, 1], 3)).astype(int), deep=1)
    ids.SetName("GlobalPointIds")
    copy.GetPointData().SetGlobalIds(ids)
    blocks.SetBlock(i, copy)
    blocks.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), f"half {i}")
lines = testing.polyline([[0, 0.33, 0], [2, 0.47, 0]])
region = simple.GeodesicRegion(Input=source_of(blocks), Lines=lines)
data = output_of(region)
assert data.GetMetaData(1).Get(vtkCompositeDataSet.NAME()) == "half 1"
areas, perimeters = measures(region)
assert np.allclose(areas, [2 - 0.8, 0.8], atol=1e-6), areas
new = []
for i in range(2):
    block = data.GetBlock(i)
    ids = vtk_to_numpy(block.GetPointData().GetGlobalIds())
    assert len(set(ids)) == len(ids)
    points = vtk_to_numpy(block.GetPoints().GetData())
    new.append([ids[k] for k in range(len(ids)) if points[k, 0] == 1])
    assert sum(areas_of(block)) - 1 < 1e-6
assert sorted(new[0]) == sorted(new[1]) and len(new[0]) == 6
again = simple.GeodesicRegion(Input=region)
assert len(measures(again)[0]) == 1

# A grid: its outer surface, with the grid's ids.
box = simple.Wavelet(WholeExtent=[0, 6, 0, 6, 0, 6])
region = simple.GeodesicRegion(Input=box, Lines=testing.polyline(
    [[0, 0, 2.5], [6, 0, 2.5], [6, 6, 2.5], [0, 6, 2.5]], closed=True), InsidePositions=[3, 3, 0])
areas, perimeters = measures(region)
assert np.allclose(areas, [36 + 24 * 2.5, 36 + 24 * 3.5], rtol=1e-9), areas
assert np.allclose(perimeters, [24, 24], rtol=1e-9)
data = output_of(region)
ids = array(data, "vtkOriginalPointIds", "Point")
points = vtk_to_numpy(data.GetPoints().GetData())
# On 24 upright edges, and on the diagonals between them.
assert (ids == -1).sum() == 48 and (points[ids == -1][:, 2] == 2.5).all()
assert np.allclose(points[ids >= 0], [output_of(box).GetPoint(i) for i in ids[ids >= 0]])

# The head of the Bunny: a closed path, and a point on the nose.
bunny = testing.bunny()
neck = simple.GeodesicPath(Input=bunny, Closed=1, WaypointPositions=[
    -0.05, 0.12, 0.04, -0.09, 0.10, 0.03, -0.05, 0.11, -0.02, -0.02, 0.14, 0.01])
region = simple.GeodesicRegion(Input=bunny, Lines=neck, InsidePositions=NOSE)
whole = areas_of(output_of(bunny)).sum()
areas, perimeters = measures(region)
assert abs(sum(areas) / whole - 1) < 1e-12
path_length = testing.informed(neck, "TotalLength")
assert border_edges(output_of(region)) == border_edges(output_of(bunny))

# What separates nothing is said in words, and so is what can't be done.
message = testing.messages_of(simple.GeodesicRegion(Input=plane(), Lines=testing.polyline(
    [[0.3, 0.3, 0], [0.7, 0.6, 0]])).UpdatePipeline)
assert "Line 0 of Lines separates nothing: it is open" in message, message
testing.expect_error(simple.GeodesicRegion(Input=plane(), Lines=plane()), "Lines has 121 points but no line")
testing.expect_error(simple.GeodesicRegion(Input=plane(), Extract="Inside"), "Extract is Inside", "InsidePositions")
testing.expect_error(simple.GeodesicRegion(Input=plane(), InsidePositions=[1, 2]), "InsidePositions has 2 numbers")
testing.expect_error(simple.GeodesicRegion(Input=surface, Lines=source_of(square), InsidePositions=[0.5, 0.15, 0]),
                     "Point 0 of InsidePositions lies on a line")
testing.expect_error(simple.GeodesicRegion(Input=testing.polyline([[0, 0, 0], [1, 0, 0]])), "The input has no surface")
