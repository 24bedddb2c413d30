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
#include "filter/VtkVersions.h"
#include "input/InputBlocks.h"
#include "input/InputSurface.h"
#include "input/PointIdentity.h"
#include "output/BlockOutput.h"
#include "output/RegionOutput.h"
#include "pieces/InnerFaces.h"
#include "pieces/PointKeys.h"
#include "ranks/RankGroup.h"
#include "request/PointResolver.h"
#include "request/PointSource.h"
#include "request/RegionLines.h"
#include "split/RegionCut.h"

#include <chrono>
#include <functional>
#include <stdexcept>

namespace
{

void checkInput(vtkDataObject* input)
{
  if (geodesic::bridge::hasOverlappingLevels(input))
  {
    throw std::invalid_argument(std::string("The input is a ") + input->GetClassName() +
      ", whose blocks overlap and are no surface together. Give a surface of it, for example by "
      "Slice or Contour.");
  }
}

/** The regions that hold positions, in their order; a region can come again. */
std::vector<geodesic::Index> regionsWith(const geodesic::bridge::InputSurface& surface,
  const geodesic::RegionCut& cut, const std::vector<double>& coordinates)
{
  std::vector<geodesic::Index> regions;
  for (const geodesic::Vector3& position :
    geodesic::bridge::positionsAt(coordinates, "InsidePositions"))
  {
    const auto there = cut.regionsAt(surface.closestPoints().closestPoint(position).point);
    if (there.size() > 1)
    {
      throw std::invalid_argument("Point " + std::to_string(regions.size()) +
        " of InsidePositions lies on a line, between " + std::to_string(there.size()) +
        " regions; move it off the line.");
    }
    regions.push_back(there.front());
  }
  return regions;
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
  std::shared_ptr<const geodesic::bridge::InputSurface> Surface;
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
    ranks.run([&] { this->RunOnAll(ranks, inputVector, output); });
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
  geodesic::distributed::hideInnerFaces(ranks, *blocks,
    geodesic::distributed::identityOf(
      ranks, *blocks, this->MergeCoincidentPoints, this->ConnectBlocks));
  const bool hasFaces = blocks->numberWithFaces() > 0;
  const double ranksWithFaces = ranks.sum(hasFaces ? 1.0 : 0.0);
  const bool cuts = hasFaces || (ranksWithFaces == 0.0 && ranks.rank() == 0);
  ranks.together(
    [&]
    {
      if (ranksWithFaces > 1.0)
      {
        throw std::invalid_argument("The surface is spread over " +
          std::to_string(static_cast<int>(ranksWithFaces)) +
          " ranks, and Geodesic Region needs all of it on one. Bring the surface and the lines to "
          "one by Aggregate Dataset.");
      }
      vtkDataObject* lines = vtkDataObject::GetData(inputVector[LINES_PORT]);
      if (!cuts && lines && !geodesic::bridge::PointSource(lines).lines.empty())
      {
        throw std::invalid_argument("Lines are on rank " + std::to_string(ranks.rank()) +
          ", and the surface is on another. Bring both to one by Aggregate Dataset.");
      }
      if (cuts)
      {
        this->Cut(*blocks, inputVector, output);
      }
      else
      {
        geodesic::bridge::writeBlocks(*blocks, input, output, [](std::size_t, vtkPolyData*) {});
      }
    });
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicRegion::Cut(const geodesic::bridge::InputBlocks& blocks,
  vtkInformationVector** inputVector, vtkDataObject* output)
{
  if (this->Extract != EXTRACT_ALL && this->InsideCoordinates.empty())
  {
    throw std::invalid_argument(std::string("Extract is ") +
      (this->Extract == EXTRACT_INSIDE ? "Inside" : "Outside") +
      ", and there are no InsidePositions. Give x, y and z of a point of each region that is "
      "inside.");
  }
  const auto goesOn = [this](double progress)
  {
    this->UpdateProgress(progress);
    return !geodesic::bridge::checkAbort(*this);
  };
  Internals& internal = *this->Internal;
  internal.Surface = geodesic::bridge::InputSurface::of(
    blocks, geodesic::bridge::identityOf(blocks, this->MergeCoincidentPoints, this->ConnectBlocks));
  if (!internal.Mesh || &internal.Mesh->mesh() != internal.Surface->mesh().get())
  {
    internal.Mesh = std::make_shared<const geodesic::RegionMesh>(internal.Surface->mesh());
  }
  if (!internal.Lines.update(internal.Surface, vtkDataObject::GetData(inputVector[LINES_PORT]),
        [&] { return goesOn(0.2); }) ||
    !goesOn(0.4))
  {
    return;
  }
  geodesic::RegionCut cut(internal.Mesh, internal.Lines.paths());
  if (!goesOn(0.7))
  {
    return;
  }
  std::vector<bool> kept(cut.areas().size(), this->Extract != EXTRACT_INSIDE);
  if (!this->InsideCoordinates.empty())
  {
    cut.putFirst(regionsWith(*internal.Surface, cut, this->InsideCoordinates).front());
    for (const geodesic::Index region :
      regionsWith(*internal.Surface, cut, this->InsideCoordinates))
    {
      kept[region] = this->Extract != EXTRACT_OUTSIDE;
    }
  }
  setValues(this->RegionAreas, cut.areas());
  setValues(this->RegionPerimeters, cut.perimeters());
  const geodesic::bridge::RegionOutput regions(
    blocks, *internal.Surface, cut, kept, this->Extract == EXTRACT_ALL, this->RegionArrayName);
  geodesic::bridge::writeBlocks(blocks, vtkDataObject::GetData(inputVector[SURFACE_PORT]), output,
    [&](std::size_t block, vtkPolyData* surface)
    {
      regions.complete(block, surface);
      for (vtkDoubleArray* measure : { this->RegionAreas.Get(), this->RegionPerimeters.Get() })
      {
        vtkNew<vtkDoubleArray> copy;
        copy->DeepCopy(measure);
        surface->GetFieldData()->AddArray(copy);
      }
    });
  this->ErrorText = geodesic::bridge::linesThatSeparateNothing(cut, internal.Lines.paths().size());
  if (!this->ErrorText.empty())
  {
    vtkWarningMacro(<< this->ErrorText);
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
