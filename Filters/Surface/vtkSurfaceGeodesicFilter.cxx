// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicFilter.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include "DijkstraSolver.h"
#include "DistributedSurface.h"
#include "ErrorMessage.h"
#include "FastMarchingSolver.h"
#include "GuideResolver.h"
#include "InputSurface.h"
#include "PointResolver.h"
#include "RankGroup.h"

#include <stdexcept>
#include <string>

//------------------------------------------------------------------------------
vtkSurfaceGeodesicFilter::vtkSurfaceGeodesicFilter() = default;

//------------------------------------------------------------------------------
vtkSurfaceGeodesicFilter::~vtkSurfaceGeodesicFilter() = default;

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicFilter::SetBarrierSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(BARRIER_SOURCE_PORT, source);
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicFilter::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  if (!vtkPolyData::GetData(outputVector))
  {
    vtkNew<vtkPolyData> output;
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), output);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicFilter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    this->Compute(inputVector, output);
  }
  catch (const std::exception& error)
  {
    this->Forget();
    output->Initialize();
    vtkErrorMacro(<< geodesic::bridge::messageOf(error));
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSurfaceGeodesicFilter::GetSurface(vtkInformationVector** inputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[SURFACE_PORT]);
  vtkPolyData* surface = vtkPolyData::SafeDownCast(input);
  if (!surface)
  {
    throw std::invalid_argument(std::string("The input is a ") + input->GetClassName() +
      ", whose blocks this version does not join to one surface. Merge them first: in ParaView, "
      "Merge Blocks and then Extract Surface.");
  }
  return surface;
}

//------------------------------------------------------------------------------
vtkPointSet* vtkSurfaceGeodesicFilter::GetOptionalPointSet(
  vtkInformationVector* inputVector, const char* property)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector);
  vtkPointSet* source = vtkPointSet::SafeDownCast(input);
  if (input && !source)
  {
    throw std::invalid_argument(std::string(property) + " is a " + input->GetClassName() +
      " of several blocks. Merge them first: in ParaView, by Merge Blocks.");
  }
  return source;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkSurfaceGeodesicFilter::GetChosenArray(
  int number, vtkInformationVector** inputVector, bool& isOfCells)
{
  vtkInformation* choice = this->GetInputArrayInformation(number);
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  const std::string wanted = name ? name : "";
  isOfCells = choice->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::CELL;
  if (wanted.empty())
  {
    return nullptr;
  }
  vtkPolyData* input = this->GetSurface(inputVector);
  vtkDataSetAttributes* attributes = isOfCells
    ? static_cast<vtkDataSetAttributes*>(input->GetCellData())
    : static_cast<vtkDataSetAttributes*>(input->GetPointData());
  vtkDataArray* array = attributes->GetArray(wanted.c_str());
  // ParaView's choice of no array is the name None.
  // A rank without any of the surface may be without its arrays.
  if (!array && wanted != "None" && input->GetNumberOfPoints() > 0)
  {
    static const char* const roles[] = { "SeedArray", "CostArray", "BarrierArray" };
    throw std::invalid_argument(std::string(roles[number]) + " \"" + wanted + "\" is no " +
      (isOfCells ? "cell" : "point") + " array of the input. Choose one that is, or None.");
  }
  return array;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicFilter::GatherBarriers(vtkInformationVector** inputVector,
  const geodesic::bridge::InputSurface& surface, geodesic::bridge::Barriers& barriers)
{
  bool isOfCells = false;
  if (vtkDataArray* array = this->GetChosenArray(BARRIER_ARRAY, inputVector, isOfCells))
  {
    geodesic::bridge::addBarrierArray(surface, array, isOfCells, barriers);
  }
  if (vtkPointSet* source =
        this->GetOptionalPointSet(inputVector[BARRIER_SOURCE_PORT], "BarrierSource"))
  {
    barriers.lines = geodesic::bridge::surfaceLinesOf(surface, source, "BarrierSource");
  }
}

//------------------------------------------------------------------------------
std::vector<double> vtkSurfaceGeodesicFilter::GatherCost(
  vtkInformationVector** inputVector, const geodesic::bridge::InputSurface& surface)
{
  bool isOfCells = false;
  vtkDataArray* array = this->GetChosenArray(COST_ARRAY, inputVector, isOfCells);
  if (!array)
  {
    return {};
  }
  const std::string role = std::string("CostArray \"") + array->GetName() + "\"";
  if (isOfCells)
  {
    throw std::invalid_argument(
      role + " is a cell array; give a point array, for example by Cell Data to Point Data.");
  }
  return geodesic::bridge::costOfArray(*surface.mesh(), array,
    this->CostMode == COST ? geodesic::bridge::CostMeaning::Cost
                           : geodesic::bridge::CostMeaning::Speed,
    role);
}

//------------------------------------------------------------------------------
std::shared_ptr<const geodesic::bridge::InputSurface> vtkSurfaceGeodesicFilter::FindSurface(
  vtkPolyData* input)
{
  return geodesic::bridge::InputSurface::of(input,
    this->MergeCoincidentPoints ? geodesic::CoincidentPoints::Merge
                                : geodesic::CoincidentPoints::Separate);
}

//------------------------------------------------------------------------------
std::shared_ptr<const geodesic::distributed::DistributedSurface>
vtkSurfaceGeodesicFilter::FindDistributedSurface(
  vtkPolyData* input, geodesic::distributed::RankGroup& ranks)
{
  const auto coincident = this->MergeCoincidentPoints ? geodesic::CoincidentPoints::Merge
                                                      : geodesic::CoincidentPoints::Separate;
  std::shared_ptr<const geodesic::bridge::InputSurface> piece;
  ranks.together(
    [&]
    {
      piece = ranks.size() == 1 ? this->FindSurface(input)
                                : geodesic::bridge::InputSurface::pieceOf(input, coincident);
    });
  return geodesic::distributed::DistributedSurface::of(
    ranks, piece, input->GetPointData()->GetGlobalIds(), coincident);
}

//------------------------------------------------------------------------------
std::unique_ptr<geodesic::DistanceSolver> vtkSurfaceGeodesicFilter::MakeSolver(
  const std::shared_ptr<const geodesic::TriangleMesh>& mesh)
{
  if (this->Method == DIJKSTRA)
  {
    return std::make_unique<geodesic::DijkstraSolver>(mesh);
  }
  return std::make_unique<geodesic::FastMarchingSolver>(mesh);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CostMode: " << (this->CostMode == COST ? "Cost" : "Speed") << "\n";
  os << indent << "Method: " << (this->Method == FAST_MARCHING ? "FastMarching" : "Dijkstra")
     << "\n";
  os << indent << "MergeCoincidentPoints: " << this->MergeCoincidentPoints << "\n";
}
