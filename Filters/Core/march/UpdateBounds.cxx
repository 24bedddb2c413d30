// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/UpdateBounds.h"

#include "base/Mean.h"
#include "march/TriangleMeasure.h"
#include "solve/Partition.h"

#include <algorithm>

namespace geodesic
{

const RingMeasurer& updateMeasurer()
{
  static const TriangleMeasurer measurer;
  return measurer;
}

UpdateBounds::UpdateBounds(const TriangleMesh& mesh, const ThreadTeam& team)
  : Numbers(ringNumbers(mesh, updateMeasurer(), team))
  , Slacks(this->Numbers->ofEntries.data())
  , MeanMargin(meanOf(this->margins()))
{
}

AgreedMargins::AgreedMargins(const UpdateBounds& bounds, std::size_t labels, Partition& partition)
  : Own(bounds.margins())
{
  if (!partition.isDivided() || labels == 1)
  {
    return;
  }
  this->Agreed.assign(this->Own.begin(), this->Own.end());
  std::vector<StartValue> own;
  for (const Index vertex : partition.sharedVertices())
  {
    own.push_back({ vertex, 0, this->Own[vertex], false });
  }
  for (const StartValue& other : partition.exchange(own))
  {
    float& margin = this->Agreed[other.vertex];
    margin = std::max(margin, static_cast<float>(other.value));
  }
}

}
