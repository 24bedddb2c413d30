// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OtherSources.h"

#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "vtkCommand.h"
#include "vtkPVDataInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyProperty.h"
#include "vtkSMStringVectorProperty.h"

#include <QCoreApplication>

namespace seeds
{
namespace
{

QString inputText(vtkSMProxy* proxy, unsigned int port, const QString& label)
{
  auto* source =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(proxy);
  if (!source)
  {
    return label;
  }
  const auto count =
    source->getOutputPort(static_cast<int>(port))->getDataInformation()->GetNumberOfPoints();
  return QCoreApplication::translate("OtherSources", "%1 points of %2 (%3)")
    .arg(count)
    .arg(source->getSMName(), label);
}

/** Empty if the property gives no points. */
QString textOf(vtkSMProperty* property)
{
  const QString label = property->GetXMLLabel();
  vtkSMPropertyHelper helper(property, true);
  helper.SetUseUnchecked(true);
  const unsigned int count = helper.GetNumberOfElements();
  if (vtkSMProxyProperty::SafeDownCast(property))
  {
    vtkSMProxy* proxy = count > 0 ? helper.GetAsProxy() : nullptr;
    return proxy ? inputText(proxy, helper.GetOutputPort(), label) : QString();
  }
  if (vtkSMStringVectorProperty::SafeDownCast(property))
  {
    // An array is chosen by five strings, of which the last is its name.
    const QString array = count == 5 ? helper.GetAsString(4) : "";
    return array.isEmpty() || array == "None" ? QString() : QString("%1 %2").arg(label, array);
  }
  return count > 0 ? QCoreApplication::translate("OtherSources", "%1 from %2").arg(count).arg(label)
                   : QString();
}

}

OtherSources::OtherSources(vtkSMProxy* filter, const QStringList& names)
  : Filter(filter)
  , Names(names)
{
  for (const QString& name : names)
  {
    if (vtkSMProperty* property = filter->GetProperty(qPrintable(name)))
    {
      for (const auto event :
        { vtkCommand::UncheckedPropertyModifiedEvent, vtkCommand::ModifiedEvent })
      {
        this->Observers.emplace_back(
          property, property->AddObserver(event, this, &OtherSources::propertyModified));
      }
    }
  }
}

OtherSources::~OtherSources()
{
  for (const auto& [property, observer] : this->Observers)
  {
    property->RemoveObserver(observer);
  }
}

QString OtherSources::text() const
{
  QStringList texts;
  for (const QString& name : this->Names)
  {
    vtkSMProperty* property = this->Filter->GetProperty(qPrintable(name));
    const QString text = property ? textOf(property) : QString();
    if (!text.isEmpty())
    {
      texts.append(text);
    }
  }
  return texts.join(", ");
}

}
