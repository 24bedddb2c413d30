// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/EdgeLowering.h"

#include "solve/EdgeFront.h"
#include "solve/Partition.h"

#include <vector>

namespace geodesic
{

bool lowerAlongEdges(const TriangleMesh& mesh, const ClosedTriangles& closed,
  const SolveOptions& options, std::span<const Index> from, Partition& partition, StopLimit& limit,
  DistanceField& field)
{
  std::vector<EdgeTrial> heap;
  EdgeFront front(mesh, closed, options, limit, field, heap, EdgeFront::Counts::ClearlyLower);
  for (const Index vertex : from)
  {
    front.proposeToNeighbours(vertex);
  }
  const bool finished = partition.march(front, limit);
  field.noteRaisedGain(front.raisedGain());
  return finished;
}

}
