// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMSurfaceLinesDefaults.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSettings.h"

#include <string>

vtkStandardNewMacro(vtkSMSurfaceLinesDefaults);

namespace
{

/** Whether neither the user's settings nor somebody since then decided about a property. */
bool isOpen(vtkSMProxy* proxy, const char* name, vtkMTimeType since)
{
  const std::string setting =
    std::string(".") + proxy->GetXMLGroup() + "." + proxy->GetXMLName() + "." + name;
  vtkSMProperty* property = proxy->GetProperty(name);
  return property && property->GetMTime() <= since &&
    !vtkSMSettings::GetInstance()->HasSetting(setting.c_str());
}

}

void vtkSMSurfaceLinesDefaults::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp)
{
  double width = 0.0;
  if (xml->GetScalarAttribute("width", &width) &&
    isOpen(proxy, "LineWidth", initializationTimeStamp))
  {
    vtkSMPropertyHelper(proxy, "LineWidth").Set(width);
  }
  double color[3];
  if (xml->GetVectorAttribute("color", 3, color) == 3)
  {
    for (const char* name : { "AmbientColor", "DiffuseColor" })
    {
      if (isOpen(proxy, name, initializationTimeStamp))
      {
        vtkSMPropertyHelper(proxy, name).Set(color, 3);
      }
    }
    if (isOpen(proxy, "ColorArrayName", initializationTimeStamp))
    {
      // Modified even where it is empty already, so that it is not set from the data's arrays.
      vtkSMPropertyHelper(proxy, "ColorArrayName")
        .SetInputArrayToProcess(vtkDataObject::FIELD_ASSOCIATION_POINTS, "");
      proxy->GetProperty("ColorArrayName")->Modified();
    }
  }
  proxy->UpdateVTKObjects();
}
