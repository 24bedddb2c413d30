// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ResultNumbers.h"

#include "PointText.h"

#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QCoreApplication>

#include <vector>

namespace seeds
{
namespace
{

QString tr(const char* text)
{
  return QCoreApplication::translate("ResultNumbers", text);
}

std::vector<double> valuesOf(vtkSMProxy* filter, vtkSMProperty* property)
{
  if (!property)
  {
    return {};
  }
  filter->UpdatePropertyInformation(property);
  return vtkSMPropertyHelper(property).GetArray<double>();
}

}

ResultNumbers ResultNumbers::of(vtkSMProxy* filter, vtkSMPropertyGroup* group)
{
  ResultNumbers result;
  if (vtkSMProperty* error = group->GetProperty("Error"))
  {
    filter->UpdatePropertyInformation(error);
    result.error = vtkSMPropertyHelper(error).GetAsString();
  }
  if (vtkSMProperty* notice = group->GetProperty("Notice"))
  {
    filter->UpdatePropertyInformation(notice);
    result.notice = vtkSMPropertyHelper(notice).GetAsString();
  }
  const std::vector<double> runTimes = valuesOf(filter, group->GetProperty("RunTime"));
  result.runTime = runTimes.empty() ? 0.0 : runTimes[0];
  vtkSMProperty* property = group->GetProperty("Result");
  const std::vector<double> values = valuesOf(filter, property);
  for (const double length : valuesOf(filter, group->GetProperty("Lengths")))
  {
    result.lengths.append(length);
  }
  // It is 0 before the first run, and after an error.
  if (values.empty() || (values[0] == 0.0 && result.lengths.isEmpty()))
  {
    return result;
  }
  result.value = values[0];
  const std::vector<double> middles = valuesOf(filter, group->GetProperty("Middles"));
  for (std::size_t i = 0; i + 2 < middles.size(); i += 3)
  {
    result.middles.append({ middles[i], middles[i + 1], middles[i + 2] });
  }
  result.summary = QString("%1: %2").arg(property->GetXMLLabel(), lengthText(values[0]));
  if (!result.lengths.isEmpty())
  {
    result.summary += result.lengths.size() == 1 ? tr(" in 1 segment")
                                                 : tr(" in %1 segments").arg(result.lengths.size());
  }
  return result;
}

QString ResultNumbers::text() const
{
  QString text = this->summary + "\n";
  for (int i = 0; i < this->lengths.size(); ++i)
  {
    text += QString("%1\t%2\n").arg(i).arg(exactText(this->lengths[i]));
  }
  return text;
}

QString lengthText(double length)
{
  return length < 0.0 ? tr("no path") : QString::number(length, 'g', 6);
}

}
