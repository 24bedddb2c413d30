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
class FastMarchingSolver : public ReferenceSolver
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
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace geodesic
{

class MarchControl;
template <class Cost>
struct MarchContext;

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
 *  - NarrowUpdate.h: the update of a batch of a vertex or two, without these steps
 *  - OneLabelValues.h, or LabelValues.h with SecondaryValues.h: where values are kept
 *  - FrontQueues.h: the queues of a march
 *  - MarchOnThreads.cxx, with SharedMarch.h, and SharedValues.h or SharedLabelValues.h for values:
 *    a march on several threads
 *
 * The march is label correcting: vertices are taken in rough order of distance and again whenever
 * their value falls. As the updates are monotone the result is their greatest fixed point, the same
 * (to 1e-10) for any order, numbering or partition. It is exact on developable surfaces at constant
 * cost, and first order accurate in the edge length elsewhere. With several labels each keeps
 * values of its own near the border between them (SecondaryValues), so that no update mixes two
 * sources.
 *
 * Time O(n) on meshes whose edges do not vary wildly. Memory besides the mesh and its UpdateBounds:
 * 24 bytes a vertex for one label; for several labels 16 bytes a vertex more, and 21 for each
 * secondary value beyond the first of a vertex, on threads 24 to 48. Where labels are within
 * LineBounds that had to be raised, 30 bytes a vertex more.
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
  std::unique_ptr<MarchingSolver> another() const override;

private:
  template <class Cost>
  bool marchAtCost(std::span<const StartValue> starts, const Cost& cost, const Request& request,
    LabelBounds* bounds, StopLimit& limit, DistanceField& field);
  template <class Cost, class Values>
  bool run(const Cost& cost, Values& values, std::span<const StartValue> starts,
    const Request& request, StopLimit& limit, MarchControl& control, DistanceField& field);

  /**
   * The number of groups of fronts, see FrontQueues. A group gets about as many vertices as it
   * takes in a turn, so that its part of the mesh stays in the processor's caches; smaller groups
   * would do more work for nothing where they meet, unless fronts are dense and soon meet anyway.
   * With targets there is one group: all fronts stop as soon as the targets are reached, so none
   * may go ahead of the others.
   * @param bounds  those of dense labels; null if there are none
   */
  std::size_t numberOfGroups(const Request& request, const LabelBounds* bounds) const;
  /** Whether the fronts of a march are of one label, and start all over the surface, so that groups
   * are to be those of vertices. */
  bool isDense(std::span<const StartValue> starts, const Request& request) const;
  /** Empties queues for a march. @param groups  see FrontQueues::start() @param partOfWidth  the
   * width of buckets, in the usual one */
  template <class Cost>
  void startQueues(
    FrontQueues& queues, const Cost& cost, std::size_t groups, double partOfWidth = 1.0) const;
  /** The same with the groups that suit the march. @param bounds  as above */
  template <class Cost>
  void startQueues(FrontQueues& queues, const Cost& cost, std::span<const StartValue> starts,
    const Request& request, const LabelBounds* bounds) const;

  /** On how many threads a march in the order of buckets goes on. */
  std::size_t threadsFor(
    std::span<const StartValue> starts, const Request& request, const StopLimit& limit);
  /** A march that goes on on several threads once its front is long, see SharedMarch.
   * @return false when cancelled; nothing, with the field reset, where the front does not settle
   *         soon: what reaches another thread a round later may go against the order of the march,
   *         and one thread gets on better */
  template <class Cost>
  std::optional<bool> marchOnThreads(std::size_t threads, std::span<const StartValue> starts,
    const Cost& cost, const Request& request, LabelBounds* bounds, StopLimit& limit,
    DistanceField& field);
  /** The same with the values of one label or of several: see MarchOnThreads.cxx for Sharing.
   * @param context  of the thread that begins, and its control */
  template <class Sharing, class Cost>
  std::optional<bool> marchOnThreads(Sharing& sharing, std::span<const StartValue> starts,
    MarchControl& control, const MarchContext<Cost>& context, const Request& request);
  /** Its second part. @param meanwhile  see callTogether() */
  template <class Meanwhile, class Sharing, class Cost>
  std::optional<bool> goOnOnThreads(SharedMarch& march, const Meanwhile& meanwhile,
    Sharing& sharing, const MarchContext<Cost>& context, const Request& request);
  /** Whether a front of the kind of a request did not settle on threads, or had too many values at
   * a vertex: then later ones do not try. */
  std::uint8_t& isBetterAlone(const Request& request)
  {
    return this->AreBetterAlone[request.hasCost ? 1 : 0][request.front.labels.size() > 1 ? 1 : 0];
  }

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
  /** See isBetterAlone(): without and with a cost, each with one label and with several. */
  std::array<std::array<std::uint8_t, 2>, 2> AreBetterAlone{};
};

}

#endif

#endif
