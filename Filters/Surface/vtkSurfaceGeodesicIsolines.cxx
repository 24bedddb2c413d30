// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicIsolines.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationStringKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSurfaceGeodesicDistance.h"

#include "base/NumberText.h"
#include "base/SortUnique.h"
#include "filter/ErrorMessage.h"
#include "filter/SetUpReporter.h"
#include "filter/VtkVersions.h"
#include "input/ArrayValues.h"
#include "input/InputBlocks.h"
#include "input/InputSurface.h"
#include "input/PointIdentity.h"
#include "mesh/EdgeTable.h"
#include "path/Isolines.h"
#include "pieces/InnerFaces.h"
#include "pieces/PointKeys.h"
#include "ranks/RankGroup.h"
#include "request/CostAndBarriers.h"
#include "request/PointResolver.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{

/** The mark of Geodesic Distance for points without a distance, if it is not NaN. */
constexpr double NoDistance = -1.0;

/**
 * The array of an input of which a script names none: GeodesicDistance, else the active scalars,
 * which Geodesic Distance makes its array whatever its name; None if there is neither.
 */
std::string defaultArrayOf(const geodesic::bridge::InputBlocks& blocks)
{
  std::string name = "None";
  for (const geodesic::bridge::InputBlock& block : blocks)
  {
    vtkPointData* arrays = block.surface->GetPointData();
    if (arrays->GetArray("GeodesicDistance"))
    {
      return "GeodesicDistance";
    }
    if (arrays->GetScalars() && arrays->GetScalars()->GetName())
    {
      name = arrays->GetScalars()->GetName();
    }
  }
  return name;
}

/** What Geodesic Distance noted on its array, of the first block that has it; null if nothing. */
vtkInformation* noteOnCost(
  const geodesic::bridge::InputBlocks& blocks, const std::string& distances)
{
  for (const geodesic::bridge::InputBlock& block : blocks)
  {
    vtkDataArray* array = block.surface->GetPointData()->GetArray(distances.c_str());
    if (array && array->HasInformation() &&
      array->GetInformation()->Has(vtkSurfaceGeodesicDistance::COST_ARRAY_NAME()))
    {
      return array->GetInformation();
    }
  }
  return nullptr;
}

vtkSmartPointer<vtkDoubleArray> arrayOf(const char* name, std::size_t count)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return array;
}

/** Fills the output with the curves. */
void writeCurves(
  const std::vector<geodesic::Isoline>& curves, const char* distanceName, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  const auto distances = arrayOf(distanceName, curves.size());
  const auto lengths = arrayOf("Length", curves.size());
  const auto areas = arrayOf("EnclosedArea", curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const geodesic::Isoline& curve = curves[i];
    const bool isClosed = curve.points.front() == curve.points.back();
    lines->InsertNextCell(static_cast<int>(curve.points.size()));
    const vtkIdType first = points->GetNumberOfPoints();
    for (std::size_t p = 0; p + (isClosed ? 1 : 0) < curve.points.size(); ++p)
    {
      const geodesic::Vector3& point = curve.points[p];
      lines->InsertCellPoint(points->InsertNextPoint(point.x, point.y, point.z));
    }
    if (isClosed)
    {
      lines->InsertCellPoint(first);
    }
    const auto cell = static_cast<vtkIdType>(i);
    distances->SetValue(cell, curve.level);
    lengths->SetValue(cell, curve.length);
    areas->SetValue(cell, curve.area);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetCellData()->SetScalars(distances);
  output->GetCellData()->AddArray(lengths);
  output->GetCellData()->AddArray(areas);
}

}

/** The state that is kept from run to run, so that only what changed is computed again. */
struct vtkSurfaceGeodesicIsolines::Internals
{
  std::shared_ptr<const geodesic::bridge::InputSurface> Surface;
  std::unique_ptr<const geodesic::EdgeTable> Edges;
};

vtkStandardNewMacro(vtkSurfaceGeodesicIsolines);

