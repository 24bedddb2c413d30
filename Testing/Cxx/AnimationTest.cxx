// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Inputs that change from step to step: what is kept, and that the answer is that of a new filter.

#include "Inputs.h"
#include "input/InputSurface.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSurfaceGeodesicDistance.h"
#include "vtkSurfaceGeodesicPath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <malloc.h>
#include <memory>
#include <vector>

using namespace geodesic;
using namespace geodesic::bridge;
using namespace geodesic::testing;

namespace
{

constexpr int Side = 20;

/** What a step has of its own. */
enum class NewIn
{
  /** The points: filters such as Warp By Vector pass the cells on. */
  Points,
  /** The cells too, of the same content: as from a reader. */
  PointsAndCells
};

/** A surface with its points moved along z by a wave. */
vtkSmartPointer<vtkPolyData> step(vtkPolyData* surface, double time, NewIn what = NewIn::Points)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->ShallowCopy(surface);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    points->InsertNextPoint(
      p[0], p[1], p[2] + time * std::sin(0.5 * p[0] + time) * std::cos(0.3 * p[1]));
  }
  data->SetPoints(points);
  if (what == NewIn::PointsAndCells)
  {
    vtkNew<vtkCellArray> cells;
    cells->DeepCopy(surface->GetPolys());
    data->SetPolys(cells);
  }
  return data;
}

std::vector<double> distancesBy(vtkSurfaceGeodesicDistance* filter, vtkDataObject* input)
{
  filter->SetInputDataObject(input);
  EXPECT_EQ(errorsOf(filter), "");
  std::vector<double> distances;
  if (auto* surface = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)))
  {
    vtkDataArray* array = surface->GetPointData()->GetArray("GeodesicDistance");
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      distances.push_back(array->GetComponent(i, 0));
    }
  }
  return distances;
}

vtkSmartPointer<vtkSurfaceGeodesicDistance> distanceFilter()
{
  auto filter = vtkSmartPointer<vtkSurfaceGeodesicDistance>::New();
  filter->AddSeedPointId(3);
  filter->AddSeedPosition(14.2, 11.7, 0.0);
  return filter;
}

/** Makes a filter's answer on an input that of a new one, which knows none of what came before. */
void expectFresh(vtkSurfaceGeodesicDistance* filter, vtkPolyData* input)
{
  const std::vector<double> found = distancesBy(filter, input);
  vtkNew<vtkPolyData> alone;
  alone->DeepCopy(input);
  // Held surfaces would lend the new one their structure, so its points are merged by another rule.
  const auto other = distanceFilter();
  other->SetMergeCoincidentPoints(!filter->GetMergeCoincidentPoints());
  const std::vector<double> fresh = distancesBy(other, alone);
  ASSERT_EQ(found.size(), fresh.size());
  const double largest = filter->GetMaximumDistanceReached();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    ASSERT_EQ(std::isnan(found[i]), std::isnan(fresh[i])) << "at point " << i;
    if (!std::isnan(found[i]))
    {
      ASSERT_NEAR(found[i], fresh[i], 1e-11 * largest) << "at point " << i;
    }
  }
}

std::shared_ptr<const InputSurface> surfaceOf(
  vtkDataObject* input, PointIdentity::By by = PointIdentity::By::Coordinates, bool across = true)
{
  return InputSurface::of(InputBlocks(input), { by, across });
}

bool sharesStructure(const InputSurface& a, const InputSurface& b)
{
  return a.mesh() != b.mesh() && a.mesh()->hasStructureOf(*b.mesh());
}

std::size_t heldMemory()
{
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

}

TEST(Animation, MovedPointsKeepTheStructure)
{
  const auto surface = square(Side);
  for (const NewIn what : { NewIn::Points, NewIn::PointsAndCells })
  {
    const auto first = surfaceOf(surface);
    const auto moved = surfaceOf(step(surface, 1.0, what));
    EXPECT_TRUE(sharesStructure(*moved, *first));
    for (Index t = 0; t < first->mesh()->numberOfTriangles(); ++t)
    {
      ASSERT_EQ(moved->cellOfTriangle(t), first->cellOfTriangle(t));
    }
  }
}

