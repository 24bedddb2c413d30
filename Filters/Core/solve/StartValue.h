// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_StartValue_h
#define geodesic_StartValue_h

#include "base/Index.h"

namespace geodesic
{

/**
 * The value that a vertex has for a label before the march: its distance from the label's origin or
 * line. The label's own value (Label::value) is not included.
 */
struct StartValue
{
  Index vertex;
  /** Index of the label in SeedFront::labels. */
  Index label;
  /** In the mesh's length unit times the cost. */
  double value;
  /** Whether the march must not change this value by a crossing. At cost 1 a way along edges lowers
   * it all the same: from a line, or from several seeds together, that can be the shorter one where
   * triangles are thin or folded. */
  bool isFinal;
  /** Whether no update from the vertex can count, so that it need not be queued. */
  bool isIdle = false;
};

}

#endif
