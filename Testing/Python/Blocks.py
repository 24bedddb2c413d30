# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Blocks, grids and images in ParaView: one surface where they share points, whatever holds them.

usage: Blocks.py OUR_PLUGIN
"""

import os
import sys
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

import testing

testing.load(sys.argv[1])

NOSE = [-0.0755, 0.1245, 0.052]


def output_of(proxy):
    """The output itself: to fetch it fails with partitioned data sets."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def leaves_of(proxy):
    """The data sets of a composite output, by their names."""
    output = output_of(proxy)
    leaves = {}
    iterator = output.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        name = None
        if iterator.HasCurrentMetaData():
            name = iterator.GetCurrentMetaData().Get(vtkCompositeDataSet.NAME())
        leaves[name or iterator.GetCurrentFlatIndex()] = iterator.GetCurrentDataObject()
        iterator.GoToNextItem()
    return leaves


def values_of(leaf, name):
    return vtk_to_numpy(leaf.GetPointData().GetArray(name))


def with_global_ids(proxy):
    """The same blocks, and points at the same place have the same id, whatever block they are in. From ParaView 5.13 on its
    own filter counts from 0 in every block."""
    data = output_of(proxy).NewInstance()
    data.DeepCopy(output_of(proxy))
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    leaves = leaves_of(source).values()
    points = [vtk_to_numpy(leaf.GetPoints().GetData()) for leaf in leaves]
    _, ids = np.unique(np.concatenate(points), axis=0, return_inverse=True)
    first = 0
    for leaf in leaves:
        count = leaf.GetNumberOfPoints()
        array = numpy_to_vtkIdTypeArray(ids.ravel()[first:first + count].astype(np.int64), deep=True)
        array.SetName("GlobalPointIds")
        leaf.GetPointData().SetGlobalIds(array)
        first += count
    return source


def expect_whole(proxy, count, name="whole"):
    """Every leaf has the distances that it had before the surface was cut."""
    leaves = leaves_of(proxy)
    assert len(leaves) == count, leaves
    for leaf in leaves.values():
        assert leaf.IsA("vtkPolyData")
        whole = values_of(leaf, name)
        assert np.allclose(values_of(leaf, "GeodesicDistance"), whole, rtol=0, atol=1e-9 * whole.max())


def offered(proxy, name):
    """The arrays that the panel offers."""
    domain = proxy.GetProperty(name).SMProperty.GetDomain("array_list")
    return [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]


# --- The Bunny, cut without touching a cell, in every kind of holder ---

bunny = testing.bunny()
count = testing.output_of(bunny).GetNumberOfCells()
numbered = testing.with_arrays(bunny, cells={"cell": np.arange(count)})
whole = simple.GeodesicDistance(Input=numbered, SeedPositions=NOSE, DistanceArrayName="whole")


def cells_from(low, high):
    return simple.Threshold(
        Input=whole, Scalars=["CELLS", "cell"], LowerThreshold=low, UpperThreshold=high)