TEST(Animation, EachStepIsThatOfANewFilter)
{
  const auto surface = square(Side);
  for (const NewIn what : { NewIn::Points, NewIn::PointsAndCells })
  {
    const auto filter = distanceFilter();
    for (int i = 0; i < 12; ++i)
    {
      expectFresh(filter, step(surface, 0.3 * i, what));
    }
  }
}

TEST(Animation, PointsThatAreWrittenInPlaceAreSeen)
{
  const auto surface = step(square(Side), 0.5);
  const auto filter = distanceFilter();
  expectFresh(filter, surface);
  for (int i = 0; i < 3; ++i)
  {
    surface->GetPoints()->SetPoint(40 + i, 5.0, 3.0, 2.0 + i);
    surface->GetPoints()->Modified();
    expectFresh(filter, surface);
  }
}

// The diagonal of a quadrilateral depends on its corners.
TEST(Animation, QuadrilateralsAreCutAgain)
{
  const auto surface = square(Side, Cells::Quadrilaterals);
  const auto flat = step(surface, 0.0);
  const auto first = surfaceOf(flat);
  const auto lifted = step(surface, 0.0);
  for (vtkIdType i = 0; i < lifted->GetNumberOfPoints(); ++i)
  {
    double p[3];
    lifted->GetPoint(i, p);
    lifted->GetPoints()->SetPoint(i, 2.0 * p[0], p[1], p[2]);
  }
  EXPECT_TRUE(sharesStructure(*surfaceOf(lifted), *first));
  const auto sheared = step(surface, 0.0);
  for (vtkIdType i = 0; i < sheared->GetNumberOfPoints(); ++i)
  {
    double p[3];
    sheared->GetPoint(i, p);
    const double side = std::fmod(p[1], 2.0) < 0.5 ? 0.4 : -0.4;
    sheared->GetPoints()->SetPoint(i, p[0] + side, p[1], p[2]);
  }
  EXPECT_FALSE(sharesStructure(*surfaceOf(sheared), *first));
  const auto filter = distanceFilter();
  for (const auto& input : { flat, sheared, lifted, flat })
  {
    expectFresh(filter, input);
  }
}

