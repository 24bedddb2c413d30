// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicFilter.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataObjectTypes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkSmartPointer.h"

#include "base/IdleProcessors.h"
#include "base/NumberText.h"
#include "base/ThreadTeam.h"
#include "filter/ErrorMessage.h"
#include "filter/InputTimes.h"
#include "filter/SetUpReporter.h"
#include "filter/VtkThreads.h"
#include "filter/VtkVersions.h"
#include "global/SharedCostAndBarriers.h"
#include "input/ArrayValues.h"
#include "input/InputBlocks.h"
#include "input/InputSurface.h"
#include "input/PointIdentity.h"
#include "methods/SolverTable.h"
#include "pieces/DistributedSurface.h"
#include "pieces/InnerFaces.h"
#include "pieces/PointKeys.h"
#include "ranks/RankGroup.h"
#include "request/CostAndBarriers.h"
#include "request/PointResolver.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace
{

void checkRequest(vtkDataObject* input)
{
  if (geodesic::bridge::hasOverlappingLevels(input))
  {
    throw std::invalid_argument(std::string("The input is a ") + input->GetClassName() +
      ", whose blocks overlap, so they are not one surface. Make a surface of it, for example "
      "by Slice or Contour.");
  }
}

}

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
  SetOutputClass(outputVector, "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicFilter::SetOutputClass(
  vtkInformationVector* outputVector, const char* className, int port)
{
  vtkDataObject* present = vtkDataObject::GetData(outputVector, port);
  if (!present || std::string(present->GetClassName()) != className)
  {
    const auto output = vtk::TakeSmartPointer(vtkDataObjectTypes::NewDataObject(className));
    outputVector->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(), output);
  }
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicFilter::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  geodesic::bridge::takeTimesOfInputs(this->GetNumberOfInputPorts(), inputVector, outputVector);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicFilter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  const auto begin = std::chrono::steady_clock::now();
  this->ErrorText.clear();
  try
  {
    geodesic::distributed::RankGroup ranks(vtkMultiProcessController::GetGlobalController());
    constexpr double shareOfSetUp = 0.2;
    std::optional<geodesic::bridge::SetUpReporter> setUp;
    if (ranks.size() == 1)
    {
      setUp.emplace(*this, shareOfSetUp);
    }
    ranks.run([&] { this->RunOnAll(ranks, inputVector, output); });
  }
  catch (const geodesic::Interrupted&)
  {
    this->Forget();
    output->Initialize();
  }
  catch (const std::exception& error)
  {
    this->Forget();
    output->Initialize();
    this->Report(geodesic::bridge::messageOf(error));
  }
  this->RunTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicFilter::RunOnAll(geodesic::distributed::RankGroup& ranks,
  vtkInformationVector** inputVector, vtkDataObject* output)
{
  std::optional<geodesic::bridge::InputBlocks> blocks;
  ranks.together(
    [&]
    {
      vtkDataObject* input = vtkDataObject::GetData(inputVector[SURFACE_PORT]);
      checkRequest(input);
      // These throw where there is no such method, or a number is out of its range.
      this->GetSolver();
      this->GetCheckedTolerance();
      this->GetMemoryLimitInBytes();
      this->CheckNumberOfThreads();
      blocks.emplace(input);
    });
  std::vector<double> numbers;
  this->DescribeRequest(numbers);
  ranks.requireSame(numbers, "properties");
  geodesic::distributed::hideInnerFaces(ranks, *blocks,
    geodesic::distributed::identityOf(
      ranks, *blocks, this->MergeCoincidentPoints, this->ConnectBlocks));
  this->Compute(ranks, *blocks, inputVector, output);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicFilter::Report(const std::string& message)
{
  this->ErrorText = message;
  vtkErrorMacro(<< message);
}

//------------------------------------------------------------------------------
const char* vtkSurfaceGeodesicFilter::GetErrorText()
{
  return this->ErrorText.c_str();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicFilter::DescribeRequest(std::vector<double>& numbers)
{
  numbers.insert(numbers.end(),
    { static_cast<double>(this->CostMode), static_cast<double>(this->Method), this->Tolerance,
      this->MemoryLimit, static_cast<double>(this->MergeCoincidentPoints),
      static_cast<double>(this->ConnectBlocks), static_cast<double>(this->NumberOfThreads) });
  for (const int number : { SEED_ARRAY, COST_ARRAY, BARRIER_ARRAY })
  {
    vtkInformation* choice = this->GetInputArrayInformation(number);
    const char* name = choice->Get(vtkDataObject::FIELD_NAME());
    numbers.push_back(static_cast<double>(std::hash<std::string>{}(name ? name : "")));
    numbers.push_back(choice->Get(vtkDataObject::FIELD_ASSOCIATION()));
  }
}

//------------------------------------------------------------------------------
geodesic::bridge::ChosenArray vtkSurfaceGeodesicFilter::GetChosenArray(
  int number, const geodesic::bridge::InputBlocks& blocks)
{
  static const char* const properties[] = { "SeedArray", "CostArray", "BarrierArray" };
  vtkInformation* choice = this->GetInputArrayInformation(number);
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  // A rank without a part of the surface may lack the surface's arrays.
  if (!name || !*name || blocks.numberWithFaces() == 0)
  {
    return {};
  }
  return geodesic::bridge::chosenArray(blocks, properties[number], name,
    choice->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::CELL);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicFilter::GatherCostAndBarriers(geodesic::distributed::RankGroup& ranks,
  const geodesic::bridge::InputBlocks& blocks,
  const geodesic::distributed::DistributedSurface& surface, geodesic::bridge::Barriers& barriers,
  std::vector<double>& cost)
{
  ranks.together(
    [&]
    {
      this->GatherBarriers(blocks, surface.piece(), barriers);
      cost = this->GatherCost(blocks, surface.piece());
    });
  geodesic::distributed::shareExcluded(ranks, surface.divided(), barriers.excluded);
  geodesic::distributed::shareCost(ranks, surface, cost);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicFilter::GatherBarriers(const geodesic::bridge::InputBlocks& blocks,
  const geodesic::bridge::InputSurface& surface, geodesic::bridge::Barriers& barriers)
{
  if (const auto array = this->GetChosenArray(BARRIER_ARRAY, blocks))
  {
    geodesic::bridge::addBarrierArray(surface, array, barriers);
  }
}

//------------------------------------------------------------------------------
std::vector<double> vtkSurfaceGeodesicFilter::GatherCost(
  const geodesic::bridge::InputBlocks& blocks, const geodesic::bridge::InputSurface& surface)
{
  const auto array = this->GetChosenArray(COST_ARRAY, blocks);
  if (!array)
  {
    return {};
  }
  return geodesic::bridge::costOfArray(surface, array,
    this->CostMode == COST ? geodesic::bridge::CostMeaning::Cost
                           : geodesic::bridge::CostMeaning::Speed);
}

//------------------------------------------------------------------------------
std::shared_ptr<const geodesic::distributed::DistributedSurface>
vtkSurfaceGeodesicFilter::FindSurface(
  geodesic::distributed::RankGroup& ranks, const geodesic::bridge::InputBlocks& blocks) const
{
  const unsigned all = ranks.threadsOfThisRank();
  const geodesic::ThreadTeam team(
    this->NumberOfThreads > 0 ? static_cast<unsigned>(this->NumberOfThreads) : all);
  return geodesic::distributed::DistributedSurface::of(ranks, blocks,
    geodesic::distributed::identityOf(
      ranks, blocks, this->MergeCoincidentPoints, this->ConnectBlocks),
    team);
}

//------------------------------------------------------------------------------
const geodesic::SolverTraits& vtkSurfaceGeodesicFilter::GetSolver() const
{
  return geodesic::solverOfNumber(this->Method);
}

//------------------------------------------------------------------------------
bool vtkSurfaceGeodesicFilter::NeedsOneOf(const geodesic::distributed::RankGroup& ranks) const
{
  return ranks.size() > 1 && this->GetSolver().ranks == geodesic::RankSupport::None;
}

//------------------------------------------------------------------------------
double vtkSurfaceGeodesicFilter::GetCheckedTolerance() const
{
  if (!(this->Tolerance > 0.0))
  {
    throw std::invalid_argument("Tolerance is " + geodesic::textOf(this->Tolerance) +
      "; give a number above 0, such as 0.001 for a thousandth of each distance.");
  }
  return this->Tolerance;
}

//------------------------------------------------------------------------------
std::size_t vtkSurfaceGeodesicFilter::GetMemoryLimitInBytes() const
{
  constexpr double bytes = 1e9;
  constexpr double most = 1e9;
  if (!(this->MemoryLimit >= 0.0 && this->MemoryLimit <= most))
  {
    throw std::invalid_argument("MemoryLimit is " + geodesic::textOf(this->MemoryLimit) +
      "; give gigabytes from 0 (three quarters of the machine's memory) to 1e9.");
  }
  // A limit of less than a byte is one, too.
  return static_cast<std::size_t>(std::ceil(this->MemoryLimit * bytes));
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicFilter::CheckNumberOfThreads() const
{
  constexpr int most = 1024;
  if (this->NumberOfThreads < -1 || this->NumberOfThreads > most)
  {
    throw std::invalid_argument("NumberOfThreads is " + std::to_string(this->NumberOfThreads) +
      "; give -1 (the default), 0 (all processors) or a number from 1 to " + std::to_string(most) +
      ".");
  }
}

//------------------------------------------------------------------------------
std::size_t vtkSurfaceGeodesicFilter::GetThreadsOfRun(geodesic::distributed::RankGroup& ranks) const
{
  const std::size_t all = ranks.threadsOfThisRank();
  if (this->NumberOfThreads > 0)
  {
    return static_cast<std::size_t>(this->NumberOfThreads);
  }
  const auto ofVtk = static_cast<std::size_t>(geodesic::bridge::threadsOfVtk());
  return this->NumberOfThreads == 0 ? all : std::min(all, ofVtk);
}

//------------------------------------------------------------------------------
geodesic::ThreadTeam vtkSurfaceGeodesicFilter::GetTeamOfRun(
  geodesic::distributed::RankGroup& ranks) const
{
  return geodesic::ThreadTeam(static_cast<unsigned>(this->GetThreadsOfRun(ranks)));
}

//------------------------------------------------------------------------------
std::size_t vtkSurfaceGeodesicFilter::GetThreadsOfField(
  geodesic::distributed::RankGroup& ranks, bool areManyThin) const
{
  const std::size_t threads = this->GetThreadsOfRun(ranks);
  if (this->NumberOfThreads >= 0)
  {
    return threads;
  }
  // Threads of one march wait for each other: beside other busy programs they are slower than one.
  // On needles a front may not settle on several.
  return areManyThin ? 1 : std::min<std::size_t>(threads, geodesic::idleProcessors());
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CostMode: " << (this->CostMode == COST ? "Cost" : "Speed") << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "MergeCoincidentPoints: " << this->MergeCoincidentPoints << "\n";
  os << indent << "ConnectBlocks: " << this->ConnectBlocks << "\n";
}
