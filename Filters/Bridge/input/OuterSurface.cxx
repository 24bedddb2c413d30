// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/OuterSurface.h"

#include "filter/VtkVersions.h"
#include "input/ObjectVersion.h"
#include "input/VersionCache.h"

#include "vtkAppendFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGeometryFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace geodesic::bridge
{
namespace
{

/**
 * Identifies a data set by the objects and numbers that it consists of. Its address would not do,
 * because ParaView passes a new shallow copy of the same data set in every run.
 */
struct DataVersion
{
  std::vector<ObjectVersion> parts;
  std::vector<double> numbers;

  friend bool operator==(const DataVersion&, const DataVersion&) = default;
};

void addArrays(vtkDataSetAttributes* attributes, DataVersion& version)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    version.parts.emplace_back(attributes->GetAbstractArray(i));
  }
  std::array<int, vtkDataSetAttributes::NUM_ATTRIBUTES> indices{};
  attributes->GetAttributeIndices(indices.data());
  version.numbers.insert(version.numbers.end(), indices.begin(), indices.end());
}

DataVersion versionOf(vtkDataSet* data)
{
  DataVersion version;
  const auto addNumbers = [&](const auto* first, int count)
  { std::copy_n(first, count, std::back_inserter(version.numbers)); };
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    version.parts = { grid->GetPoints(), grid->GetCells(), cellTypesOf(*grid),
      polyhedronFacesOf(*grid) };
  }
  else if (auto* image = vtkImageData::SafeDownCast(data))
  {
    addNumbers(image->GetExtent(), 6);
    addNumbers(image->GetOrigin(), 3);
    addNumbers(image->GetSpacing(), 3);
    addNumbers(image->GetDirectionMatrix()->GetData(), 9);
  }
  else if (auto* curved = vtkStructuredGrid::SafeDownCast(data))
  {
    version.parts = { curved->GetPoints() };
    addNumbers(curved->GetExtent(), 6);
  }
  else if (auto* straight = vtkRectilinearGrid::SafeDownCast(data))
  {
    version.parts = { straight->GetXCoordinates(), straight->GetYCoordinates(),
      straight->GetZCoordinates() };
    addNumbers(straight->GetExtent(), 6);
  }
  else
  {
    version.parts = { data };
  }
  addArrays(data->GetPointData(), version);
  addArrays(data->GetCellData(), version);
  return version;
}

constexpr const char* PointIds = "vtkOriginalPointIds";
constexpr const char* CellIds = "vtkOriginalCellIds";

bool hasCurvedCells(vtkUnstructuredGrid* grid)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (!isLinear(grid->GetCellType(cell)))
    {
      return true;
    }
  }
  return false;
}

void addIds(vtkDataSetAttributes* attributes, vtkIdType count, const char* name)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(name);
  ids->SetNumberOfTuples(count);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, vtkIdType{ 0 });
  attributes->AddArray(ids);
}

/**
 * Sets the id of each point that VTK made on a curved face to -1. VTK interpolates the ids of such
 * points from the ids of other points.
 */
void forgetMadePoints(vtkDataSet* data, vtkPolyData* surface)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(surface->GetPointData()->GetArray(PointIds));
  for (vtkIdType i = 0; ids && i < surface->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> made{};
    std::array<double, 3> original{};
    surface->GetPoint(i, made.data());
    data->GetPoint(ids->GetValue(i), original.data());
    if (made != original)
    {
      ids->SetValue(i, -1);
    }
  }
}

template <class Filter>
std::shared_ptr<vtkPolyData> extractedBy(vtkDataSet* data, bool passIds)
{
  vtkNew<Filter> filter;
  filter->SetPassThroughPointIds(passIds);
  filter->SetPassThroughCellIds(passIds);
  filter->SetInputDataObject(data);
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  surface->Register(nullptr);
  return { surface, [](vtkPolyData* s) { s->UnRegister(nullptr); } };
}

/**
 * Converts an image, or a rectilinear or structured grid. Point and cell ids and all arrays stay
 * the same.
 */
vtkSmartPointer<vtkUnstructuredGrid> unstructured(vtkDataSet* data)
{
  vtkNew<vtkAppendFilter> append;
  // vtkGeometryFilter makes points of this precision for pieces without ghost cells, and the points
  // of all pieces must be equal.
  append->SetOutputPointsPrecision(vtkStructuredGrid::SafeDownCast(data)
      ? vtkAlgorithm::DEFAULT_PRECISION
      : vtkAlgorithm::SINGLE_PRECISION);
  append->AddInputDataObject(data);
  append->Update();
  return append->GetOutput();
}

std::shared_ptr<vtkPolyData> extracted(vtkDataSet* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  vtkSmartPointer<vtkUnstructuredGrid> made;
  if (!grid && data->GetCellGhostArray())
  {
    // vtkGeometryFilter puts the faces of such data at wrong places if there are ghost cells,
    // unless the grid is a cube whose extent begins at 0.
    made = unstructured(data);
    grid = made;
  }
  if (!grid)
  {
    // vtkDataSetSurfaceFilter would give each of the six sides of an image its own points.
    return extractedBy<vtkGeometryFilter>(data, true);
  }
  // vtkGeometryFilter would leave holes beside hidden cells.
  if (!hasCurvedCells(grid))
  {
    return extractedBy<vtkDataSetSurfaceFilter>(grid, true);
  }
  // For curved cells, VTK's ids would be those of an intermediate grid, so the ids are added here.
  vtkNew<vtkUnstructuredGrid> numbered;
  numbered->ShallowCopy(grid);
  addIds(numbered->GetPointData(), grid->GetNumberOfPoints(), PointIds);
  addIds(numbered->GetCellData(), grid->GetNumberOfCells(), CellIds);
  const auto surface = extractedBy<vtkDataSetSurfaceFilter>(numbered, false);
  forgetMadePoints(grid, surface.get());
  return surface;
}

}

std::shared_ptr<vtkPolyData> outerSurfaceOf(vtkDataSet* data)
{
  static VersionCache<DataVersion, vtkPolyData> known;
  return known.get(versionOf(data), [&](const auto&, const auto&) { return extracted(data); });
}

}
