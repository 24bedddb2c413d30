// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorTable.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace seeds
{
namespace
{

/** Fine enough for the border of bands to lie within a pixel of its place. */
constexpr int Entries = 8192;

}

ColorTable::ColorTable(vtkScalarsToColors* map)
  : IsLogarithmic(map->UsingLogScale() != 0)
{
  const double* range = map->GetRange();
  const auto placed = [this](double value)
  { return this->IsLogarithmic ? std::log10(value) : value; };
  this->Low = placed(range[0]);
  const double length = placed(range[1]) - this->Low;
  this->PerUnit = length > 0.0 ? Entries / length : 0.0;

  vtkNew<vtkDoubleArray> values;
  for (int i = 0; i < Entries; ++i)
  {
    const double place = this->Low + (i + 0.5) * length / Entries;
    values->InsertNextValue(this->IsLogarithmic ? std::pow(10.0, place) : place);
  }
  const double infinity = std::numeric_limits<double>::infinity();
  values->InsertNextValue(std::nextafter(range[0], -infinity));
  values->InsertNextValue(std::nextafter(range[1], infinity));
  values->InsertNextValue(std::numeric_limits<double>::quiet_NaN());
  const auto colors = vtkSmartPointer<vtkUnsignedCharArray>::Take(
    map->MapScalars(values, VTK_COLOR_MODE_MAP_SCALARS, 0, VTK_RGB));
  const auto colorOf = [&](vtkIdType i)
  {
    const unsigned char* rgb = colors->GetPointer(3 * i);
    return Color{ rgb[0], rgb[1], rgb[2] };
  };
  for (int i = 0; i < Entries; ++i)
  {
    this->Colors.push_back(colorOf(i));
  }
  this->Below = colorOf(Entries);
  this->Above = colorOf(Entries + 1);
  this->Nan = colorOf(Entries + 2);
}

}
