// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DijkstraSolver_h
#define geodesic_DijkstraSolver_h

#include "solve/FrontSolver.h"
#include "solve/StartValue.h"

#include <memory>
#include <vector>

namespace geodesic
{

/** A vertex on its way through the heap. */
struct EdgeTrial
{
  double distance;
  Index vertex;
  Index seed;
};

/**
 * Shortest distance along the edges of the mesh, an upper bound of the geodesic distance that does
 * not become exact under refinement. A seed inside a face or on an edge reaches that face's corners
 * in a straight line. E. W. Dijkstra, A note on two problems in connexion with graphs, Numer. Math.
 * 1 (1959).
 *
 * Time O(n log n), memory 16 bytes for each vertex of the front.
 */
class DijkstraSolver : public FrontSolver
{
public:
  explicit DijkstraSolver(std::shared_ptr<const TriangleMesh> mesh);

protected:
  bool march(const Request& request, StopLimit& limit, DistanceField& field) override;

private:
  /** The first values, without those of the seeds themselves. */
  std::vector<StartValue> starts(const Request& request) const;

  std::vector<EdgeTrial> Heap;
};

}

#endif
