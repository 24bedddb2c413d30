// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicRegion.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTypes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include "filter/ErrorMessage.h"
#include "filter/InputTimes.h"
#include "filter/SetUpReporter.h"
#include "filter/VtkVersions.h"
#include "input/InputBlocks.h"
#include "input/InputSurface.h"
#include "input/PointIdentity.h"
#include "lines/CutLines.h"
#include "lines/GlobalLines.h"
#include "lines/GlobalRegions.h"
#include "output/BlockOutput.h"
#include "output/PathAttributes.h"
#include "output/RegionOutput.h"
#include "pieces/DistributedSurface.h"
#include "pieces/InnerFaces.h"
#include "pieces/PointKeys.h"
#include "ranks/RankGroup.h"
#include "request/RegionLines.h"
#include "split/RegionCut.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

namespace
{

void checkInput(vtkDataObject* input)
{
  if (geodesic::bridge::hasOverlappingLevels(input))
  {
    throw std::invalid_argument(std::string("The input is a ") + input->GetClassName() +
      ", whose blocks overlap, so they are not one surface. Make a surface of it, for example "
      "by Slice or Contour.");
  }
}

/** Replaces the values of an array. */
void setValues(vtkDoubleArray* array, const std::vector<double>& values)
{
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
}

}

/** The state that is kept from run to run, so that only what changed is computed again. */
struct vtkSurfaceGeodesicRegion::Internals
{
  std::shared_ptr<const geodesic::distributed::DistributedSurface> Surface;
  std::shared_ptr<const geodesic::RegionMesh> Mesh;
  geodesic::bridge::RegionLines Lines;
};

vtkStandardNewMacro(vtkSurfaceGeodesicRegion);

//------------------------------------------------------------------------------
vtkSurfaceGeodesicRegion::vtkSurfaceGeodesicRegion()
  : Internal(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(NUMBER_OF_PORTS);
  this->RegionAreas->SetName("RegionArea");
  this->RegionPerimeters->SetName("RegionPerimeter");
}

