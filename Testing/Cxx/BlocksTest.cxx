// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks that share points are one surface: cut surfaces against the whole, squares against
// formulas.

#include "Inputs.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSurfaceGeodesicDistance.h"
#include "vtkSurfaceGeodesicPath.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>

using namespace geodesic::testing;

namespace
{

/** Some cells of a surface with points of their own; the array Whole tells which they were. */
vtkSmartPointer<vtkPolyData> partOf(
  vtkPolyData* surface, const std::function<bool(vtkIdType cell)>& isInside)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> faces;
  vtkNew<vtkIdTypeArray> whole;
  whole->SetName("Whole");
  std::map<vtkIdType, vtkIdType> numbers;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    if (!isInside(cell))
    {
      continue;
    }
    surface->GetCellPoints(cell, corners);
    faces->InsertNextCell(static_cast<int>(corners->GetNumberOfIds()));
    for (const vtkIdType corner : *corners)
    {
      const auto [entry, isNew] = numbers.emplace(corner, points->GetNumberOfPoints());
      if (isNew)
      {
        points->InsertNextPoint(surface->GetPoint(corner));
        whole->InsertNextValue(corner);
      }
      faces->InsertCellPoint(entry->second);
    }
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(points);
  part->SetPolys(faces);
  part->GetPointData()->AddArray(whole);
  return part;
}

/** One of so many parts, cut at random: the worst case. */
vtkSmartPointer<vtkPolyData> scatteredPart(vtkPolyData* surface, int part, int parts)
{
  return partOf(
    surface, [=](vtkIdType cell) { return cell * 2654435761u % 65521 % parts == unsigned(part); });
}

vtkSmartPointer<vtkPolyData> squareAt(double x, double y)
{
  vtkNew<vtkTransform> move;
  move->Translate(x, y, 0.0);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetTransform(move);
  moved->SetInputDataObject(square(4));
  moved->Update();
  return moved->GetOutput();
}

vtkSmartPointer<vtkMultiBlockDataSet> blocksOf(
  std::initializer_list<vtkSmartPointer<vtkDataObject>> leaves)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const auto& leaf : leaves)
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), leaf);
  }
  return blocks;
}

/** Gives an AMR data set one level with one block. VTK 9.6 changed the call. */
template <class AMR>
void addLevel(AMR& levels)
{
  if constexpr (requires { levels.Initialize(std::vector<unsigned int>{ 1 }); })
  {
    levels.Initialize(std::vector<unsigned int>{ 1 });
  }
  else
  {
    const int blocksPerLevel[] = { 1 };
    levels.Initialize(1, blocksPerLevel);
  }
}

void setGlobalIds(vtkPolyData* surface, const std::function<vtkIdType(vtkIdType point)>& idOf)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("GlobalPointIds");
  for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
  {
    ids->InsertNextValue(idOf(point));
  }
  surface->GetPointData()->SetGlobalIds(ids);
}

/** The id of the whole's point. */
void setWholeIds(vtkPolyData* part)
{
  auto* whole = vtkIdTypeArray::SafeDownCast(part->GetPointData()->GetArray("Whole"));
  setGlobalIds(part, [&](vtkIdType point) { return whole->GetValue(point); });
}

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

class Blocks : public ::testing::Test
{
protected:
  vtkDataObject* run(vtkDataObject* input)
  {
    this->Filter->SetInputDataObject(input);
    EXPECT_EQ(errorsOf(this->Filter.Get()), "");
    return this->Filter->GetOutputDataObject(0);
  }

  void expectError(vtkDataObject* input, const std::string& named)
  {
    this->Filter->SetInputDataObject(input);
    const std::string message = errorsOf(this->Filter.Get());
    EXPECT_NE(message.find(named), std::string::npos) << message;
    EXPECT_EQ(this->Filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  }

  static vtkDataArray* distancesOf(vtkDataObject* leaf)
  {
    return vtkPolyData::SafeDownCast(leaf)->GetPointData()->GetArray("GeodesicDistance");
  }

  /** A part's distances are those of the whole, which is its own part. */
  static void expectSame(vtkDataObject* leaf, vtkDataArray* whole)
  {
    auto* part = vtkPolyData::SafeDownCast(leaf);
    ASSERT_TRUE(part);
    vtkDataArray* distances = distancesOf(part);
    vtkDataArray* origin = part->GetPointData()->GetArray("Whole");
    const double largest = whole->GetFiniteRange()[1];
    ASSERT_EQ(distances->GetNumberOfTuples(), part->GetNumberOfPoints());
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      const double truth =
        whole->GetComponent(static_cast<vtkIdType>(origin->GetComponent(i, 0)), 0);
      const double found = distances->GetComponent(i, 0);
      ASSERT_TRUE(std::isnan(truth) ? std::isnan(found) : std::abs(found - truth) < 1e-9 * largest)
        << found << " is not " << truth;
    }
  }

