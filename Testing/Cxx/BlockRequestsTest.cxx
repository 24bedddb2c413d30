// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// What a request names on blocks: point ids, arrays, selections, sources, and the blocks of paths.

#include "BlockParts.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSurfaceGeodesicPath.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

using namespace geodesic::testing;

namespace
{

using BlockRequests = Blocks;

vtkSmartPointer<vtkSelection> selectionOf(int kind, unsigned int block, std::vector<vtkIdType> ids)
{
  vtkNew<vtkIdTypeArray> list;
  for (const vtkIdType id : ids)
  {
    list->InsertNextValue(id);
  }
  vtkNew<vtkSelectionNode> node;
  node->SetFieldType(kind);
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetSelectionList(list);
  if (block > 0)
  {
    node->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), static_cast<int>(block));
  }
  auto selection = vtkSmartPointer<vtkSelection>::New();
  selection->AddNode(node);
  return selection;
}

}

TEST_F(BlockRequests, PointIdsAreGlobalIds)
{
  const auto bunny = readData("Bunny.vtp");
  this->Filter->AddSeedPointId(20000);
  const auto whole = this->wholeField(bunny);
  const auto first = scatteredPart(bunny, 0, 2);
  const auto second = scatteredPart(bunny, 1, 2);
  const auto input = blocksOf({ first, second });
  this->expectError(input, "Make GlobalPointIds");
  setWholeIds(first);
  input->Modified();
  this->expectError(input, "Make GlobalPointIds");
  setWholeIds(second);
  input->Modified();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(this->run(input));
  expectSame(output->GetBlock(0), whole);
  expectSame(output->GetBlock(1), whole);
  this->Filter->AddSeedPointId(1234567);
  this->expectError(input, "Seed point id 1234567 does not exist");
}

TEST_F(BlockRequests, EveryBlockNeedsTheArrays)
{
  const auto left = square(4);
  const auto right = squareAt(4.0, 0.0);
  const auto input = blocksOf({ left, right });
  input->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "right");
  const auto give = [](vtkPolyData* surface, double value)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName("cost");
    array->SetNumberOfTuples(surface->GetNumberOfPoints());
    array->FillValue(value);
    surface->GetPointData()->AddArray(array);
  };
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->Filter->SetInputArrayToProcess(
    vtkSurfaceGeodesicDistance::COST_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "cost");
  give(left, 2.0);
  this->expectError(input, "is not a point array of block \"right\"");
  give(right, 0.0);
  input->Modified();
  this->expectError(input, "is 0 at point 0 of block \"right\"");
  give(right, 2.0);
  input->Modified();
  this->run(input);
  EXPECT_NEAR(this->Filter->GetMaximumDistanceReached(), 2.0 * std::hypot(8.0, 4.0), 1e-9);
}

TEST_F(BlockRequests, SelectionsAreOfTheirBlock)
{
  const auto input = blocksOf({ square(4), squareAt(4.0, 0.0) });
  const auto select = [&](vtkSelection* selection)
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(selection);
    this->Filter->SetSeedSelectionConnection(producer->GetOutputPort());
  };
  // The right upper corner.
  select(selectionOf(vtkSelectionNode::POINT, 2, { 24 }));
  this->run(input);
  EXPECT_NEAR(this->Filter->GetMaximumDistanceReached(), std::hypot(8.0, 4.0), 1e-9);
  // A triangle in the right lower corner.
  select(selectionOf(vtkSelectionNode::CELL, 2, { 6 }));
  auto* output = vtkMultiBlockDataSet::SafeDownCast(this->run(input));
  EXPECT_EQ(distancesOf(output->GetBlock(1))->GetComponent(4, 0), 0.0);
  EXPECT_NEAR(distancesOf(output->GetBlock(0))->GetComponent(0, 0), 7.0, 1e-9);
  select(selectionOf(vtkSelectionNode::POINT, 2, { 99 }));
  this->expectError(input, "has no point or cell of the surface");
}

TEST_F(BlockRequests, SourcesOfSeveralBlocksCountInAll)
{
  const auto line = [](double x)
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(x, 0.0, 0.0);
    points->InsertNextPoint(x, 4.0, 0.0);
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({ 0, 1 });
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(lines);
    return data;
  };
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(blocksOf({ line(0.0), nullptr, line(3.0) }));
  this->Filter->SetSeedSourceConnection(producer->GetOutputPort());
  this->Filter->ComputeNearestSeedOn();
  auto* output = vtkPolyData::SafeDownCast(this->run(square(4)));
  EXPECT_NEAR(this->Filter->GetMaximumDistanceReached(), 1.0, 1e-12);
  EXPECT_EQ(output->GetPointData()->GetArray("NearestSeed")->GetComponent(9, 0), 1.0);

  // The same lines as barriers enclose (1.5, 2).
  this->Filter->SetSeedSourceConnection(nullptr);
  this->Filter->SetBarrierSourceConnection(producer->GetOutputPort());
  this->Filter->AddSeedPosition(1.5, 2.0, 0.0);
  this->run(square(4));
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 10);
}

