// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Grids and images stand for their outer surface: the same field as on what VTK extracts.

#include "Inputs.h"
#include "input/InputBlocks.h"
#include "input/InputSurface.h"
#include "input/PointIdentity.h"

#include "vtkAppendFilter.h"
#include "vtkBoundingBox.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellTypeSource.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkImageDataToPointSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkRectilinearGrid.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkStructuredGrid.h"
#include "vtkSurfaceGeodesicDistance.h"
#include "vtkSurfaceGeodesicPath.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

using namespace geodesic::testing;
using geodesic::bridge::InputBlocks;
using geodesic::bridge::InputSurface;
using geodesic::bridge::PointIdentity;

namespace
{

/** A box of 6 x 5 x 4 cells with arrays of points and cells. */
vtkSmartPointer<vtkImageData> box()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(7, 6, 5);
  vtkNew<vtkDoubleArray> cost;
  cost->SetName("cost");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    cost->InsertNextValue(1.0 + 0.1 * static_cast<double>(i % 7));
  }
  image->GetPointData()->AddArray(cost);
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("cells");
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    cells->InsertNextValue(i);
  }
  image->GetCellData()->AddArray(cells);
  return image;
}

vtkSmartPointer<vtkUnstructuredGrid> tetrahedra(vtkDataSet* data)
{
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputDataObject(data);
  cut->Update();
  return cut->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> hexahedra(vtkDataSet* data)
{
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(data);
  append->Update();
  return append->GetOutput();
}

/** The cells of a grid of voxels as polyhedra. */
vtkSmartPointer<vtkUnstructuredGrid> polyhedra(vtkUnstructuredGrid* grid)
{
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(grid->GetPoints());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> faces;
    vtkCell* voxel = grid->GetCell(cell);
    faces->InsertNextId(voxel->GetNumberOfFaces());
    for (int i = 0; i < voxel->GetNumberOfFaces(); ++i)
    {
      // A pixel has its corners row by row, a face has them in turn.
      vtkIdList* pixel = voxel->GetFace(i)->GetPointIds();
      faces->InsertNextId(4);
      for (const int corner : { 0, 1, 3, 2 })
      {
        faces->InsertNextId(pixel->GetId(corner));
      }
    }
    result->InsertNextCell(VTK_POLYHEDRON, faces);
  }
  return result;
}

class Grids : public ::testing::Test
{
protected:
  vtkPolyData* run(vtkDataObject* input)
  {
    this->Filter->SetInputDataObject(input);
    EXPECT_EQ(errorsOf(this->Filter.Get()), "");
    return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(0));
  }

  std::string errorWith(vtkDataObject* input)
  {
    this->Filter->SetInputDataObject(input);
    return errorsOf(this->Filter.Get());
  }

  using Field = std::map<std::array<double, 3>, double>;
  /** The ids lead to the same points of @p data. */
  static void expectPointsOf(vtkDataSet* data, vtkPolyData* output, vtkDataArray* ids)
  {
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      std::array<double, 3> p;
      std::array<double, 3> q;
      output->GetPoint(i, p.data());
      data->GetPoint(static_cast<vtkIdType>(ids->GetComponent(i, 0)), q.data());
      EXPECT_EQ(p, q);
    }
  }

  /** The same points, and the same distances but for rounding: VTK begins faces at any corner. */
  static void expectSame(const Field& field, const Field& truth)
  {
    ASSERT_EQ(field.size(), truth.size());
    for (const auto& [point, distance] : truth)
    {
      ASSERT_TRUE(field.contains(point));
      EXPECT_NEAR(field.at(point), distance, 1e-12);
    }
  }

  static Field fieldOf(vtkPolyData* output)
  {
    Field field;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      std::array<double, 3> p;
      output->GetPoint(i, p.data());
      field[p] = output->GetPointData()->GetArray("GeodesicDistance")->GetComponent(i, 0);
    }
    return field;
  }

  vtkNew<vtkSurfaceGeodesicDistance> Filter;
};

}