  void seedAt(vtkPolyData* surface, vtkIdType point)
  {
    double p[3];
    surface->GetPoint(point, p);
    this->Filter->AddSeedPosition(p[0], p[1], p[2]);
  }

  vtkSmartPointer<vtkDataArray> wholeField(vtkPolyData* surface)
  {
    return distancesOf(this->run(surface));
  }

  vtkNew<vtkSurfaceGeodesicDistance> Filter;
};

}

TEST_F(Blocks, NestedWithEmptyPlacesAreTheWhole)
{
  const auto bunny = readData("Bunny.vtp");
  this->seedAt(bunny, 17);
  this->seedAt(bunny, 20000);
  const auto whole = this->wholeField(bunny);
  const vtkIdType visited = this->Filter->GetNumberOfVisitedPoints();
  const double farthest = this->Filter->GetMaximumDistanceReached();
  vtkNew<vtkPolyData> nothing;
  const auto inner = blocksOf({ nullptr, scatteredPart(bunny, 1, 3), nothing });
  const auto input =
    blocksOf({ scatteredPart(bunny, 0, 3), inner, nullptr, scatteredPart(bunny, 2, 3) });
  input->GetMetaData(3u)->Set(vtkCompositeDataSet::NAME(), "third");
  auto* output = vtkMultiBlockDataSet::SafeDownCast(this->run(input));
  ASSERT_TRUE(output);
  ASSERT_EQ(output->GetNumberOfBlocks(), 4u);
  auto* innerOutput = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(1));
  ASSERT_TRUE(innerOutput);
  ASSERT_EQ(innerOutput->GetNumberOfBlocks(), 3u);
  expectSame(output->GetBlock(0), whole);
  expectSame(innerOutput->GetBlock(1), whole);
  expectSame(output->GetBlock(3), whole);
  EXPECT_EQ(innerOutput->GetBlock(0), nullptr);
  EXPECT_EQ(output->GetBlock(2), nullptr);
  EXPECT_TRUE(distancesOf(innerOutput->GetBlock(2)));
  EXPECT_STREQ(output->GetMetaData(3u)->Get(vtkCompositeDataSet::NAME()), "third");
  EXPECT_EQ(this->Filter->GetMaximumDistanceReached(), farthest);
  EXPECT_GT(this->Filter->GetNumberOfVisitedPoints(), visited);
  // Nothing is written into the input.
  EXPECT_FALSE(distancesOf(input->GetBlock(0)));
}

TEST_F(Blocks, PartitionsAndCollectionsKeepTheirStructure)
{
  const auto bunny = readData("Bunny.vtp");
  this->seedAt(bunny, 17);
  const auto whole = this->wholeField(bunny);
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, scatteredPart(bunny, 0, 2));
  partitions->SetPartition(2, scatteredPart(bunny, 1, 2));
  auto* output = vtkPartitionedDataSet::SafeDownCast(this->run(partitions));
  ASSERT_TRUE(output);
  ASSERT_EQ(output->GetNumberOfPartitions(), 3u);
  expectSame(output->GetPartition(0), whole);
  expectSame(output->GetPartition(2), whole);

  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, scatteredPart(bunny, 0, 3));
  collection->SetPartition(2, 0, scatteredPart(bunny, 1, 3));
  collection->SetPartition(2, 1, scatteredPart(bunny, 2, 3));
  collection->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "rest");
  vtkNew<vtkDataAssembly> assembly;
  assembly->Initialize();
  assembly->AddNode("part");
  collection->SetDataAssembly(assembly);
  auto* collected = vtkPartitionedDataSetCollection::SafeDownCast(this->run(collection));
  ASSERT_TRUE(collected);
  ASSERT_EQ(collected->GetNumberOfPartitionedDataSets(), 3u);
  EXPECT_STREQ(collected->GetMetaData(2u)->Get(vtkCompositeDataSet::NAME()), "rest");
  EXPECT_TRUE(collected->GetDataAssembly());
  expectSame(collected->GetPartition(0, 0), whole);
  expectSame(collected->GetPartition(2, 0), whole);
  expectSame(collected->GetPartition(2, 1), whole);

  // One filter for all kinds of input, in any order.
  EXPECT_TRUE(vtkPolyData::SafeDownCast(this->run(bunny)));
}

TEST_F(Blocks, ApartWhenTheyAreNotToBeConnected)
{
  const auto input = blocksOf({ square(4), squareAt(4.0, 0.0) });
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->run(input);
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 50);
  this->Filter->ConnectBlocksOff();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(this->run(input));
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 25);
  EXPECT_NEAR(distancesOf(output->GetBlock(0))->GetFiniteRange()[1], 4.0 * std::sqrt(2.0), 1e-9);
  // Within a block coincident points are still one.
  const auto halves = [](int half) { return scatteredPart(square(4), half, 2); };
  vtkNew<vtkPoints> points;
  points->DeepCopy(halves(0)->GetPoints());
  const auto soup = halves(0);
  const vtkIdType first = soup->GetNumberOfPoints();
  const auto other = halves(1);
  soup->GetPoints()->InsertPoints(first, other->GetNumberOfPoints(), 0, other->GetPoints());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < other->GetNumberOfCells(); ++cell)
  {
    other->GetCellPoints(cell, corners);
    soup->GetPolys()->InsertNextCell(
      { corners->GetId(0) + first, corners->GetId(1) + first, corners->GetId(2) + first });
  }
  soup->GetPointData()->Initialize();
  this->run(blocksOf({ soup, squareAt(4.0, 0.0) }));
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), soup->GetNumberOfPoints());
}

