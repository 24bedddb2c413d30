// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VirtualSourceSolver_h
#define geodesic_VirtualSourceSolver_h

#include "solve/FrontSolver.h"
#include "sources/SourcePropagation.h"

#include <memory>

namespace geodesic
{

/**
 * Geodesic distance from points by virtual source propagation: the front carries the place of its
 * source, unfolded into the plane of each triangle that it enters. So it needs no assumption about
 * what lies between two vertices, as fast marching does: where two fronts meet within a long edge,
 * no source is seen that does not exist.
 * P. Trettner, D. Bommes, L. Kobbelt, Geodesic distance computation via virtual source propagation,
 * Computer Graphics Forum 40 (2021). The lit part of an edge is the window of J. Mitchell,
 * D. Mount, C. Papadimitriou, The discrete geodesic problem, SIAM J. Comput. 16 (1987).
 *
 *  - VirtualSource.h: a source at a side of a triangle, and how neighbouring ones become one
 *  - SourceStore.h: which sources are kept: for each triangle that a side leads into, the best one
 *    for each of its corners
 *  - SourcePropagation.h: the rounds. All that waits in a bucket is propagated at once from the
 *    values before the round; what it proposes is then taken over. So the field does not depend on
 *    the order of points and triangles, but for rounding.
 *
 * Every distance is the length of a line on the surface, but for what VirtualSource::fit() moves:
 * on surfaces flattened up to 1000 times values were too small by 1.5 % at most. They are never
 * more than the length of a path along edges. Planes, developable surfaces and the shadows of
 * barriers on them are exact.
 *
 * Only for points as seeds, at cost 1, and for a surface in one piece. Time O(n) on usual meshes
 * and on needles, for any number of seeds: four to eight items of the queue a vertex. Memory 670 to
 * 920 bytes a vertex.
 */
class VirtualSourceSolver final : public FrontSolver
{
public:
  explicit VirtualSourceSolver(std::shared_ptr<const TriangleMesh> mesh);

private:
  bool march(const Request& request, StopLimit& limit, DistanceField& field) override;

  SourceWorkspace Workspace;
};

}

#endif