TEST_F(Grids, AreTheirOuterSurface)
{
  this->Filter->AddSeedPosition(1.5, 2.0, 4.0);
  this->Filter->SetInputArrayToProcess(
    vtkSurfaceGeodesicDistance::COST_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "cost");
  for (const vtkSmartPointer<vtkDataSet>& data :
    { vtkSmartPointer<vtkDataSet>(box()), vtkSmartPointer<vtkDataSet>(tetrahedra(box())) })
  {
    vtkNew<vtkDataSetSurfaceFilter> extract;
    extract->SetInputDataObject(data);
    extract->Update();
    const Field truth = fieldOf(this->run(extract->GetOutput()));
    vtkPolyData* output = this->run(data);
    expectSame(fieldOf(output), truth);
    // The ids lead back to the data set.
    vtkDataArray* points = output->GetPointData()->GetArray("vtkOriginalPointIds");
    vtkDataArray* cells = output->GetCellData()->GetArray("vtkOriginalCellIds");
    ASSERT_TRUE(points && cells);
    expectPointsOf(data, output, points);
    for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
    {
      const auto id = static_cast<vtkIdType>(cells->GetComponent(i, 0));
      EXPECT_EQ(output->GetCellData()->GetArray("cells")->GetComponent(i, 0),
        data->GetCellData()->GetArray("cells")->GetComponent(id, 0));
    }
  }
}

TEST_F(Grids, AreOfEveryKind)
{
  const auto image = box();
  this->Filter->AddSeedPosition(1.5, 2.0, 4.0);
  const Field truth = fieldOf(this->run(image));
  vtkNew<vtkImageDataToPointSet> toCurved;
  toCurved->SetInputDataObject(image);
  toCurved->Update();
  expectSame(fieldOf(this->run(toCurved->GetOutput())), truth);
  vtkNew<vtkRectilinearGrid> straight;
  straight->SetExtent(image->GetExtent());
  const auto coordinates = [](int count)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    for (int i = 0; i < count; ++i)
    {
      array->InsertNextValue(i);
    }
    return array;
  };
  straight->SetXCoordinates(coordinates(7));
  straight->SetYCoordinates(coordinates(6));
  straight->SetZCoordinates(coordinates(5));
  expectSame(fieldOf(this->run(straight)), truth);
}

TEST_F(Grids, PolyhedraHaveTheirOuterFaces)
{
  this->Filter->AddSeedPosition(1.5, 2.0, 4.0);
  const auto grid = hexahedra(box());
  const auto other = polyhedra(grid);
  expectSame(fieldOf(this->run(other)), fieldOf(this->run(grid)));
  // Another polyhedron, whose points and other cells are there before.
  const auto more = vtkSmartPointer<vtkUnstructuredGrid>::New();
  more->ShallowCopy(polyhedra(hexahedra(box())));
  vtkNew<vtkIdList> tip;
  const vtkIdType top = more->GetPoints()->InsertNextPoint(3.5, 2.5, 9.0);
  tip->InsertNextId(5);
  for (const auto& face : std::vector<std::vector<vtkIdType>>{ { 185, 186, 193, 192 },
         { 185, 186, top }, { 186, 193, top }, { 193, 192, top }, { 192, 185, top } })
  {
    tip->InsertNextId(static_cast<vtkIdType>(face.size()));
    for (const vtkIdType corner : face)
    {
      tip->InsertNextId(corner);
    }
  }
  more->InsertNextCell(VTK_POLYHEDRON, tip);
  EXPECT_EQ(fieldOf(this->run(more)).count({ 3.5, 2.5, 9.0 }), 1u);
}

