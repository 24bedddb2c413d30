// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceLinesRepresentation.h"

#include "vtkSurfaceLinesActor.h"

#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"

vtkStandardNewMacro(vtkSurfaceLinesRepresentation);

vtkSurfaceLinesRepresentation::vtkSurfaceLinesRepresentation()
{
  // The superclass has made an actor of its own, and has no other way to have another.
  vtkSurfaceLinesActor* actor = vtkSurfaceLinesActor::New();
  actor->SetMapper(this->Mapper);
  actor->SetLODMapper(this->LODMapper);
  actor->SetProperty(this->Property);
  actor->SetPropertyKeys(this->Actor->GetPropertyKeys());
  this->Lines = actor;
  this->Actor->Delete();
  this->Actor = actor;
  this->SetSuppressLOD(true);
  this->SetRenderLinesAsTubes(false);
}

void vtkSurfaceLinesRepresentation::SetRenderLinesAsTubes(bool isOn)
{
  // OpenGL's own lines have their width along an axis of the screen: 4 pixels are 2.8 on a slant.
  // VTK gives tubes their width across the line. Without light they are plain.
  this->Property->SetRenderLinesAsTubes(true);
  this->Lines->SetLit(isOn);
}
