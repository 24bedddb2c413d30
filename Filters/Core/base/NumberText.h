// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NumberText_h
#define geodesic_NumberText_h

#include <sstream>
#include <string>

namespace geodesic
{

/** A number for a message, in six digits wherever the point is: std::to_string(1e-9) is 0. */
inline std::string textOf(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

}

#endif