# Unstructured grids of triangles, and one polydata.
parts = [
    cells_from(0, count // 3),
    simple.ExtractSurface(Input=cells_from(count // 3 + 1, count // 2)),
    cells_from(count // 2 + 1, count)]
for output_type in ("vtkMultiBlockDataSet", "vtkPartitionedDataSet", "vtkPartitionedDataSetCollection"):
    group = simple.GroupDatasets(Input=parts, OutputType=output_type)
    distance = simple.GeodesicDistance(Input=group, SeedPositions=NOSE)
    assert output_of(distance).GetClassName() == output_of(group).GetClassName() == output_type
    assert list(leaves_of(distance)) == list(leaves_of(group))
    expect_whole(distance, 3)

group = simple.GroupDatasets(Input=parts, OutputType="vtkMultiBlockDataSet", BlockNames=["a", "b", "c"])
outer = simple.GroupDatasets(Input=[group], OutputType="vtkMultiBlockDataSet")
distance = simple.GeodesicDistance(Input=outer, SeedPositions=NOSE)
expect_whole(distance, 3)
assert list(leaves_of(distance)) == ["a", "b", "c"]

# Apart: only the block with the nose has distances.
distance.ConnectBlocks = 0
reached = {name: np.isfinite(values_of(leaf, "GeodesicDistance")).any()
           for name, leaf in leaves_of(distance).items()}
assert sorted(reached.values()) == [False, False, True], reached
distance.ConnectBlocks = 1

# --- A path over the blocks is the path over the whole ---

WAYPOINTS = [*NOSE, 0.02, 0.06, 0.04]
alone = simple.GeodesicPath(Input=bunny, WaypointPositions=WAYPOINTS)
across = simple.GeodesicPath(Input=group, WaypointPositions=WAYPOINTS)
assert np.allclose(testing.points_of(across), testing.points_of(alone), rtol=0, atol=1e-9)
assert abs(testing.informed(across, "TotalLength") - testing.informed(alone, "TotalLength")) < 1e-9

# --- Ids ---

testing.expect_error(
    simple.GeodesicDistance(Input=group, SeedPointIds=[5]), "Seed point id 5", "GlobalPointIds", "positions")
ids = with_global_ids(group)
by_id = simple.GeodesicDistance(Input=ids, SeedPointIds=[5], MergeCoincidentPoints=0)
zeros = [(name, values_of(leaf, "GlobalPointIds")[values_of(leaf, "GeodesicDistance") == 0].tolist())
         for name, leaf in leaves_of(by_id).items()]
assert {i for _, found in zeros for i in found} == {5}, zeros
assert all(np.isfinite(values_of(leaf, "GeodesicDistance")).all() for leaf in leaves_of(by_id).values())

# An id that neither an int nor a double holds.
LARGE = 2**60 + 1
shifted = output_of(ids).NewInstance()
shifted.DeepCopy(output_of(ids))
source = simple.TrivialProducer()
source.GetClientSideObject().SetOutput(shifted)
for leaf in leaves_of(source).values():
    values_of(leaf, "GlobalPointIds")[:] += LARGE
by_large_id = simple.GeodesicDistance(Input=source, SeedPointIds=[LARGE + 5], MergeCoincidentPoints=0)
for name, leaf in leaves_of(by_id).items():
    np.testing.assert_array_equal(
        values_of(leaf, "GeodesicDistance"), values_of(leaves_of(by_large_id)[name], "GeodesicDistance"))
testing.expect_error(
    simple.GeodesicDistance(Input=source, SeedPointIds=[5]), "Seed point id 5", "GlobalPointIds")

# --- Arrays: offered in the panel; one that a block lacks is named ---

constant = simple.Calculator(Input=group, ResultArrayName="two", Function="2")
constant.UpdatePipeline()
costly = simple.GeodesicDistance(Input=constant, SeedPositions=NOSE)
assert "two" in offered(costly, "CostArray")
costly.CostArray = ["POINTS", "two"]
for leaf in leaves_of(costly).values():
    assert np.allclose(values_of(leaf, "GeodesicDistance"), 2 * values_of(leaf, "whole"), rtol=1e-9)
some = simple.GroupDatasets(
    Input=[simple.Calculator(Input=parts[0], ResultArrayName="two", Function="2"), *parts[1:]],
    OutputType="vtkMultiBlockDataSet", BlockNames=["a", "b", "c"])
some.UpdatePipeline()
partial = simple.GeodesicDistance(Input=some, SeedPositions=NOSE)
assert "two" in offered(partial, "CostArray")
partial.CostArray = ["POINTS", "two"]
testing.expect_error(partial, "CostArray", "two", 'not a point array of block "b"', "or choose None")

# --- Selected in a view: points of the blocks ---

view = simple.CreateView("RenderView")
shown = simple.Show(group, view)
shown.Representation = "Surface"
simple.ResetCamera(view)
simple.Render(view)
simple.SetActiveSource(group)
simple.SelectSurfacePoints(Rectangle=[0, 0, *[int(s) for s in view.ViewSize]], View=view)
selection = servermanager._getPyProxy(group.SMProxy.GetSelectionInput(group.Port))
extracted = simple.ExtractSelection(Input=group, Selection=selection)
chosen = np.unique(np.vstack([
    vtk_to_numpy(leaf.GetPoints().GetData()) for leaf in leaves_of(extracted).values()]), axis=0)
assert 100 < len(chosen) < 30000, len(chosen)
selected = simple.GeodesicDistance(Input=group, SeedSelection=selection)
seeds = np.unique(np.vstack([
    vtk_to_numpy(leaf.GetPoints().GetData())[values_of(leaf, "GeodesicDistance") == 0]
    for leaf in leaves_of(selected).values()]), axis=0)
assert np.array_equal(seeds, chosen)

# --- Grids and images against Extract Surface ---

image = simple.Wavelet(WholeExtent=[-6, 6, -5, 5, -4, 4])
for volume in (image, simple.Tetrahedralize(Input=image)):
    options = dict(SeedPositions=[0.3, 0.2, 4], CostArray=["POINTS", "RTData"])
    truth = simple.GeodesicDistance(Input=simple.ExtractSurface(Input=volume), **options)
    found = simple.GeodesicDistance(Input=volume, **options)
    assert testing.output_of(found).IsA("vtkPolyData")
    field = {tuple(p): d for p, d in zip(testing.points_of(truth), testing.array_of(truth))}
    for p, d in zip(testing.points_of(found), testing.array_of(found)):
        assert abs(field[tuple(p)] - d) < 1e-9 * max(field.values())
    original = testing.array_of(found, "vtkOriginalPointIds")
    volume_points = np.array([testing.output_of(volume).GetPoint(int(i)) for i in original])
    assert np.array_equal(volume_points, testing.points_of(found))

# --- A state file gives all of it back ---

simple.ResetSession()
testing.load(sys.argv[1])
squares = simple.GroupDatasets(
    Input=[simple.Plane(Origin=[x, 0, 0], Point1=[x + 1, 0, 0], Point2=[x, 1, 0]) for x in (0, 1)])
simple.GeodesicDistance(registrationName="Connected", Input=squares, SeedPositions=[0, 0, 0])
simple.GeodesicDistance(registrationName="Apart", Input=squares, SeedPositions=[0, 0, 0], ConnectBlocks=0)
with tempfile.TemporaryDirectory() as folder:
    state = os.path.join(folder, "blocks.pvsm")
    simple.SaveState(state)
    simple.ResetSession()
    testing.load(sys.argv[1])
    simple.LoadState(state)
for name, farthest in (("Connected", 5 ** 0.5), ("Apart", 2 ** 0.5)):
    kept = simple.FindSource(name)
    kept.UpdatePipeline()
    assert abs(testing.informed(kept, "MaximumDistanceReached") - farthest) < 1e-6, name