//------------------------------------------------------------------------------
vtkSurfaceGeodesicRegion::~vtkSurfaceGeodesicRegion() = default;

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicRegion::SetLinesConnection(vtkAlgorithmOutput* lines)
{
  this->SetInputConnection(LINES_PORT, lines);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicRegion::ClearInsidePositions()
{
  this->InsideCoordinates.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicRegion::AddInsideCoordinate(double coordinate)
{
  this->InsideCoordinates.push_back(coordinate);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicRegion::SetRegionArrayName(const char* name)
{
  const std::string newName = name ? name : "";
  if (this->RegionArrayName != newName)
  {
    this->RegionArrayName = newName;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkSurfaceGeodesicRegion::GetRegionArrayName()
{
  return this->RegionArrayName.c_str();
}

//------------------------------------------------------------------------------
vtkIdType vtkSurfaceGeodesicRegion::GetNumberOfRegions()
{
  return this->RegionAreas->GetNumberOfValues();
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkSurfaceGeodesicRegion::GetRegionAreas()
{
  return this->RegionAreas;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkSurfaceGeodesicRegion::GetRegionPerimeters()
{
  return this->RegionPerimeters;
}

//------------------------------------------------------------------------------
const char* vtkSurfaceGeodesicRegion::GetErrorText()
{
  return this->ErrorText.c_str();
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicRegion::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == SURFACE_PORT ? "vtkDataSet" : "vtkPointSet");
  // The executive passes composite data whole, and not block by block, only if they are among these
  // types.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  if (port != SURFACE_PORT)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicRegion::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* tree = vtkDataObjectTree::GetData(inputVector[SURFACE_PORT]);
  const char* className = tree ? tree->GetClassName() : "vtkPolyData";
  vtkDataObject* present = vtkDataObject::GetData(outputVector);
  if (!present || std::string(present->GetClassName()) != className)
  {
    const auto output = vtk::TakeSmartPointer(vtkDataObjectTypes::NewDataObject(className));
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), output);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicRegion::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  geodesic::bridge::takeTimesOfInputs(this->GetNumberOfInputPorts(), inputVector, outputVector);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicRegion::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  const auto begin = std::chrono::steady_clock::now();
  this->ErrorText.clear();
  this->RegionAreas->SetNumberOfValues(0);
  this->RegionPerimeters->SetNumberOfValues(0);
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
  this->RunTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicRegion::RunOnAll(geodesic::distributed::RankGroup& ranks,
  vtkInformationVector** inputVector, vtkDataObject* output)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[SURFACE_PORT]);
  std::unique_ptr<geodesic::bridge::InputBlocks> blocks;
  ranks.together(
    [&]
    {
      checkInput(input);
      blocks = std::make_unique<geodesic::bridge::InputBlocks>(input);
    });
  std::vector<double> settings{ static_cast<double>(this->Extract),
    static_cast<double>(this->MergeCoincidentPoints), static_cast<double>(this->ConnectBlocks),
    static_cast<double>(std::hash<std::string>{}(this->RegionArrayName)),
    static_cast<double>(this->InsideCoordinates.size()) };
  settings.insert(settings.end(), this->InsideCoordinates.begin(), this->InsideCoordinates.end());
  ranks.requireSame(settings, "properties");
  if (this->Extract != EXTRACT_ALL && this->InsideCoordinates.empty())
  {
    throw std::invalid_argument(std::string("Extract is ") +
      (this->Extract == EXTRACT_INSIDE ? "Inside" : "Outside") +
      ", and there are no InsidePositions. Give x, y and z of a point of each region that is "
      "inside.");
  }
  const geodesic::bridge::PointIdentity identity = geodesic::distributed::identityOf(
    ranks, *blocks, this->MergeCoincidentPoints, this->ConnectBlocks);
  geodesic::distributed::hideInnerFaces(ranks, *blocks, identity);
  if (ranks.size() > 1)
  {
    // Each face counts once, on the rank that owns it.
    ranks.together([&] { blocks->hideGhosts(); });
  }
  Internals& internal = *this->Internal;
  internal.Surface = geodesic::distributed::DistributedSurface::of(
    ranks, *blocks, identity, geodesic::ThreadTeam(ranks.threadsOfThisRank()));
  const auto& mesh = internal.Surface->piece().mesh();
  ranks.together(
    [&]
    {
      if (!internal.Mesh || &internal.Mesh->mesh() != mesh.get())
      {
        internal.Mesh = std::make_shared<const geodesic::RegionMesh>(mesh);
      }
    });
  vtkDataObject* source = vtkDataObject::GetData(inputVector[LINES_PORT]);
  if (ranks.size() == 1)
  {
    this->CutWhole(ranks, *blocks, source, input, output);
  }
  else
  {
    this->CutPiece(ranks, *blocks, source, input, output);
  }
}

//------------------------------------------------------------------------------
bool vtkSurfaceGeodesicRegion::GoesOn(double progress)
{
  this->UpdateProgress(std::max(this->GetProgress(), progress));
  return !geodesic::bridge::checkAbort(*this);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicRegion::CutWhole(geodesic::distributed::RankGroup& ranks,
  const geodesic::bridge::InputBlocks& blocks, vtkDataObject* source, vtkDataObject* input,
  vtkDataObject* output)
{
  Internals& internal = *this->Internal;
  if (!internal.Lines.update(
        internal.Surface->sharedPiece(), source, [this] { return this->GoesOn(0.2); }) ||
    !this->GoesOn(0.4))
  {
    return;
  }
  geodesic::RegionCut cut(internal.Mesh, internal.Lines.paths());
  if (!this->GoesOn(0.7))
  {
    return;
  }
  this->Write(ranks, blocks, cut, input, output);
  std::vector<std::pair<geodesic::Index, geodesic::Index>> ends;
  std::vector<bool> separates;
  for (std::size_t line = 0; line < internal.Lines.paths().size(); ++line)
  {
    const std::vector<geodesic::Index> points = cut.pointsOf(line);
    ends.emplace_back(points.front(), points.back());
    separates.push_back(cut.separates(line));
  }
  this->Warn(geodesic::bridge::linesThatSeparateNothing(ends, separates));
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicRegion::CutPiece(geodesic::distributed::RankGroup& ranks,
  const geodesic::bridge::InputBlocks& blocks, vtkDataObject* source, vtkDataObject* input,
  vtkDataObject* output)
{
  const geodesic::distributed::DistributedSurface& surface = *this->Internal->Surface;
  ranks.together(
    [&]
    {
      if (source)
      {
        geodesic::bridge::checkHasLines(geodesic::bridge::PointSource(source));
      }
    });
  const geodesic::bridge::InputPathAttributes attributes(surface.piece(), blocks);
  const auto lines = geodesic::distributed::globalLinesOf(ranks, surface, source, "Lines");
  const geodesic::distributed::CutLines ofPiece = geodesic::distributed::cutLinesOf(
    ranks, surface, geodesic::distributed::joinedLines(ranks, surface, attributes, lines, "Lines"));
  this->UpdateProgress(0.4);
  std::optional<geodesic::RegionCut> cut;
  ranks.together(
    [&] {
      cut.emplace(this->Internal->Mesh, ofPiece.parts, geodesic::distributed::sharedFlags(surface));
    });
  geodesic::distributed::joinRegions(ranks, surface, *cut);
  this->UpdateProgress(0.7);
  this->Write(ranks, blocks, *cut, input, output);
  std::vector<double> isUseless(lines.size(), 1.0);
  for (std::size_t part = 0; part < ofPiece.parts.size(); ++part)
  {
    if (cut->separates(part))
    {
      isUseless[ofPiece.lineOf[part]] = 0.0;
    }
  }
  ranks.takeLeast(isUseless);
  std::vector<bool> separates;
  for (const double none : isUseless)
  {
    separates.push_back(none == 0.0);
  }
  if (ranks.rank() == 0)
  {
    this->Warn(geodesic::bridge::linesThatSeparateNothing(ofPiece.ends, separates));
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicRegion::Write(geodesic::distributed::RankGroup& ranks,
  const geodesic::bridge::InputBlocks& blocks, geodesic::RegionCut& cut, vtkDataObject* input,
  vtkDataObject* output)
{
  const geodesic::distributed::DistributedSurface& surface = *this->Internal->Surface;
  std::vector<bool> kept(cut.areas().size(), this->Extract != EXTRACT_INSIDE);
  const auto inside = geodesic::distributed::globalPointsAt(
    ranks, surface, this->InsideCoordinates, "InsidePositions");
  if (!inside.empty())
  {
    const auto regionsOf = [&]
    { return geodesic::distributed::regionsWith(ranks, cut, inside, "InsidePositions"); };
    cut.putFirst(regionsOf().front());
    for (const geodesic::Index region : regionsOf())
    {
      kept[region] = this->Extract != EXTRACT_OUTSIDE;
    }
  }
  const std::vector<vtkIdType> newIds =
    geodesic::distributed::idsOfNewPoints(ranks, surface, blocks, cut);
  ranks.together(
    [&]
    {
      setValues(this->RegionAreas, cut.areas());
      setValues(this->RegionPerimeters, cut.perimeters());
      const geodesic::bridge::RegionOutput regions(blocks, surface.piece(), cut, kept,
        this->Extract == EXTRACT_ALL, this->RegionArrayName, newIds);
      geodesic::bridge::writeBlocks(blocks, input, output,
        [&](std::size_t block, vtkPolyData* ofBlock)
        {
          regions.complete(block, ofBlock);
          for (vtkDoubleArray* measure : { this->RegionAreas.Get(), this->RegionPerimeters.Get() })
          {
            vtkNew<vtkDoubleArray> copy;
            copy->DeepCopy(measure);
            ofBlock->GetFieldData()->AddArray(copy);
          }
        });
    });
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicRegion::Warn(const std::string& message)
{
  this->ErrorText = message;
  if (!message.empty())
  {
    vtkWarningMacro(<< message);
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicRegion::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const extracts[] = { "All", "Inside", "Outside" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InsidePositions: " << this->InsideCoordinates.size() / 3 << "\n";
  os << indent << "Extract: " << extracts[this->Extract] << "\n";
  os << indent << "RegionArrayName: " << this->RegionArrayName << "\n";
  os << indent << "MergeCoincidentPoints: " << this->MergeCoincidentPoints << "\n";
  os << indent << "ConnectBlocks: " << this->ConnectBlocks << "\n";
  os << indent << "NumberOfRegions: " << this->GetNumberOfRegions() << "\n";
}