// VTK's own ids are wrong for these cells.
TEST_F(Grids, CurvedCellsKnowTheirPoints)
{
  for (const int type :
    { VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_LAGRANGE_WEDGE, VTK_BEZIER_WEDGE })
  {
    vtkNew<vtkCellTypeSource> source;
    source->SetCellType(type);
    source->SetBlocksDimensions(3, 3, 3);
    source->Update();
    vtkUnstructuredGrid* grid = source->GetOutput();
    this->Filter->ClearSeedPointIds();
    this->Filter->AddSeedPointId(0);
    vtkPolyData* output = this->run(grid);
    vtkDataArray* ids = output->GetPointData()->GetArray("vtkOriginalPointIds");
    vtkDataArray* cells = output->GetCellData()->GetArray("vtkOriginalCellIds");
    ASSERT_TRUE(ids && cells);
    vtkIdType known = 0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const auto id = static_cast<vtkIdType>(ids->GetComponent(i, 0));
      if (id >= 0)
      {
        std::array<double, 3> p;
        std::array<double, 3> q;
        output->GetPoint(i, p.data());
        grid->GetPoint(id, q.data());
        EXPECT_EQ(p, q);
        ++known;
      }
    }
    if (type != VTK_BEZIER_WEDGE)
    {
      EXPECT_EQ(known, output->GetNumberOfPoints());
    }
    for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
    {
      // A face lies in the bounding box of its cell.
      const auto id = static_cast<vtkIdType>(cells->GetComponent(i, 0));
      vtkBoundingBox cellBox(grid->GetCell(id)->GetBounds());
      cellBox.Inflate(1e-5);
      EXPECT_TRUE(cellBox.Contains(vtkBoundingBox(output->GetCell(i)->GetBounds())));
    }
    double p[3];
    grid->GetPoint(0, p);
    EXPECT_EQ(fieldOf(output).at({ p[0], p[1], p[2] }), 0.0);
  }
}

// A cell that is hidden, at the corner that the seed is next to, leaves a notch.
TEST_F(Grids, HiddenCellsAreNotThere)
{
  this->Filter->AddSeedPosition(1.0, 0.0, 0.0);
  for (const vtkSmartPointer<vtkDataSet>& data :
    { vtkSmartPointer<vtkDataSet>(box()), vtkSmartPointer<vtkDataSet>(hexahedra(box())) })
  {
    const Field whole = fieldOf(this->run(data));
    EXPECT_NEAR(whole.at({ 0.0, 1.0, 0.0 }), std::sqrt(2.0), 1e-9);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(data->GetNumberOfCells());
    ghosts->FillValue(0);
    ghosts->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
    data->GetCellData()->AddArray(ghosts);
    const Field field = fieldOf(this->run(data));
    EXPECT_EQ(field.count({ 0.0, 0.0, 0.0 }), 0u);
    EXPECT_NEAR(field.at({ 0.0, 1.0, 0.0 }), 2.0, 0.01);
    EXPECT_EQ(field.count({ 1.0, 1.0, 1.0 }), 1u);
    // All else is there, and no more.
    EXPECT_EQ(field.size(), whole.size());
    for (const auto& [point, distance] : whole)
    {
      EXPECT_EQ(field.count(point), (point == std::array{ 0.0, 0.0, 0.0 } ? 0u : 1u));
    }
  }
}

// The faces between two halves of a box are inside; as blocks of their own the halves keep theirs.
TEST_F(Grids, PartitionsHaveNoFacesInside)
{
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  const Field whole = fieldOf(this->run(box()));
  vtkNew<vtkImageData> low;
  low->SetExtent(0, 3, 0, 5, 0, 4);
  vtkNew<vtkImageData> high;
  high->SetExtent(3, 6, 0, 5, 0, 4);
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, low);
  partitions->SetPartition(1, high);
  for (int run = 0; run < 2; ++run)
  {
    this->Filter->SetInputDataObject(partitions);
    ASSERT_EQ(errorsOf(this->Filter.Get()), "");
    auto* output = vtkPartitionedDataSet::SafeDownCast(this->Filter->GetOutputDataObject(0));
    for (unsigned int i = 0; i < 2; ++i)
    {
      for (const auto& [point, distance] :
        fieldOf(vtkPolyData::SafeDownCast(output->GetPartitionAsDataObject(i))))
      {
        EXPECT_EQ(std::isnan(distance), whole.count(point) == 0);
        EXPECT_TRUE(std::isnan(distance) || std::abs(distance - whole.at(point)) < 1e-9);
      }
    }
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, low);
  blocks->SetBlock(1, high);
  this->Filter->SetInputDataObject(blocks);
  ASSERT_EQ(errorsOf(this->Filter.Get()), "");
  auto* output = vtkMultiBlockDataSet::SafeDownCast(this->Filter->GetOutputDataObject(0));
  EXPECT_NEAR(fieldOf(vtkPolyData::SafeDownCast(output->GetBlock(1))).at({ 3.0, 1.0, 1.0 }),
    std::sqrt(17.0), 0.3);
}