//------------------------------------------------------------------------------
vtkSurfaceGeodesicIsolines::vtkSurfaceGeodesicIsolines()
  : Internal(std::make_unique<Internals>())
{
  this->SetInputArrayToProcess(DISTANCE_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "");
  this->SetInputArrayToProcess(COST_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
}

//------------------------------------------------------------------------------
vtkSurfaceGeodesicIsolines::~vtkSurfaceGeodesicIsolines() = default;

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicIsolines::ClearValues()
{
  this->Values.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicIsolines::AddValue(double value)
{
  this->Values.push_back(value);
  this->Modified();
}

//------------------------------------------------------------------------------
const char* vtkSurfaceGeodesicIsolines::GetErrorText()
{
  return this->ErrorText.c_str();
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicIsolines::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  // The executive passes composite data whole, and not block by block, only if they are among these
  // types.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicIsolines::RequestDataObject(vtkInformation* vtkNotUsed(request),
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
int vtkSurfaceGeodesicIsolines::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->ErrorText.clear();
  try
  {
    geodesic::distributed::RankGroup ranks(vtkMultiProcessController::GetGlobalController());
    constexpr double shareOfSetUp = 0.9;
    std::optional<geodesic::bridge::SetUpReporter> setUp;
    if (ranks.size() == 1)
    {
      setUp.emplace(*this, shareOfSetUp);
    }
    ranks.run([&] { this->RunOnAll(ranks, inputVector, output); });
  }
  catch (const geodesic::Interrupted&)
  {
    *this->Internal = Internals();
    output->Initialize();
  }
  catch (const std::exception& error)
  {
    *this->Internal = Internals();
    output->Initialize();
    this->ErrorText = geodesic::bridge::messageOf(error);
    vtkErrorMacro(<< this->ErrorText);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicIsolines::RunOnAll(
  geodesic::distributed::RankGroup& ranks, vtkInformationVector** inputVector, vtkPolyData* output)
{
  std::unique_ptr<geodesic::bridge::InputBlocks> blocks;
  ranks.together(
    [&]
    {
      vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
      if (geodesic::bridge::hasOverlappingLevels(input))
      {
        throw std::invalid_argument(std::string("The input is a ") + input->GetClassName() +
          ", whose blocks overlap, so they are not one surface. Make a surface of it, for example "
          "by Slice or Contour.");
      }
      blocks = std::make_unique<geodesic::bridge::InputBlocks>(input);
    });
  std::vector<double> settings{ static_cast<double>(this->NumberOfValues),
    static_cast<double>(this->MergeCoincidentPoints), static_cast<double>(this->ConnectBlocks),
    static_cast<double>(this->CostMode), static_cast<double>(this->Values.size()) };
  for (const int array : { DISTANCE_ARRAY, COST_ARRAY })
  {
    const char* name = this->GetInputArrayInformation(array)->Get(vtkDataObject::FIELD_NAME());
    settings.push_back(static_cast<double>(std::hash<std::string>{}(name ? name : "")));
  }
  settings.insert(settings.end(), this->Values.begin(), this->Values.end());
  ranks.requireSame(settings, "properties");
  geodesic::distributed::hideInnerFaces(ranks, *blocks,
    geodesic::distributed::identityOf(
      ranks, *blocks, this->MergeCoincidentPoints, this->ConnectBlocks));
  const bool hasFaces = blocks->numberWithFaces() > 0;
  const double ranksWithFaces = ranks.sum(hasFaces ? 1.0 : 0.0);
  ranks.together(
    [&]
    {
      if (ranksWithFaces > 1.0)
      {
        throw std::invalid_argument("The surface is spread over " +
          std::to_string(static_cast<int>(ranksWithFaces)) +
          " ranks, and Geodesic Isolines needs all of it on one. Bring it to one by Aggregate "
          "Dataset.");
      }
      if (hasFaces || (ranksWithFaces == 0.0 && ranks.rank() == 0))
      {
        this->Trace(*blocks, output);
      }
    });
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicIsolines::Trace(
  const geodesic::bridge::InputBlocks& blocks, vtkPolyData* output)
{
  Internals& internal = *this->Internal;
  const auto surface = geodesic::bridge::InputSurface::of(
    blocks, geodesic::bridge::identityOf(blocks, this->MergeCoincidentPoints, this->ConnectBlocks));
  const geodesic::TriangleMesh& mesh = *surface->mesh();
  if (internal.Surface != surface)
  {
    internal.Edges = std::make_unique<const geodesic::EdgeTable>(mesh);
    internal.Surface = surface;
  }
  vtkInformation* choice = this->GetInputArrayInformation(DISTANCE_ARRAY);
  const char* given = choice->Get(vtkDataObject::FIELD_NAME());
  const std::string name = given && *given ? given : defaultArrayOf(blocks);
  const auto array = geodesic::bridge::chosenArray(blocks, "DistanceArray", name,
    choice->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::CELL);
  if (!array || array.isOfCells)
  {
    throw std::invalid_argument(
      "DistanceArray is not a point array of the input. Choose the array of a Geodesic Distance.");
  }
  std::vector<double> distances;
  for (geodesic::Index vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    distances.push_back(array.values[mesh.pointOfVertex(vertex)]);
  }
  const bool isSigned = std::any_of(distances.begin(), distances.end(),
    [](double distance) { return distance < 0.0 && distance != NoDistance; });
  if (!isSigned)
  {
    std::replace(
      distances.begin(), distances.end(), NoDistance, std::numeric_limits<double>::quiet_NaN());
  }
  const std::vector<double> cost = this->CostOf(blocks, *surface, name);
  const std::vector<double> levels = this->LevelsOf(distances, isSigned);
  const double prepared = this->GetProgress();
  std::size_t done = 0;
  const auto curves = geodesic::isolines(mesh, *internal.Edges, distances, cost, levels,
    [&]
    {
      this->UpdateProgress(std::max(this->GetProgress(),
        prepared +
          (1.0 - prepared) * static_cast<double>(done++) / static_cast<double>(levels.size())));
      return !geodesic::bridge::checkAbort(*this);
    });
  writeCurves(curves, name.c_str(), output);
}

//------------------------------------------------------------------------------
std::vector<double> vtkSurfaceGeodesicIsolines::CostOf(const geodesic::bridge::InputBlocks& blocks,
  const geodesic::bridge::InputSurface& surface, const std::string& distances)
{
  vtkInformation* choice = this->GetInputArrayInformation(COST_ARRAY);
  const char* given = choice->Get(vtkDataObject::FIELD_NAME());
  auto array = geodesic::bridge::chosenArray(blocks, "CostArray", given && *given ? given : "None",
    choice->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::CELL);
  int mode = this->CostMode;
  if (vtkInformation* note = array ? nullptr : noteOnCost(blocks, distances))
  {
    const std::string name = note->Get(vtkSurfaceGeodesicDistance::COST_ARRAY_NAME());
    mode = note->Get(vtkSurfaceGeodesicDistance::COST_ARRAY_MODE());
    const bool isThere = std::any_of(blocks.begin(), blocks.end(),
      [&](const geodesic::bridge::InputBlock& block)
      { return block.surface->GetPointData()->HasArray(name.c_str()) != 0; });
    if (!isThere)
    {
      throw std::invalid_argument("The distances \"" + distances +
        "\" were measured with the cost array \"" + name +
        "\", which the input no longer has. Pass it on with them.");
    }
    array = geodesic::bridge::chosenArray(blocks, "CostArray", name, false);
  }
  if (!array)
  {
    return {};
  }
  return geodesic::bridge::costOfArray(surface, array,
    mode == COST ? geodesic::bridge::CostMeaning::Cost : geodesic::bridge::CostMeaning::Speed);
}

//------------------------------------------------------------------------------
std::vector<double> vtkSurfaceGeodesicIsolines::LevelsOf(
  const std::vector<double>& distances, bool isSigned) const
{
  std::vector<double> levels = this->Values;
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    if (!std::isfinite(levels[i]))
    {
      throw std::invalid_argument("Value " + std::to_string(i) + " of Values is " +
        geodesic::textOf(levels[i]) + "; give finite distances.");
    }
  }
  if (levels.empty())
  {
    if (this->NumberOfValues < 1 || this->NumberOfValues > MostValues)
    {
      throw std::invalid_argument("NumberOfValues is " + std::to_string(this->NumberOfValues) +
        "; give 1 to " + std::to_string(MostValues) + ", or the distances themselves in Values.");
    }
    double least = 0.0;
    double most = 0.0;
    for (const double distance : distances)
    {
      least = isSigned && std::isfinite(distance) ? std::min(least, distance) : least;
      most = std::isfinite(distance) ? std::max(most, distance) : most;
    }
    for (int i = 1; i <= this->NumberOfValues; ++i)
    {
      levels.push_back(least + i * (most - least) / (this->NumberOfValues + 1.0));
    }
  }
  geodesic::sortUnique(levels);
  return levels;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicIsolines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Values:";
  for (const double value : this->Values)
  {
    os << " " << value;
  }
  os << "\n";
  os << indent << "CostMode: " << (this->CostMode == COST ? "Cost" : "Speed") << "\n";
  os << indent << "NumberOfValues: " << this->NumberOfValues << "\n";
  os << indent << "MergeCoincidentPoints: " << this->MergeCoincidentPoints << "\n";
  os << indent << "ConnectBlocks: " << this->ConnectBlocks << "\n";
}
