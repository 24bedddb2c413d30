// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_ColorTable_h
#define seeds_ColorTable_h

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

class vtkScalarsToColors;

namespace seeds
{

/** The colours of a colour map of numbers, for many look-ups. */
class ColorTable
{
public:
  using Color = std::array<unsigned char, 3>;

  explicit ColorTable(vtkScalarsToColors* map);

  const Color& at(double value) const
  {
    if (std::isnan(value))
    {
      return this->Nan;
    }
    const double place =
      ((this->IsLogarithmic ? std::log10(value) : value) - this->Low) * this->PerUnit;
    if (!(place >= 0.0))
    {
      return this->Below;
    }
    if (place > static_cast<double>(this->Colors.size()))
    {
      return this->Above;
    }
    const auto entry = static_cast<std::size_t>(place);
    return this->Colors[entry < this->Colors.size() ? entry : entry - 1];
  }

private:
  std::vector<Color> Colors;
  Color Below{};
  Color Above{};
  Color Nan{};
  bool IsLogarithmic = false;
  /** The lower end of the range, as a logarithm if the map has those, and entries a unit. */
  double Low = 0.0;
  double PerUnit = 0.0;
};

}

#endif
