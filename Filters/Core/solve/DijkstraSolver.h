// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DijkstraSolver_h
#define geodesic_DijkstraSolver_h

#include "solve/EdgeFront.h"
#include "solve/FrontSolver.h"
#include "solve/StartValue.h"

#include <memory>
#include <vector>

namespace geodesic
{

/**
 * Computes the shortest distance along the edges of the mesh: an upper bound of the geodesic
 * distance that does not converge to it under refinement. From a seed inside a face or on an edge,
 * a straight line leads to the corners of its faces. E. W. Dijkstra, A note on two problems in
 * connexion with graphs, Numer. Math. 1 (1959).
 *
 * Time O(n log n), memory 16 bytes for each vertex of the front.
 */
class DijkstraSolver : public FrontSolver
{
public:
  explicit DijkstraSolver(std::shared_ptr<const TriangleMesh> mesh);

  bool crossesFaces() const override { return false; }

protected:
  bool march(const Request& request, StopLimit& limit, DistanceField& field) override;
  /** Nothing that is kept depends on positions. */
  bool renewFor(const TriangleMesh& /*mesh*/) override { return true; }

private:
  /** Returns the start values, which leave out the seeds' own values. Collective. */
  std::vector<StartValue> starts(const Request& request) const;

  std::vector<EdgeTrial> Heap;
};

}

#endif
