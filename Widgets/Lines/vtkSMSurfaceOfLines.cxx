// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMSurfaceOfLines.h"

#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <string>

vtkStandardNewMacro(vtkSMSurfaceOfLines);

void vtkSMSurfaceOfLines::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType vtkNotUsed(initializationTimeStamp))
{
  vtkSMPropertyHelper input(proxy, "Input");
  vtkSMPropertyHelper lines(proxy, xml->GetAttributeOrEmpty("lines"));
  vtkSMProxy* given = input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr;
  const bool hasLines = lines.GetNumberOfElements() > 0 && lines.GetAsProxy();
  if (!given || hasLines || std::string(given->GetXMLName()) != xml->GetAttributeOrEmpty("maker"))
  {
    return;
  }
  vtkSMPropertyHelper surface(given, "Input");
  lines.Set(given, input.GetOutputPort());
  input.Set(surface.GetAsProxy(), surface.GetOutputPort());
  proxy->UpdateVTKObjects();
}
