// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicCentre.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "base/NumberText.h"
#include "filter/ProgressReporter.h"
#include "input/InputBlocks.h"
#include "input/InputSurface.h"
#include "methods/KeptSolver.h"
#include "methods/SolverTable.h"
#include "output/PathAttributes.h"
#include "pieces/DistributedSurface.h"
#include "ranks/RankGroup.h"
#include "survey/CentreSearch.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

/** The state that is kept from run to run, so that only what changed is made again. */
struct vtkSurfaceGeodesicCentre::Internals
{
  std::shared_ptr<const geodesic::distributed::DistributedSurface> Surface;
  geodesic::KeptSolver Solver;
};

vtkStandardNewMacro(vtkSurfaceGeodesicCentre);

//------------------------------------------------------------------------------
vtkSurfaceGeodesicCentre::vtkSurfaceGeodesicCentre()
  : Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkSurfaceGeodesicCentre::~vtkSurfaceGeodesicCentre() = default;

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicCentre::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  // The executive passes composite data whole, and not block by block, only if they are among these
  // types.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicCentre::DescribeRequest(std::vector<double>& numbers)
{
  this->Superclass::DescribeRequest(numbers);
  numbers.insert(
    numbers.end(), { this->RelativeError, static_cast<double>(this->MaximumNumberOfFields) });
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicCentre::Forget()
{
  *this->Internal = Internals();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicCentre::Compute(geodesic::distributed::RankGroup& ranks,
  const geodesic::bridge::InputBlocks& blocks, vtkInformationVector** vtkNotUsed(inputVector),
  vtkDataObject* output)
{
  this->NumberOfParts = 0;
  this->LargestError = 0.0;
  if (!(this->RelativeError >= 0.0))
  {
    throw std::invalid_argument("RelativeError is " + geodesic::textOf(this->RelativeError) +
      "; give a number of at least 0, such as 0.01 for a hundredth.");
  }
  if (this->MaximumNumberOfFields < 1)
  {
    throw std::invalid_argument("MaximumNumberOfFields is " +
      std::to_string(this->MaximumNumberOfFields) + "; give at least 1.");
  }
  const bool hasPart = blocks.numberWithFaces() > 0;
  const double pieces = ranks.sum(hasPart ? 1.0 : 0.0);
  if (pieces > 1.0)
  {
    throw std::invalid_argument("The surface is spread over " + geodesic::textOf(pieces) +
      " ranks, and Geodesic Centre needs all of it on one. Bring it there by Aggregate Dataset.");
  }
  this->Internal->Surface = this->FindSurface(ranks, blocks);
  ranks.together(
    [&]
    {
      if (hasPart)
      {
        this->Search(blocks, output);
      }
    });
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicCentre::Search(
  const geodesic::bridge::InputBlocks& blocks, vtkDataObject* output)
{
  Internals& internal = *this->Internal;
  const geodesic::bridge::InputSurface& surface = internal.Surface->piece();
  const geodesic::SolverTraits& method = this->GetSolver();
  geodesic::DistanceSolver& solver = internal.Solver.get(method, surface.mesh());
  geodesic::CentreRequest request;
  request.error = this->RelativeError;
  request.mostFields = static_cast<std::size_t>(this->MaximumNumberOfFields);
  request.options.memoryLimit = this->GetMemoryLimitInBytes();
  request.options.tolerance = this->GetCheckedTolerance();
  constexpr geodesic::Index steps = 1000000;
  geodesic::bridge::ProgressReporter reporter(*this, steps);
  request.onProgress = [&](double part)
  { return reporter.report(static_cast<std::size_t>(part * steps)); };
  const auto parts = geodesic::findCentres(solver, request);
  if (parts.empty())
  {
    return;
  }

  const geodesic::bridge::InputPathAttributes attributes(surface, blocks);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  std::array<vtkNew<vtkIdTypeArray>, 5> integers;
  const std::array integerNames{ "Part", "Role", "OriginalPointIds", "NumberOfFields",
    "OriginalBlocks" };
  std::array<vtkNew<vtkDoubleArray>, 4> numbers;
  const std::array numberNames{ "Radius", "LeastRadius", "Diameter", "MostDiameter" };
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    const geodesic::PartExtent& extent = parts[part];
    const std::array roles{ extent.centre, extent.ends[0], extent.ends[1] };
    for (std::size_t role = 0; role < roles.size(); ++role)
    {
      const geodesic::Vector3& position = surface.mesh()->position(roles[role]);
      const vtkIdType point = points->InsertNextPoint(position.x, position.y, position.z);
      vertices->InsertNextCell(1, &point);
      const std::array values{ static_cast<vtkIdType>(part), static_cast<vtkIdType>(role),
        attributes.idOf(roles[role]), static_cast<vtkIdType>(extent.numberOfFields),
        attributes.blockOf(roles[role]) };
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        integers[i]->InsertNextValue(values[i]);
      }
      const std::array measures{ extent.radius, extent.leastRadius, extent.diameter,
        extent.mostDiameter };
      for (std::size_t i = 0; i < measures.size(); ++i)
      {
        numbers[i]->InsertNextValue(measures[i]);
      }
    }
    for (const auto& [less, more] : { std::pair(extent.leastRadius, extent.radius),
           std::pair(extent.diameter, extent.mostDiameter) })
    {
      this->LargestError = std::max(this->LargestError, more > 0.0 ? 1.0 - less / more : 0.0);
    }
  }
  this->NumberOfParts = static_cast<vtkIdType>(parts.size());
  auto* centres = vtkPolyData::SafeDownCast(output);
  centres->SetPoints(points);
  centres->SetVerts(vertices);
  const std::size_t written = surface.numbering().hasUniqueIds() ? 4 : 5;
  for (std::size_t i = 0; i < written; ++i)
  {
    integers[i]->SetName(integerNames[i]);
    centres->GetPointData()->AddArray(integers[i]);
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i]->SetName(numberNames[i]);
    centres->GetPointData()->AddArray(numbers[i]);
  }
  centres->GetPointData()->SetActiveScalars("Role");
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicCentre::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RelativeError: " << this->RelativeError << "\n";
  os << indent << "MaximumNumberOfFields: " << this->MaximumNumberOfFields << "\n";
  os << indent << "NumberOfParts: " << this->NumberOfParts << "\n";
  os << indent << "LargestError: " << this->LargestError << "\n";
}
