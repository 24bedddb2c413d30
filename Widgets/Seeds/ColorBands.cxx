// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorBands.h"

#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMTransferFunctionProxy.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace seeds::bands
{
namespace
{

/** Rounding must not make a band more of a value that is a multiple of the spacing. */
constexpr double Rounding = 1e-6;

/** A legend has no room for the borders of more bands than this. */
constexpr int MostLabelled = 20;

int numberOfColors(vtkSMProxy* map)
{
  return vtkSMPropertyHelper(map, "NumberOfTableValues").GetAsInt();
}

}

double roundSpacing(double largest)
{
  const double least = largest / 10.0;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double digit : { 1.0, 2.0, 5.0 })
  {
    if (digit * power >= least * (1.0 - Rounding))
    {
      return digit * power;
    }
  }
  return 10.0 * power;
}

double numberOf(double spacing, double largest)
{
  return std::max(1.0, std::ceil(largest / spacing - Rounding));
}

double spacingOf(vtkSMProxy* map)
{
  double range[2];
  const int colors = numberOfColors(map);
  const bool isBanded = vtkSMPropertyHelper(map, "Discretize").GetAsInt() != 0 && colors <= Most &&
    vtkSMTransferFunctionProxy::GetRange(map, range) && range[0] == 0.0;
  return isBanded ? range[1] / colors : 0.0;
}

bool set(vtkSMProxy* map, double spacing, double largest)
{
  const int count = static_cast<int>(numberOf(spacing, largest));
  if (numberOfColors(map) == count && std::abs(spacingOf(map) - spacing) <= Rounding * spacing)
  {
    return false;
  }
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", map);
  vtkSMPropertyHelper(map, "Discretize").Set(1);
  vtkSMPropertyHelper(map, "NumberOfTableValues").Set(count);
  vtkSMTransferFunctionProxy::RescaleTransferFunction(map, 0.0, count * spacing);
  map->UpdateVTKObjects();
  return true;
}

void label(vtkSMProxy* legend, vtkSMProxy* map)
{
  const double spacing = spacingOf(map);
  const int count = spacing > 0.0 ? numberOfColors(map) : 0;
  const bool isLabelled = 0 < count && count <= MostLabelled;
  std::vector<double> borders;
  for (int i = 0; isLabelled && i <= count; ++i)
  {
    borders.push_back(i * spacing);
  }
  vtkSMPropertyHelper(legend, "CustomLabels")
    .Set(borders.data(), static_cast<unsigned int>(borders.size()));
  vtkSMPropertyHelper(legend, "UseCustomLabels").Set(isLabelled ? 1 : 0);
  vtkSMPropertyHelper(legend, "AddRangeLabels").Set(isLabelled ? 0 : 1);
  legend->UpdateVTKObjects();
}

void clear(vtkSMProxy* map)
{
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", map);
  map->GetProperty("NumberOfTableValues")->ResetToDefault();
  map->UpdateVTKObjects();
  vtkSMTransferFunctionProxy::RescaleTransferFunctionToDataRange(map);
}

}