TEST_F(Grids, PointIdsAreTheirOwn)
{
  // The corners (0, 0, 0) and (6, 0, 0), and a point inside.
  this->Filter->AddSeedPointId(0);
  this->Filter->AddDestinationPointId(6);
  const auto image = box();
  this->run(image);
  EXPECT_NEAR(this->Filter->GetMaximumDistanceReached(), 6.0, 1e-9);
  this->Filter->AddSeedPointId(42 + 7 + 1);
  EXPECT_NE(
    this->errorWith(image).find("Seed point id 50 is not on the surface"), std::string::npos);
  this->Filter->ClearSeedPointIds();
  this->Filter->AddSeedPointId(210);
  EXPECT_NE(this->errorWith(image).find("the input has 210 points"), std::string::npos);
}

TEST_F(Grids, SelectionsAreOfTheirPointsAndCells)
{
  const auto image = box();
  const auto select = [&](int kind, vtkIdType id)
  {
    vtkNew<vtkIdTypeArray> list;
    list->InsertNextValue(id);
    vtkNew<vtkSelectionNode> node;
    node->SetFieldType(kind);
    node->SetContentType(vtkSelectionNode::INDICES);
    node->SetSelectionList(list);
    vtkNew<vtkSelection> selection;
    selection->AddNode(node);
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(selection);
    this->Filter->SetSeedSelectionConnection(producer->GetOutputPort());
  };
  select(vtkSelectionNode::POINT, 6);
  EXPECT_EQ(fieldOf(this->run(image)).at({ 6.0, 0.0, 0.0 }), 0.0);
  // The cell in that corner has three outer faces.
  select(vtkSelectionNode::CELL, 5);
  const Field field = fieldOf(this->run(image));
  EXPECT_EQ(
    std::count_if(field.begin(), field.end(), [](const auto& f) { return f.second == 0.0; }), 7);
  EXPECT_EQ(field.at({ 5.0, 0.0, 1.0 }), 0.0);
  select(vtkSelectionNode::POINT, 50);
  EXPECT_NE(this->errorWith(image).find("has no point or cell of the surface"), std::string::npos);
}

TEST_F(Grids, MeetOtherBlocks)
{
  // A box, and a sheet that goes on from the edge of its top.
  const auto image = box();
  vtkNew<vtkImageData> sheet;
  sheet->SetDimensions(4, 6, 1);
  sheet->SetOrigin(6.0, 0.0, 4.0);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, image);
  blocks->SetBlock(1, sheet);
  this->Filter->AddSeedPosition(0.0, 2.0, 4.0);
  this->Filter->SetInputDataObject(blocks);
  ASSERT_EQ(errorsOf(this->Filter.Get()), "");
  auto* output = vtkMultiBlockDataSet::SafeDownCast(this->Filter->GetOutputDataObject(0));
  auto* first = vtkPolyData::SafeDownCast(output->GetBlock(0));
  auto* second = vtkPolyData::SafeDownCast(output->GetBlock(1));
  ASSERT_TRUE(first && second);
  EXPECT_NEAR(fieldOf(second).at({ 9.0, 2.0, 4.0 }), 9.0, 1e-9);
  EXPECT_NEAR(fieldOf(first).at({ 6.0, 2.0, 3.0 }), 7.0, 0.01);
  EXPECT_TRUE(first->GetPointData()->GetArray("vtkOriginalPointIds"));
  EXPECT_TRUE(second->GetPointData()->GetArray("vtkOriginalPointIds"));
}

