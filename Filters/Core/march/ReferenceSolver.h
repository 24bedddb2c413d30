// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ReferenceSolver_h
#define geodesic_ReferenceSolver_h

#include "march/MarchingSolver.h"

#include <memory>

namespace geodesic
{

/**
 * Geodesic distance by fast marching, as the papers have it, the plain tier: take a vertex with one
 * of the least values from the queue, and update its neighbours over the triangles round it by
 * pointSourceUpdate() or straightFrontUpdate() of EikonalUpdate.h. The loop is
 * ReferenceFront::advance() in ReferenceSolver.cxx.
 * R. Kimmel, J. Sethian, Computing geodesic paths on manifolds, PNAS 95 (1998).
 *
 * FastMarchingSolver is the same algorithm made fast: it computes the same field in a third to a
 * sixth of the time. Tests compare it with this solver. This one also takes its place if the
 * compiler has no vector extensions.
 *
 * Memory besides the mesh and its bounds: 4 bytes a vertex, and 24 for each value of a label at a
 * vertex.
 */
class ReferenceSolver : public MarchingSolver
{
public:
  explicit ReferenceSolver(const std::shared_ptr<const TriangleMesh>& mesh);
  /** @param bounds bounds of this mesh; the other constructor computes them */
  ReferenceSolver(
    std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const UpdateBounds> bounds);

protected:
  bool marchFrom(std::span<const StartValue> starts, const UnitCost& cost, const Request& request,
    LabelBounds* bounds, StopLimit& limit, DistanceField& field) override;
  bool marchFrom(std::span<const StartValue> starts, const VertexCost& cost, const Request& request,
    LabelBounds* bounds, StopLimit& limit, DistanceField& field) override;
  std::unique_ptr<MarchingSolver> another() const override;

private:
  template <class Cost>
  bool marchAtCost(std::span<const StartValue> starts, const Cost& cost, const Request& request,
    LabelBounds* bounds, StopLimit& limit, DistanceField& field);
};

}

#endif
