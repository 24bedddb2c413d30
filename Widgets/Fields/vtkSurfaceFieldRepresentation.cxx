// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceFieldRepresentation.h"

#include "SameMesh.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPointData.h"
#include "vtkVersionMacros.h"

// The mappers of VTK 9.3 are others; with them this class is its superclass.
#define HAS_OWN_MAPPER (VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0))

#if HAS_OWN_MAPPER
#include "vtkSurfaceFieldMapper.h"
#endif

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkSurfaceFieldRepresentation);

namespace
{

/** Whether some attributes have the same arrays, by their names, and the same ghosts. */
bool haveSameNames(vtkDataSetAttributes* a, vtkDataSetAttributes* b)
{
  const auto sameName = [&](int i)
  {
    const char* name = a->GetArrayName(i);
    return name && b->GetArrayName(i) && std::string(name) == b->GetArrayName(i);
  };
  if (a->GetNumberOfArrays() != b->GetNumberOfArrays() ||
    a->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()) !=
      b->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()))
  {
    return false;
  }
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    if (!sameName(i))
    {
      return false;
    }
  }
  return true;
}

void takeArrays(vtkDataSetAttributes* from, vtkDataSetAttributes* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    if (to->GetAbstractArray(from->GetArrayName(i)) != from->GetAbstractArray(i))
    {
      to->AddArray(from->GetAbstractArray(i));
    }
  }
}

}

vtkSurfaceFieldRepresentation::vtkSurfaceFieldRepresentation()
{
#if HAS_OWN_MAPPER
  auto* mapper = vtkSurfaceFieldMapper::New();
  mapper->vtkMapper::ShallowCopy(this->Mapper);
  mapper->SetProcessIdArrayName("vtkProcessId");
  mapper->SetCompositeIdArrayName("vtkCompositeIndex");
  this->Mapper->Delete();
  this->Mapper = mapper;
  this->SetArrayIdNames(nullptr, nullptr);
  this->SetupDefaults();
#endif
}

vtkSurfaceFieldRepresentation::~vtkSurfaceFieldRepresentation() = default;

int vtkSurfaceFieldRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (this->IsKept(input))
  {
    this->TakeArrays(input);
    return this->vtkPVDataRepresentation::RequestData(request, inputVector, outputVector);
  }
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  vtkPolyData* geometry = this->GetGeometry();
  this->Extracted = nullptr;
  if (input && geometry && haveSameMesh(input, geometry))
  {
    this->Extracted = vtkSmartPointer<vtkPolyData>::New();
    this->Extracted->ShallowCopy(input);
    this->ExtractionTime = this->GetSettingsTime();
  }
  return result;
}

vtkPolyData* vtkSurfaceFieldRepresentation::GetGeometry()
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(this->MultiBlockMaker->GetOutputDataObject(0));
  return blocks && blocks->GetNumberOfBlocks() == 1 ? vtkPolyData::SafeDownCast(blocks->GetBlock(0))
                                                    : nullptr;
}

bool vtkSurfaceFieldRepresentation::IsKept(vtkPolyData* input)
{
  vtkPolyData* extracted = this->Extracted;
  // Several ranks extract the geometry together, and another one may have to do it again.
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  if (!HAS_OWN_MAPPER || (ranks && ranks->GetNumberOfProcesses() > 1))
  {
    return false;
  }
  return input && extracted && haveSameMesh(input, extracted) &&
    std::max(input->GetMeshMTime(), this->GetSettingsTime()) <= this->ExtractionTime &&
    haveSameNames(input->GetPointData(), extracted->GetPointData()) &&
    haveSameNames(input->GetCellData(), extracted->GetCellData());
}

void vtkSurfaceFieldRepresentation::TakeArrays(vtkPolyData* input)
{
  vtkPolyData* geometry = this->GetGeometry();
  takeArrays(input->GetPointData(), geometry->GetPointData());
  takeArrays(input->GetCellData(), geometry->GetCellData());
  geometry->GetFieldData()->ShallowCopy(input->GetFieldData());
  this->MultiBlockMaker->GetOutputDataObject(0)->Modified();
}

vtkMTimeType vtkSurfaceFieldRepresentation::GetSettingsTime()
{
  return std::max(this->GeometryFilter->GetMTime(), this->MultiBlockMaker->GetMTime());
}
