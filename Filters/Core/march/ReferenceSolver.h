// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ReferenceSolver_h
#define geodesic_ReferenceSolver_h

#include "march/MarchingSolver.h"

#include <memory>

namespace geodesic
{

/**
 * Geodesic distance by fast marching, as the papers have it: take the vertex with the least value
 * from the queue, update its neighbours over the triangles round it by pointSourceUpdate or
 * straightFrontUpdate. R. Kimmel, J. Sethian, Computing geodesic paths on manifolds, PNAS 95
 * (1998).
 *
 * It gives the same field as FastMarchingSolver, which is this algorithm made fast, at three to six
 * times the time. Tests hold that solver to this one, and where a compiler has no vector extensions
 * this one takes its place.
 *
 * Memory 4 bytes a vertex and 32 for each value of a label at a vertex, beside the bounds.
 */
class ReferenceSolver : public MarchingSolver
{
public:
  explicit ReferenceSolver(std::shared_ptr<const TriangleMesh> mesh);
  ReferenceSolver(
    std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const UpdateBounds> bounds);

protected:
  bool marchFrom(std::span<const StartValue> starts, const UnitCost& cost, const Request& request,
    StopLimit& limit, DistanceField& field) override;
  bool marchFrom(std::span<const StartValue> starts, const VertexCost& cost, const Request& request,
    StopLimit& limit, DistanceField& field) override;
  std::unique_ptr<FrontSolver> another() const override;

private:
  template <class Cost>
  bool marchAtCost(std::span<const StartValue> starts, const Cost& cost, const Request& request,
    StopLimit& limit, DistanceField& field);
};

}

#endif
