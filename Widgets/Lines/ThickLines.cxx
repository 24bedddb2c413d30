// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThickLines.h"

#include "pqApplicationCore.h"
#include "pqRepresentation.h"
#include "pqServerManagerModel.h"

#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

ThickLines::ThickLines(QObject* parent)
  : QObject(parent)
{
}

void ThickLines::startup()
{
  QObject::connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::representationAdded, this, &ThickLines::thicken);
}

void ThickLines::shutdown()
{
  QObject::disconnect(
    pqApplicationCore::instance()->getServerManagerModel(), nullptr, this, nullptr);
}

void ThickLines::thicken(pqRepresentation* representation)
{
  // The representation's getInput() is not set yet, so the source is read from the proxy.
  vtkSMProxy* proxy = representation->getProxy();
  vtkSMProxy* source = vtkSMPropertyHelper(proxy, "Input", true).GetAsProxy();
  vtkPVXMLElement* hints = source ? source->GetHints() : nullptr;
  vtkPVXMLElement* hint = hints ? hints->FindNestedElementByName("ThickLines") : nullptr;
  double width = 0.0;
  if (!hint || !hint->GetScalarAttribute("width", &width) ||
    pqApplicationCore::instance()->isLoadingState())
  {
    return;
  }
  vtkSMProperty* lineWidth = proxy->GetProperty("LineWidth");
  vtkSMProperty* asTubes = proxy->GetProperty("RenderLinesAsTubes");
  if (lineWidth && asTubes && lineWidth->IsValueDefault() && asTubes->IsValueDefault())
  {
    vtkSMPropertyHelper(lineWidth).Set(width);
    vtkSMPropertyHelper(asTubes).Set(1);
    proxy->UpdateVTKObjects();
  }
}
