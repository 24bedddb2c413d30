// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CurveOrder_h
#define geodesic_CurveOrder_h

#include "base/Index.h"
#include "base/Vector3.h"

#include <vector>

namespace geodesic
{

/** The numbers of positions in the order of a Morton curve: what lies near one after the other is
 * near in memory then. Those whose box is too small or too large to be divided stay in their order.
 * Time O(n log n). */
std::vector<Index> orderAlongCurve(const std::vector<Vector3>& positions);

}

#endif
