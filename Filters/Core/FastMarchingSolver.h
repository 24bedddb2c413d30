#ifndef geodesic_FastMarchingSolver_h
#define geodesic_FastMarchingSolver_h

#include "BucketQueue.h"
#include "DistanceSolver.h"
#include "LabelSets.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace geodesic
{

/**
 * Geodesic distance by fast marching: a front that spreads over the triangles, each vertex updated
 * over the edges opposite to it by pointSourceUpdate. R. Kimmel, J. Sethian, Computing geodesic
 * paths on manifolds, PNAS 95 (1998).
 *
 * The march is label correcting: vertices are taken in rough order of distance and again whenever
 * their value falls. As the update is monotone the result is the greatest fixed point of the
 * update, the same (to 1e-10) for any order, numbering or partition. Exact on developable surfaces,
 * first order accurate in the edge length elsewhere. With several seeds each keeps values of its
 * own near the border between them (LabelSets), so that no update mixes two sources.
 *
 * Time O(n) on meshes whose edges do not vary wildly, memory 13 bytes a vertex beside the mesh for
 * one seed, 24 bytes more for each value kept with several.
 */
class FastMarchingSolver : public DistanceSolver
{
public:
  explicit FastMarchingSolver(std::shared_ptr<const TriangleMesh> mesh);

protected:
  bool march(const Request& request, StopLimit& limit, DistanceField& field) override;

private:
  bool marchOneSeed(const Request& request, StopLimit& limit, DistanceField& field);
  bool marchManySeeds(const Request& request, StopLimit& limit, DistanceField& field);

  BucketQueue Queue;
  std::vector<std::uint8_t> State;
  LabelSets Labels;
};

}

#endif
