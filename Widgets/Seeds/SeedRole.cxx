// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedRole.h"

#include "vtkPVXMLElement.h"

namespace seeds
{

SeedRole SeedRole::fromHints(vtkPVXMLElement* hints)
{
  SeedRole role;
  vtkPVXMLElement* element = hints ? hints->FindNestedElementByName("SurfaceSeeds") : nullptr;
  if (!element)
  {
    return role;
  }
  if (const char* name = element->GetAttribute("role"))
  {
    role.name = name;
  }
  double rgb[3];
  if (element->GetVectorAttribute("color", 3, rgb) == 3)
  {
    role.color = QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
  }
  if (const char* others = element->GetAttribute("others"))
  {
    role.others = QString(others).split(' ', Qt::SkipEmptyParts);
  }
  role.distances = element->GetAttribute("distances");
  role.segments = element->GetAttribute("segments");
  int joined = 0;
  role.isJoined = element->GetScalarAttribute("joined", &joined) && joined != 0;
  return role;
}

}
