// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks that share points are one surface: cut surfaces against the whole, squares against
// formulas.

#include "BlockParts.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkInformation.h"
#include "vtkOverlappingAMR.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <gtest/gtest.h>

using namespace geodesic::testing;

namespace
{

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

TEST_F(Blocks, LevelsThatOverlapAreRefused)
{
  vtkNew<vtkOverlappingAMR> levels;
  addLevel(*levels);
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->expectError(levels, "vtkOverlappingAMR");
}
