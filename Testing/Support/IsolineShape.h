// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_IsolineShape_h
#define geodesic_testing_IsolineShape_h

#include "path/Isolines.h"

namespace geodesic::testing
{

inline bool isClosed(const Isoline& line)
{
  return line.points.front() == line.points.back();
}

}

#endif
