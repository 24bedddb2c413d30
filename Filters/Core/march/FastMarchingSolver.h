// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FastMarchingSolver_h
#define geodesic_FastMarchingSolver_h

#include "base/Platform.h"

#if !GEODESIC_HAS_LANES
#include "march/ReferenceSolver.h"

namespace geodesic
{
/** With a compiler without vector extensions, ReferenceSolver stands in for the batched solver. */
class FastMarchingSolver final : public ReferenceSolver
{
public:
  /** @param mayUseQuads has no effect: numbers are treated one at a time */
  explicit FastMarchingSolver(
    const std::shared_ptr<const TriangleMesh>& mesh, [[maybe_unused]] bool mayUseQuads = true)
    : ReferenceSolver(mesh)
  {
  }
};

}

#else
#include "march/FrontQueues.h"
#include "march/MarchingSolver.h"
#include "march/SecondaryValues.h"
#include "march/SourceFront.h"
#include "march/VertexState.h"
#include "threads/SharedMarch.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace geodesic
{

class MarchControl;

/**
 * Geodesic distance by fast marching, the fast tier. It computes the same field as ReferenceSolver;
 * read ReferenceSolver.cxx first, as it has the algorithm in its plain form.
 * R. Kimmel, J. Sethian, Computing geodesic paths on manifolds, PNAS 95 (1998).
 *
 * Both tiers take a vertex from the queue and update its neighbours over the triangles round it, by
 * the formulas of EikonalUpdate.h for a round front (of a point) or a straight one (beside a curve
 * or region). This one takes a batch of vertices at a time, and computes several updates at once:
 *
 *  - BatchedMarch.h: the loop
 *  - NeighbourUpdate.h: the update of all neighbours of a batch of vertices, step by step
 *  - UpdateBatch.h: the data of a batch, one row of slots for the ring of each vertex
 *  - CandidateScan.h, with UpdateBounds.h: which neighbours can gain at all, by cheap bounds
 *  - CandidateLists.h: lists of the updates to compute
 *  - OneLabelValues.h, or LabelValues.h with SecondaryValues.h: where values are kept
 *  - FrontQueues.h: the queues of a march
 *  - MarchOnThreads.cxx, with SharedValues.h and SharedMarch.h: a march of one label on threads
 *
 * The march is label correcting: vertices are taken in rough order of distance and again whenever
 * their value falls. As the updates are monotone the result is their greatest fixed point, the same
 * (to 1e-10) for any order, numbering or partition. It is exact on developable surfaces at constant
 * cost, and first order accurate in the edge length elsewhere. With several labels each keeps
 * values of its own near the border between them (SecondaryValues), so that no update mixes two
 * sources.
 *
 * Time O(n) on meshes whose edges do not vary wildly. Memory besides the mesh and its UpdateBounds:
 * 24 bytes a vertex for one label; for several labels 16 bytes a vertex more, and 20 for each
 * secondary value beyond the first of a vertex.
 */
class FastMarchingSolver : public MarchingSolver
{
public:
  /**
   * @param mayUseQuads whether four numbers are treated at once if the processor can (see Lanes.h);
   *                    the field is the same either way, to the bit
   */
  explicit FastMarchingSolver(
    const std::shared_ptr<const TriangleMesh>& mesh, bool mayUseQuads = true);
  /** @param bounds bounds of this mesh; the other constructor computes them */
  FastMarchingSolver(std::shared_ptr<const TriangleMesh> mesh,
    std::shared_ptr<const UpdateBounds> bounds, bool mayUseQuads = true);

  /** The work of the last march on several threads; all 0 if there was none. */
  const ThreadWork& threadWork() const { return this->WorkOfThreads; }

protected:
  bool marchFrom(std::span<const StartValue> starts, const UnitCost& cost, const Request& request,
    LabelBounds* bounds, StopLimit& limit, DistanceField& field) override;
  bool marchFrom(std::span<const StartValue> starts, const VertexCost& cost, const Request& request,
    LabelBounds* bounds, StopLimit& limit, DistanceField& field) override;
  std::unique_ptr<FrontSolver> another() const override;

private:
  template <class Cost>
  bool marchAtCost(std::span<const StartValue> starts, const Cost& cost, const Request& request,
    LabelBounds* bounds, StopLimit& limit, DistanceField& field);
  template <class Cost, class Values>
  bool run(const Cost& cost, Values& values, std::span<const StartValue> starts,
    const Request& request, StopLimit& limit, MarchControl& control, DistanceField& field);

  /** Empties queues for a march. @param groups  see FrontQueues::start() */
  template <class Cost>
  void startQueues(FrontQueues& queues, const Cost& cost, std::size_t groups) const;

  /** On how many threads a march without bounds of labels goes on. */
  std::size_t threadsFor(
    std::span<const StartValue> starts, const Request& request, const StopLimit& limit) const;
  /** A march of one label that goes on on several threads once its front is long, see SharedMarch.
   * @return false when cancelled; nothing, with the field reset, where the front does not settle
   *         soon: what reaches another thread a round later may go against the order of the march,
   *         and one thread gets on better */
  template <class Cost>
  std::optional<bool> marchOnThreads(std::size_t threads, std::span<const StartValue> starts,
    const Cost& cost, const Request& request, StopLimit& limit, DistanceField& field);
  /** Its second part. @param meanwhile  see callTogether() */
  template <class Meanwhile, class Cost>
  std::optional<bool> goOnOnThreads(SharedMarch& march, const Meanwhile& meanwhile,
    const Cost& cost, const Request& request, DistanceField& field);

  bool MayUseQuads;
  FrontQueues Queues;
  std::vector<VertexState> States;
  SecondaryValues Labels;
  std::vector<SourceFront> Fronts;
  /** What a thread keeps from march to march. It changes with each step, so it is on cache lines of
   * its own: two threads that write to one line wait for each other. */
  struct alignas(128) OfThread
  {
    FrontQueues queues;
    std::vector<Index> reached;
  };
  std::vector<OfThread> Threads;
  ThreadWork WorkOfThreads;
  /** Whether a front did not settle on threads, without and with a cost: then later ones of this
   * surface do not try. */
  std::array<bool, 2> IsBetterAlone{};
};

}

#endif

#endif
