// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceFieldHelper.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLTexture.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

vtkStandardNewMacro(vtkSurfaceFieldHelper);

namespace
{

/** The name of the buffer with the places of values in the colour map. */
constexpr const char* Coordinates = "tcoord";

}

void vtkSurfaceFieldHelper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  const std::vector<std::uintptr_t> description = this->DescribeBuffers(renderer, actor);
  if (!description.empty() && description == this->Description && this->MapToCoordinates())
  {
    this->VBOs->GetVBO(Coordinates)->UploadDataArray(this->ColorCoordinates);
    this->VBOBuildTime.Modified();
    return;
  }
  this->Superclass::BuildBufferObjects(renderer, actor);
  this->Description.clear();
  if (this->ColorCoordinates && !this->HaveCellScalars && !this->HaveCellNormals)
  {
    this->Description = description;
  }
}

std::vector<std::uintptr_t> vtkSurfaceFieldHelper::DescribeBuffers(
  vtkRenderer* renderer, vtkActor* actor)
{
  // These methods move the points in their buffer with the camera.
  const bool isMoving =
    this->ShiftScaleMethod == vtkOpenGLVertexBufferObject::NEAR_PLANE_SHIFT_SCALE ||
    this->ShiftScaleMethod == vtkOpenGLVertexBufferObject::FOCAL_POINT_SHIFT_SCALE;
  if (this->Data.size() != 1 || isMoving || renderer->GetSelector() || actor->GetTexture())
  {
    return {};
  }
  vtkPolyData* surface = this->Data.begin()->first;
  const auto address = [](const void* object) { return reinterpret_cast<std::uintptr_t>(object); };
  return { address(surface), surface->GetMeshMTime(),
    address(surface->GetPointData()->GetNormals()), address(surface->GetPointData()->GetTangents()),
    address(surface->GetPointData()->GetAttribute(vtkDataSetAttributes::EDGEFLAG)),
    address(surface->GetCellData()->GetNormals()), actor->GetProperty()->GetMTime(),
    static_cast<std::uintptr_t>(this->ShiftScaleMethod) };
}

bool vtkSurfaceFieldHelper::MapToCoordinates()
{
  // The superclass takes them for up to date where the mapper itself has not changed.
  for (vtkObjectBase* array : { static_cast<vtkObjectBase*>(this->ColorCoordinates),
         static_cast<vtkObjectBase*>(this->Colors) })
  {
    if (array)
    {
      array->UnRegister(this);
    }
  }
  this->ColorCoordinates = nullptr;
  this->Colors = nullptr;
  this->MapScalars(this->Data.begin()->first, 1.0);
  if (!this->ColorCoordinates || !this->ColorTextureMap || !this->InterpolateScalarsBeforeMapping)
  {
    return false;
  }
  this->InternalColorTexture->SetInputData(this->ColorTextureMap);
  return true;
}

void vtkSurfaceFieldHelper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Description.clear();
  this->Superclass::ReleaseGraphicsResources(window);
}