TEST_F(Blocks, MeetInAPointOrAnEdge)
{
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  // All ways to the upper square go through (4, 4).
  auto* output =
    vtkMultiBlockDataSet::SafeDownCast(this->run(blocksOf({ square(4), squareAt(4.0, 4.0) })));
  const double corner = 4.0 * std::sqrt(2.0);
  EXPECT_NEAR(distancesOf(output->GetBlock(1))->GetComponent(0, 0), corner, 1e-9);
  EXPECT_NEAR(distancesOf(output->GetBlock(1))->GetComponent(4, 0), corner + 4.0, 1e-9);
  EXPECT_NEAR(distancesOf(output->GetBlock(1))->GetComponent(24, 0), 2.0 * corner, 1e-9);

  // Only the edge from (4, 3) to (4, 4) is common: straight lines below it are cut off.
  output =
    vtkMultiBlockDataSet::SafeDownCast(this->run(blocksOf({ square(4), squareAt(4.0, 3.0) })));
  const auto at = [&](vtkIdType point)
  { return distancesOf(output->GetBlock(1))->GetComponent(point, 0); };
  EXPECT_NEAR(at(0), 5.0, 1e-9);
  EXPECT_NEAR(at(5), corner, 1e-9);
  EXPECT_NEAR(at(6), std::hypot(5.0, 4.0), 1e-9);
  EXPECT_NEAR(at(24), std::hypot(8.0, 7.0), 0.01);
}

TEST_F(Blocks, GlobalIdsWinOverPositions)
{
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  const auto left = square(4);
  const auto right = squareAt(4.0, 0.0);
  setGlobalIds(left, [](vtkIdType point) { return point; });
  setGlobalIds(right, [](vtkIdType point) { return 100 + point; });
  this->run(blocksOf({ left, right }));
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 25);

  // The columns that meet have equal ids, and positions equal to rounding.
  const auto sharedId = [](vtkIdType point) { return point % 5 == 0 ? point + 4 : 100 + point; };
  const auto rounded = squareAt(4.0 + 1e-6, 0.0);
  setGlobalIds(rounded, sharedId);
  for (const bool merge : { true, false })
  {
    this->Filter->SetMergeCoincidentPoints(merge);
    this->run(blocksOf({ left, rounded }));
    EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 50);
    EXPECT_NEAR(this->Filter->GetMaximumDistanceReached(), std::hypot(8.0, 4.0), 1e-5);
  }
  this->Filter->ConnectBlocksOff();
  this->run(blocksOf({ left, rounded }));
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 25);
  this->Filter->ConnectBlocksOn();

  // Ids that were made for each block alone.
  const auto wrong = squareAt(4.0, 0.0);
  setGlobalIds(wrong, [](vtkIdType point) { return point; });
  this->expectError(blocksOf({ left, wrong }), "global id 0 are 4 apart");
  // Where one block has none, positions count.
  this->Filter->MergeCoincidentPointsOn();
  this->run(blocksOf({ left, squareAt(4.0, 0.0) }));
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 50);
}

TEST_F(Blocks, NothingToConnectByIsAnError)
{
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->Filter->MergeCoincidentPointsOff();
  const auto input = blocksOf({ square(4), squareAt(4.0, 0.0) });
  this->expectError(input, "turn ConnectBlocks off");
  this->Filter->ConnectBlocksOff();
  this->run(input);
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 25);
  // One block needs nothing to connect it, whatever is beside it.
  this->Filter->ConnectBlocksOn();
  vtkNew<vtkPolyData> nothing;
  this->run(blocksOf({ nothing, square(4) }));
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 25);
}

TEST_F(Blocks, PointIdsAreGlobalIds)
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

TEST_F(Blocks, EveryBlockNeedsTheArrays)
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

TEST_F(Blocks, SelectionsAreOfTheirBlock)
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

TEST_F(Blocks, SourcesOfSeveralBlocksCountInAll)
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

TEST_F(Blocks, HiddenCellsAreNoSurface)
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

TEST_F(Blocks, LevelsThatOverlapAreRefused)
{
  vtkNew<vtkOverlappingAMR> levels;
  addLevel(*levels);
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->expectError(levels, "vtkOverlappingAMR");
}

// Blocks that have names may move to other places, with all that they hold unchanged.
TEST_F(Blocks, ThatMoveAreNamedByTheirNewPlaces)
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

TEST_F(Blocks, PathsCrossThemAsTheWhole)
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
