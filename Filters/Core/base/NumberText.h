// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NumberText_h
#define geodesic_NumberText_h

#include <sstream>
#include <string>

namespace geodesic
{

/**
 * Returns a number as text for a message, with six significant digits. std::to_string has six
 * decimals instead and makes 0.000000 of 1e-9.
 */
inline std::string textOf(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

}

#endif
