// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_StartValue_h
#define geodesic_StartValue_h

#include "base/Index.h"

namespace geodesic
{

/** A vertex's first value, for a label, without the label's own. */
struct StartValue
{
  Index vertex;
  Index label;
  double value;
  /** Never to be updated for this label. */
  bool isFinal;
};

}

#endif
