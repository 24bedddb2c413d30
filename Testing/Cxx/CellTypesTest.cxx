// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Every kind of cell that is surface; those that are not stay aside.

#include "Inputs.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkNew.h"
#include "vtkSurfaceGeodesicDistance.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <gtest/gtest.h>

using namespace geodesic::testing;

namespace
{

void expectStraightLines(vtkPolyData* input, vtkIdType seed, vtkIdType points)
{
  vtkNew<vtkFastMarchingGeodesicDistance> filter;
  filter->SetInputData(input);
  filter->SetSeeds(idList({ seed }));
  filter->SetFieldDataName("d");
  ASSERT_EQ(errorsOf(filter.Get()), "");
  vtkDataArray* d = filter->GetOutput()->GetPointData()->GetArray("d");
  for (vtkIdType i = 0; i < points; ++i)
  {
    EXPECT_NEAR(d->GetComponent(i, 0), distanceBetween(input, i, seed), 1e-9) << "point " << i;
  }
}

vtkSmartPointer<vtkPolyData> polygon(const std::vector<std::array<double, 2>>& corners)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell(static_cast<int>(corners.size()));
  for (const auto& [x, y] : corners)
  {
    faces->InsertCellPoint(points->InsertNextPoint(x, y, 0.0));
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(faces);
  return surface;
}

/** Copies of the cells in every way of storing them that this version of VTK has. */
template <class CellArray>
std::vector<vtkSmartPointer<CellArray>> storedInEveryWay(CellArray* cells)
{
  std::vector<vtkSmartPointer<CellArray>> copies;
  const auto addCopy = [&](auto&& convert)
  {
    auto copy = vtkSmartPointer<CellArray>::New();
    copy->DeepCopy(cells);
    EXPECT_TRUE(convert(*copy));
    copies.push_back(copy);
  };
  addCopy([](auto& copy) { return copy.ConvertTo32BitStorage(); });
  addCopy([](auto& copy) { return copy.ConvertTo64BitStorage(); });
  if constexpr (requires { cells->IsStorageGeneric(); })
  {
    addCopy([](auto& copy) { return copy.ConvertToFixedSize32BitStorage(); });
    addCopy([](auto& copy) { return copy.ConvertToFixedSize64BitStorage(); });
    addCopy(
      [&](auto& copy)
      {
        vtkNew<vtkUnsignedShortArray> offsets;
        offsets->DeepCopy(cells->GetOffsetsArray());
        vtkNew<vtkUnsignedShortArray> connectivity;
        connectivity->DeepCopy(cells->GetConnectivityArray());
        return copy.SetData(offsets, connectivity) && copy.IsStorageGeneric();
      });
  }
  return copies;
}

}

TEST(CellTypes, EveryStorageOfCellsIsRead)
{
  const auto surface = square(9);
  for (const auto& polygons : storedInEveryWay(surface->GetPolys()))
  {
    surface->SetPolys(polygons);
    expectStraightLines(surface, 33, 100);
  }
  const auto ofStrips = square(9, Cells::Strips);
  for (const auto& strips : storedInEveryWay(ofStrips->GetStrips()))
  {
    ofStrips->SetStrips(strips);
    expectStraightLines(ofStrips, 33, 100);
  }
}

TEST(CellTypes, QuadrilateralsAndStripsAreLikeTriangles)
{
  expectStraightLines(square(9, Cells::Quadrilaterals), 33, 100);
  expectStraightLines(square(9, Cells::Strips), 33, 100);
}

TEST(CellTypes, AConvexPolygonIsFlat)
{
  expectStraightLines(polygon({ { 0, 0 }, { 2, 0 }, { 3, 1 }, { 2, 3 }, { 0, 2 } }), 0, 5);
}

// From the tip of one arm of a U to the other the way leads round the notch, not across it.
TEST(CellTypes, AConcavePolygonKeepsItsNotch)
{
  const auto shape =
    polygon({ { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } });
  vtkNew<vtkFastMarchingGeodesicDistance> filter;
  filter->SetInputData(shape);
  filter->SetSeeds(idList({ 6 }));
  filter->SetFieldDataName("d");
  ASSERT_EQ(errorsOf(filter.Get()), "");
  EXPECT_NEAR(filter->GetOutput()->GetPointData()->GetArray("d")->GetComponent(3, 0), 5.0, 1e-12);
}

