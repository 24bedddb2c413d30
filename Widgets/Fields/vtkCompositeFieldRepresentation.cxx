// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCompositeFieldRepresentation.h"

#include "vtkObjectFactory.h"
#include "vtkSurfaceFieldRepresentation.h"

#include <string>

vtkStandardNewMacro(vtkCompositeFieldRepresentation);

void vtkCompositeFieldRepresentation::AddRepresentation(
  const char* key, vtkPVDataRepresentation* representation)
{
  const std::string name = key;
  const bool isSurface = name == "Surface" || name == "Surface With Edges";
  if (!isSurface || vtkSurfaceFieldRepresentation::SafeDownCast(representation))
  {
    this->Superclass::AddRepresentation(key, representation);
  }
}
