// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sources/SourceStore.h"

#include "base/Interruption.h"
#include "mesh/TriangleMesh.h"

#include <cmath>
#include <numeric>

namespace geodesic
{

SourceStore::SourceStore(const TriangleMesh& mesh)
  : Run(1)
{
  this->Sides.reserve(std::size_t{ 3 } * mesh.numberOfTriangles());
  double sum = 0.0;
  for (const Triangle& corners : mesh.triangles())
  {
    Interruption::checkAt(this->Sides.size() / 3);
    double shortest = std::numeric_limits<double>::infinity();
    for (Index k = 0; k < 3; ++k)
    {
      const Index first = corners[(k + 1) % 3];
      const Index second = corners[(k + 2) % 3];
      this->Sides.push_back(
        { SideFrame(mesh.position(first), mesh.position(second), mesh.position(corners[k])), first,
          second, corners[k], {}, {}, 0, 0 });
      shortest = std::min(shortest, this->Sides.back().frame.length);
    }
    sum += shortest;
  }
  // The pages are used when they are needed. To move all sources to more room takes long.
  constexpr double mostOfSide = 1.5;
  this->Sources.reserve(static_cast<std::size_t>(mostOfSide * this->Sides.size()));
  this->MeanShortestSide = this->Sides.empty() ? 0.0 : sum / mesh.numberOfTriangles();
}

void SourceStore::clear()
{
  this->Sources.clear();
  this->Free.clear();
  ++this->Run;
  if (this->Run == 0)
  {
    for (Side& side : this->Sides)
    {
      side.run = 0;
    }
    this->Run = 1;
  }
}

bool SourceStore::isBetterByLittle(const Side& at, const SeenSource& seen, std::size_t corner) const
{
  const std::array<double, Corners> kept = this->Sources[at.sources[corner]].distancesAt(at.frame);
  if (std::abs(seen.distances[corner] - kept[corner]) > Rounding * kept[corner])
  {
    return seen.distances[corner] < kept[corner];
  }
  const auto sum = [](const std::array<double, Corners>& of)
  { return std::accumulate(of.begin(), of.end(), 0.0); };
  return sum(seen.distances) < sum(kept) * (1.0 - Rounding);
}

/** Whether a kept source may stand for one that is nearer to a corner by little. */
bool SourceStore::standsFor(
  const VirtualSource& kept, const SideFrame& frame, const SeenSource& seen, std::size_t corner)
{
  const double distance = kept.distancesAt(frame)[corner];
  return kept.label == seen.source.label &&
    std::abs(kept.offset - seen.source.offset) <= SameBend * distance &&
    lengthOf(kept.x - seen.source.x, kept.y - seen.source.y) <= SamePlace * frame.length &&
    kept.first <= seen.source.first && kept.last >= seen.source.last &&
    seen.distances[corner] >= distance * (1.0 - LeastGain);
}

}