// An arrow head: only the diagonal through the dent lies inside.
TEST(CellTypes, AConcaveQuadrilateralIsCutInside)
{
  const auto arrow = polygon({ { 0, 0 }, { 4, 2 }, { 0, 4 }, { 1, 2 } });
  vtkNew<vtkFastMarchingGeodesicDistance> filter;
  filter->SetInputData(arrow);
  filter->SetSeeds(idList({ 0 }));
  filter->SetFieldDataName("d");
  ASSERT_EQ(errorsOf(filter.Get()), "");
  const double round = 2.0 * std::hypot(1.0, 2.0);
  EXPECT_NEAR(filter->GetOutput()->GetPointData()->GetArray("d")->GetComponent(2, 0), round, 1e-9);
}

TEST(CellTypes, ARepeatedCornerMakesAQuadrilateralATriangle)
{
  const auto surface = square(3);
  const vtkIdType corners[4] = { 0, 1, 1, 4 };
  surface->GetPolys()->InsertNextCell(4, corners);
  expectStraightLines(surface, 5, 16);
}

// No such face fits into memory: only its offsets say that it is there.
TEST(CellTypes, AFaceOfMoreCornersThanAnIntHoldsIsRefused)
{
  const auto surface = square(3);
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->InsertNextValue(0);
  offsets->InsertNextValue(vtkTypeInt64{ 1 } << 31);
  vtkNew<vtkTypeInt64Array> connectivity;
  connectivity->InsertNextValue(0);
  vtkNew<vtkCellArray> faces;
  faces->SetData(offsets, connectivity);
  surface->SetPolys(faces);
  vtkNew<vtkFastMarchingGeodesicDistance> filter;
  filter->SetInputData(surface);
  filter->SetSeeds(idList({ 0 }));
  EXPECT_NE(errorsOf(filter.Get()).find("2147483648 corners; it may have at most 2147483647"),
    std::string::npos);
}

TEST(CellTypes, VerticesAndLinesAreNoSurface)
{
  const auto surface = square(3);
  const vtkIdType far = surface->GetPoints()->InsertNextPoint(9.0, 9.0, 0.0);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 15, far });
  surface->SetLines(lines);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ far });
  surface->SetVerts(vertices);
  expectStraightLines(surface, 5, 16);
  vtkNew<vtkFastMarchingGeodesicDistance> filter;
  filter->SetInputData(surface);
  filter->SetSeeds(idList({ 0 }));
  filter->SetFieldDataName("d");
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("d")->GetComponent(far, 0), -1.0);
  EXPECT_EQ(filter->GetNumberOfVisitedPoints(), 16);
}

TEST(CellTypes, ArraysOfCellsFollowTheirTrianglesPastCellsWithoutAny)
{
  // Two triangles a quadrilateral, none for the walls before them: the last cell has the number
  // that it would have if each triangle were a cell.
  const auto surface = square(3, Cells::Quadrilaterals);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> wall;
  wall->SetName("wall");
  for (vtkIdType cell = 0; cell < 9; ++cell)
  {
    if (cell > 0)
    {
      cells->InsertNextCell({ 0, 0, 1, 1 });
      wall->InsertNextValue(1);
    }
    if (cell == 8)
    {
      cells->InsertNextCell({ 0, 0, 1, 1 });
      wall->InsertNextValue(1);
    }
    vtkNew<vtkIdList> corners;
    surface->GetPolys()->GetCellAtId(cell, corners);
    cells->InsertNextCell(corners);
    wall->InsertNextValue(0);
  }
  surface->SetPolys(cells);
  surface->GetCellData()->AddArray(wall);
  vtkNew<vtkSurfaceGeodesicDistance> filter;
  filter->SetInputData(surface);
  filter->AddSeedPosition(0.0, 0.0, 0.0);
  filter->SetInputArrayToProcess(vtkSurfaceGeodesicDistance::BARRIER_ARRAY, 0, 0,
    vtkDataObject::FIELD_ASSOCIATION_CELLS, "wall");
  ASSERT_EQ(errorsOf(filter.Get()), "");
  EXPECT_EQ(filter->GetNumberOfVisitedPoints(), 16);
}
