// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyDataGeodesicDistance.h"

#include <algorithm>

vtkCxxSetSmartPointerMacro(vtkPolyDataGeodesicDistance, Seeds, vtkIdList);

//------------------------------------------------------------------------------
void vtkPolyDataGeodesicDistance::SetFieldDataName(const char* name)
{
  const std::string newName = name ? name : "";
  if (this->FieldDataName != newName)
  {
    this->FieldDataName = newName;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkPolyDataGeodesicDistance::GetFieldDataName()
{
  return this->FieldDataName.empty() ? nullptr : this->FieldDataName.c_str();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPolyDataGeodesicDistance::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->SeedsWatch.TimeOf(this->Seeds));
}

//------------------------------------------------------------------------------
void vtkPolyDataGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Seeds: " << this->Seeds << "\n";
  os << indent << "FieldDataName: " << this->FieldDataName << "\n";
}