TEST_F(BlockRequests, HiddenCellsAreNoSurface)
{
  const auto surface = square(4);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    // The second column of cells; all others are ghosts of other pieces, which count.
    ghosts->InsertNextValue(
      cell / 2 % 4 == 1 ? vtkDataSetAttributes::HIDDENCELL : vtkDataSetAttributes::DUPLICATECELL);
  }
  surface->GetCellData()->AddArray(ghosts);
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->run(surface);
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 10);
}

// Blocks that have names may move to other places, with all that they hold unchanged.
TEST_F(BlockRequests, ThatMoveAreNamedByTheirNewPlaces)
{
  const auto input = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const auto add = [&](unsigned int place, vtkDataObject* block, const char* name)
  {
    input->SetBlock(place, block);
    input->GetMetaData(place)->Set(vtkCompositeDataSet::NAME(), name);
  };
  const auto first = square(2);
  const auto second = square(2);
  add(0, first, "first");
  add(1, second, "second");
  vtkNew<vtkSurfaceGeodesicPath> filter;
  filter->SetInputDataObject(input);
  filter->SetConnectBlocks(false);
  for (const double coordinate : { 0.0, 0.0, 0.0, 2.0, 1.0, 0.0 })
  {
    filter->AddWaypointCoordinate(coordinate);
  }
  const auto blocksOfPath = [&]
  {
    EXPECT_EQ(errorsOf(filter.Get()), "");
    vtkDataArray* blocks =
      vtkPolyData::SafeDownCast(filter->GetOutput())->GetPointData()->GetArray("OriginalBlocks");
    return std::pair(blocks->GetRange()[0], blocks->GetRange()[1]);
  };
  EXPECT_EQ(blocksOfPath(), std::pair(1.0, 1.0));
  const vtkNew<vtkPolyData> empty;
  add(0, empty, "empty");
  add(1, first, "first");
  add(2, second, "second");
  EXPECT_EQ(blocksOfPath(), std::pair(2.0, 2.0));
}

TEST_F(BlockRequests, PathsCrossThemAsTheWhole)
{
  const auto bunny = readData("Bunny.vtp");
  const auto trace = [&](vtkDataObject* input)
  {
    vtkNew<vtkSurfaceGeodesicPath> filter;
    for (const vtkIdType waypoint : { 17, 20000, 4000 })
    {
      double p[3];
      bunny->GetPoint(waypoint, p);
      for (const double x : p)
      {
        filter->AddWaypointCoordinate(x);
      }
    }
    filter->SetInputDataObject(input);
    EXPECT_EQ(errorsOf(filter.Get()), "");
    return vtkSmartPointer<vtkPolyData>(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)));
  };
  const auto truth = trace(bunny);
  const auto first = scatteredPart(bunny, 0, 2);
  const auto second = scatteredPart(bunny, 1, 2);
  const auto input = blocksOf({ first, second });
  const auto expectTruth = [&](vtkPolyData* path)
  {
    ASSERT_EQ(path->GetNumberOfPoints(), truth->GetNumberOfPoints());
    for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
    {
      double p[3];
      double q[3];
      path->GetPoint(i, p);
      truth->GetPoint(i, q);
      EXPECT_NEAR(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 0.0, 1e-9);
      const auto normalOf = [&](vtkPolyData* data)
      { return data->GetPointData()->GetNormals()->GetComponent(i, 0); };
      EXPECT_NEAR(normalOf(path), normalOf(truth), 1e-6);
    }
  };
  // Ids in blocks: with the block's number.
  auto path = trace(input);
  expectTruth(path);
  vtkPointData* arrays = path->GetPointData();
  ASSERT_TRUE(arrays->GetArray("OriginalBlocks"));
  for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
  {
    const double block = arrays->GetArray("OriginalBlocks")->GetComponent(i, 0);
    const auto id =
      static_cast<vtkIdType>(arrays->GetArray("OriginalPointIds")->GetComponent(i, 0));
    vtkPolyData* part = block == 1.0 ? first : second;
    EXPECT_EQ(part->GetPointData()->GetArray("Whole")->GetComponent(id, 0),
      truth->GetPointData()->GetArray("OriginalPointIds")->GetComponent(i, 0));
  }
  // Global ids.
  setWholeIds(first);
  setWholeIds(second);
  path = trace(input);
  expectTruth(path);
  EXPECT_FALSE(path->GetPointData()->GetArray("OriginalBlocks"));
  for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(path->GetPointData()->GetArray("EdgePointIds")->GetComponent(i, 1),
      truth->GetPointData()->GetArray("EdgePointIds")->GetComponent(i, 1));
  }
}
