// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NeighbourUpdateOnOne_h
#define geodesic_NeighbourUpdateOnOne_h

#include "march/LabelValues.h"
#include "march/NeighbourUpdate.h"
#include "march/OneLabelValues.h"
#include "march/TriangleCost.h"

namespace geodesic
{

// The updates on one thread, which take long to compile, for all that use them.

extern template class NeighbourUpdate<UnitCost, OneLabelValues<UnitCost>>;
extern template class NeighbourUpdate<UnitCost, LabelValues<UnitCost>>;
extern template class NeighbourUpdate<VertexCost, OneLabelValues<VertexCost>>;
extern template class NeighbourUpdate<VertexCost, LabelValues<VertexCost>>;

}

#endif