TEST_F(Grids, OfImagesTheFacesHangTogetherByThemselves)
{
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->Filter->MergeCoincidentPointsOff();
  vtkPolyData* output = this->run(box());
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), output->GetNumberOfPoints());
}

TEST_F(Grids, PathsNameTheirPoints)
{
  const auto image = box();
  vtkNew<vtkSurfaceGeodesicPath> filter;
  for (const double x : { 0.0, 0.0, 4.0, 6.0, 0.0, 4.0 })
  {
    filter->AddWaypointCoordinate(x);
  }
  filter->SetInputDataObject(image);
  ASSERT_EQ(errorsOf(filter.Get()), "");
  auto* path = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_NEAR(filter->GetTotalLength(), 6.0, 1e-9);
  expectPointsOf(image, path, path->GetPointData()->GetArray("OriginalPointIds"));
}

// What later runs do not do again: the objects are the same.
TEST(InputSurface, IsBuiltOnceForAnInput)
{
  const PointIdentity byCoordinates{ PointIdentity::By::Coordinates, true };
  const auto image = box();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, image);
  blocks->SetBlock(1, square(3));
  const auto surface = InputSurface::of(InputBlocks(blocks), byCoordinates);
  const auto outer = InputBlocks(image)[0].outerSurface;
  EXPECT_EQ(InputSurface::of(InputBlocks(blocks), byCoordinates), surface);
  EXPECT_EQ(InputBlocks(blocks)[0].outerSurface, outer);
  vtkNew<vtkMultiBlockDataSet> others;
  others->ShallowCopy(blocks);
  others->SetBlock(0, image);
  EXPECT_EQ(InputSurface::of(InputBlocks(others), byCoordinates), surface);
  EXPECT_NE(
    InputSurface::of(InputBlocks(blocks), { PointIdentity::By::Coordinates, false }), surface);
  image->SetOrigin(1.0, 0.0, 0.0);
  EXPECT_NE(InputSurface::of(InputBlocks(blocks), byCoordinates), surface);
}

// ParaView hands over a shallow copy of the grid in every run.
TEST_F(Grids, AreExtractedOnceWhileTheyStay)
{
  const auto copyOf = [](vtkDataSet* data)
  {
    const auto copy = vtk::TakeSmartPointer(data->NewInstance());
    copy->ShallowCopy(data);
    return copy;
  };
  this->Filter->SetInputArrayToProcess(
    vtkSurfaceGeodesicDistance::COST_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "cost");
  for (const vtkSmartPointer<vtkDataSet>& data :
    { vtkSmartPointer<vtkDataSet>(box()), vtkSmartPointer<vtkDataSet>(tetrahedra(box())) })
  {
    this->Filter->AddSeedPosition(1.5, 2.0, 4.0);
    const vtkSmartPointer<vtkPoints> points = this->run(copyOf(data))->GetPoints();
    EXPECT_EQ(this->run(copyOf(data))->GetPoints(), points);
    // What does not change the surface is that of the present data set.
    vtkNew<vtkDoubleArray> time;
    time->SetName("time");
    time->InsertNextValue(7.0);
    data->GetFieldData()->AddArray(time);
    data->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), 7.0);
    vtkPolyData* output = this->run(copyOf(data));
    EXPECT_EQ(output->GetPoints(), points);
    EXPECT_TRUE(output->GetFieldData()->GetArray("time"));
    EXPECT_EQ(output->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 7.0);
    const double farthest = this->Filter->GetMaximumDistanceReached();
    auto* cost = vtkDoubleArray::SafeDownCast(data->GetPointData()->GetArray("cost"));
    cost->FillValue(3.0);
    cost->Modified();
    EXPECT_NE(this->run(copyOf(data))->GetPoints(), points);
    EXPECT_NE(this->Filter->GetMaximumDistanceReached(), farthest);
  }
}
