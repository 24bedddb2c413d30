// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FastMarchingSolver_h
#define geodesic_FastMarchingSolver_h

#include "base/Platform.h"

#if !GEODESIC_HAS_LANES
#include "march/ReferenceSolver.h"

#include <utility>

namespace geodesic
{
/** Without vector extensions the reference takes the place of the batched solver. */
class FastMarchingSolver final : public ReferenceSolver
{
public:
  /** The number of numbers treated at once is 1, whatever @p mayUseQuads allows. */
  explicit FastMarchingSolver(
    std::shared_ptr<const TriangleMesh> mesh, [[maybe_unused]] bool mayUseQuads = true)
    : ReferenceSolver(std::move(mesh))
  {
  }
};

}

#else
#include "march/FrontQueues.h"
#include "march/MarchingSolver.h"
#include "march/SecondaryValues.h"
#include "march/VertexState.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace geodesic
{

class MarchControl;

/**
 * Geodesic distance by fast marching: a front that spreads over the triangles, each vertex updated
 * over the edges opposite to it, by pointSourceUpdate round points and straightFrontUpdate beside
 * curves and regions.
 * R. Kimmel, J. Sethian, Computing geodesic paths on manifolds, PNAS 95 (1998).
 *
 * The march is label correcting: vertices are taken in rough order of distance and again whenever
 * their value falls. As the updates are monotone the result is their greatest fixed point, the same
 * (to 1e-10) for any order, numbering or partition. Exact on developable surfaces at constant cost,
 * first order accurate in the edge length elsewhere. With several labels each keeps values of its
 * own near the border between them (SecondaryValues), so that no update mixes two sources.
 *
 * Time O(n) on meshes whose edges do not vary wildly, memory 24 bytes a vertex beside the mesh for
 * one label, with several 16 more and 20 for each value beyond a vertex's inPlace.
 */
class FastMarchingSolver : public MarchingSolver
{
public:
  /** @param mayUseQuads whether four numbers are treated at once where the processor can (see
   * Lanes.h); the field is the same either way, to the bit */
  explicit FastMarchingSolver(std::shared_ptr<const TriangleMesh> mesh, bool mayUseQuads = true);
  /** The same with bounds of the mesh that are there already. */
  FastMarchingSolver(std::shared_ptr<const TriangleMesh> mesh,
    std::shared_ptr<const UpdateBounds> bounds, bool mayUseQuads = true);

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
  template <class Cost, class Values>
  bool run(const Cost& cost, Values& values, std::span<const StartValue> starts,
    const Request& request, StopLimit& limit, MarchControl& control, DistanceField& field);

  bool MayUseQuads;
  FrontQueues Queues;
  std::vector<VertexState> States;
  SecondaryValues Labels;
};

}

#endif

#endif