TEST(Animation, OtherCellsAreOtherSurfaces)
{
  const auto surface = square(Side);
  const auto first = surfaceOf(surface);
  const auto changed = step(surface, 1.0, NewIn::PointsAndCells);
  vtkNew<vtkCellArray> cells;
  for (vtkIdType cell = 0; cell + 7 < surface->GetNumberOfPolys(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    surface->GetPolys()->GetCellAtId(cell, ids);
    cells->InsertNextCell(ids);
  }
  changed->SetPolys(cells);
  EXPECT_FALSE(sharesStructure(*surfaceOf(changed), *first));
  const auto filter = distanceFilter();
  expectFresh(filter, surface);
  expectFresh(filter, changed);
  expectFresh(filter, step(changed, 0.7));
  expectFresh(filter, step(surface, 0.7));
}

// A cell that repeats a corner is no triangle of the mesh, and shifts the numbers of those behind
// it.
TEST(Animation, CellsWithoutAnAreaComeAndGo)
{
  const auto surface = square(Side);
  const auto withCell = [&](vtkIdType place)
  {
    const auto changed = step(surface, 0.3);
    vtkNew<vtkCellArray> cells;
    for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
    {
      if (cell == place)
      {
        const vtkIdType repeated[] = { 5, 5, 7 };
        cells->InsertNextCell(3, repeated);
      }
      vtkNew<vtkIdList> ids;
      surface->GetPolys()->GetCellAtId(cell, ids);
      cells->InsertNextCell(ids);
    }
    changed->SetPolys(cells);
    return changed;
  };
  for (const vtkIdType place : { 0, 31 })
  {
    const auto more = withCell(place);
    const auto held = surfaceOf(more);
    const auto fewer = surfaceOf(step(surface, 0.6, NewIn::PointsAndCells));
    EXPECT_FALSE(sharesStructure(*fewer, *held));
    EXPECT_FALSE(sharesStructure(*surfaceOf(withCell(place + 1)), *held));
    const auto again = surfaceOf(withCell(place));
    EXPECT_TRUE(sharesStructure(*again, *held));
    EXPECT_EQ(again->cellOfTriangle(100), held->cellOfTriangle(100));
  }
}

// Cells without faces come first in the numbers of cells.
TEST(Animation, LinesBeforeTheFacesShiftTheCells)
{
  const auto surface = square(Side);
  const auto first = surfaceOf(surface);
  const auto lined = step(surface, 1.0);
  vtkNew<vtkCellArray> lines;
  const vtkIdType ends[] = { 0, 5 };
  lines->InsertNextCell(2, ends);
  lined->SetLines(lines);
  const auto shifted = surfaceOf(lined);
  lined->SetPoints(surface->GetPoints());
  EXPECT_NE(surfaceOf(lined), first);
  EXPECT_EQ(shifted->cellOfTriangle(0), 1 + shifted->mesh()->sourceOfTriangle(0));
}

TEST(Animation, PointsThatMeetAreMerged)
{
  const auto surface = square(Side);
  const auto filter = distanceFilter();
  distancesBy(filter, surface);
  const auto met = step(surface, 0.5);
  // The border's ends come together: a tube.
  for (int row = 0; row <= Side; ++row)
  {
    double p[3];
    met->GetPoint(row * (Side + 1), p);
    met->GetPoints()->SetPoint(row * (Side + 1) + Side, p);
  }
  const std::vector<double> closed = distancesBy(filter, met);
  EXPECT_EQ(closed[0], closed[Side]);
  // And part again.
  const std::vector<double> open = distancesBy(filter, step(surface, 0.5));
  EXPECT_GT(std::abs(open[0] - open[Side]), 1.0);
  expectFresh(filter, step(surface, 0.6));
}

// Blocks that touch are one surface by coordinates, or by global ids, or are not.
TEST(Animation, OfBlocks)
{
  const auto blocksAt = [](double time)
  {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetBlock(0, step(square(Side), time));
    blocks->SetBlock(1, step(square(Side), 2.0 * time));
    return blocks;
  };
  const auto still = blocksAt(0.0);
  for (const bool across : { true, false })
  {
    const auto first = surfaceOf(blocksAt(1.0), PointIdentity::By::Coordinates, across);
    const auto moved = surfaceOf(blocksAt(2.0), PointIdentity::By::Coordinates, across);
    EXPECT_TRUE(sharesStructure(*moved, *first));
    // Both blocks are in one place.
    const auto flat = surfaceOf(still, PointIdentity::By::Coordinates, across);
    EXPECT_EQ(sharesStructure(*flat, *first), !across);
  }
}

TEST(Animation, PathsFollow)
{
  const auto surface = square(Side);
  const auto lengthBy = [](vtkSurfaceGeodesicPath* filter, vtkPolyData* input)
  {
    filter->ClearWaypointPositions();
    for (const vtkIdType id : { 0, Side * (Side + 1) + 7 })
    {
      double p[3];
      input->GetPoint(id, p);
      std::for_each(p, p + 3, [&](double x) { filter->AddWaypointCoordinate(x); });
    }
    filter->SetInputDataObject(input);
    EXPECT_EQ(errorsOf(filter), "");
    return filter->GetTotalLength();
  };
  vtkNew<vtkSurfaceGeodesicPath> filter;
  for (int i = 0; i < 4; ++i)
  {
    const auto input = step(surface, 0.4 * i);
    vtkNew<vtkSurfaceGeodesicPath> fresh;
    fresh->SetMergeCoincidentPoints(false);
    EXPECT_NEAR(lengthBy(filter, input), lengthBy(fresh, input), 1e-9);
  }
}

// Two surfaces in turn, with moved points, new cells and other triangles, whose objects are deleted
// as soon as the next comes.
TEST(Animation, MemoryDoesNotGrowOver200Steps)
{
  const auto filter = distanceFilter();
  const auto surface = square(60);
  const auto other = square(60, Cells::Quadrilaterals);
  std::size_t held = 0;
  for (int i = 0; i < 224; ++i)
  {
    const NewIn what = i % 3 == 0 ? NewIn::PointsAndCells : NewIn::Points;
    distancesBy(filter, step(i % 4 == 3 ? other : surface, 0.1 + 0.01 * (i % 20), what));
    if (i == 19)
    {
      held = heldMemory();
    }
  }
  // The last step is like step 19. A mesh of 3,721 points takes 480,000 bytes.
  EXPECT_LT(heldMemory(), held + 50000);
}
