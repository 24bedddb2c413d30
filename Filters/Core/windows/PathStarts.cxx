// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/PathStarts.h"

#include "mesh/Carriers.h"
#include "mesh/EdgeTable.h"
#include "mesh/TriangleMesh.h"

namespace geodesic
{

void PathStarts::set(
  const TriangleMesh& mesh, const EdgeTable& edges, std::span<const SurfacePoint> points)
{
  this->Starts.clear();
  this->ByPoint.clear();
  this->ByTriangle.clear();
  for (const SurfacePoint& point : points)
  {
    const Carriers carriers = carriersOf(mesh, point);
    const Index number = static_cast<Index>(this->Starts.size());
    if (carriers.size() == 1 || !this->ByPoint.emplace(keyOf(point), number).second)
    {
      continue;
    }
    this->Starts.push_back({ mesh.positionOf(point), DistanceField::Unreached, NoIndex, {} });
    for (const Index triangle : mesh.trianglesWith({ carriers.begin(), carriers.end() }))
    {
      if (!edges.isRepeated(triangle))
      {
        this->ByTriangle[triangle].push_back(number);
      }
    }
  }
}

const PathStarts::Start* PathStarts::find(const SurfacePoint& point) const
{
  const auto found = this->ByPoint.find(keyOf(point));
  return found == this->ByPoint.end() ? nullptr : &this->Starts[found->second];
}

}
