// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Platform.h"

#if GEODESIC_HAS_LANES

#include "march/NeighbourUpdateOnOne.h"

namespace geodesic
{

template class NeighbourUpdate<UnitCost, OneLabelValues<UnitCost>>;
template class NeighbourUpdate<UnitCost, LabelValues<UnitCost>>;
template class NeighbourUpdate<VertexCost, OneLabelValues<VertexCost>>;
template class NeighbourUpdate<VertexCost, LabelValues<VertexCost>>;

}

#endif
