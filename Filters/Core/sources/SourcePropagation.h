// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourcePropagation_h
#define geodesic_SourcePropagation_h

#include "base/Index.h"
#include "march/BucketQueue.h"
#include "mesh/EdgeTable.h"
#include "solve/MarchControl.h"
#include "solve/PassableTriangles.h"
#include "solve/SeedFront.h"
#include "solve/SolveOptions.h"
#include "sources/SourceStore.h"

#include <limits>
#include <vector>

namespace geodesic
{

class ClosedTriangles;
class DistanceField;
class StopLimit;
class TriangleMesh;

/** Where a distance comes from: a label, and the distance at the last point where the path bends.
 */
struct DistanceOrigin
{
  double offset;
  Index label;
};

/** The distance of a vertex; in one line of the cache. */
struct alignas(32) VertexDistance
{
  double value = std::numeric_limits<double>::infinity();
  DistanceOrigin origin{ 0.0, NoIndex };
  /** Whether the vertex waits in the queue. */
  bool isQueued = false;
};

/** A distance that is proposed to a vertex. */
struct ProposedDistance
{
  Index vertex;
  DistanceOrigin origin;
  double value;
};

/** A source that is proposed to a side. */
struct ProposedSource
{
  Index side;
  SeenSource seen;
};

/** What VirtualSourceSolver keeps from run to run, for its memory. */
struct SourceWorkspace
{
  explicit SourceWorkspace(const TriangleMesh& mesh);

  EdgeTable edges;
  SourceStore store;
  std::vector<VertexDistance> vertices;
  /** The vertices that have a distance. */
  std::vector<Index> reached;
  /** The items of a round, and what they propose. */
  std::vector<Index> round;
  std::vector<ProposedDistance> distances;
  std::vector<ProposedSource> sources;
  /** The sides that have news, and the vertices whose distance fell, since the last round. */
  std::vector<Index> sidesWithNews;
  std::vector<Index> loweredVertices;
};

/**
 * One run of virtual source propagation; see VirtualSourceSolver. Sides with news and vertices
 * whose distance fell wait in a queue, by their least distance. A round takes a whole bucket. Its
 * sides hand their sources on across the triangles behind them, and its vertices propose distances
 * along their edges, all from the values before the round. Then what was proposed is taken over.
 */
class SourcePropagation
{
public:
  /** @param workspace of the mesh; all others as in FrontSolver::Request and FrontSolver::march()
   */
  SourcePropagation(const TriangleMesh& mesh, const SeedFront& front, const ClosedTriangles& closed,
    const SolveOptions& options, StopLimit& limit, DistanceField& field,
    SourceWorkspace& workspace);

  /** Lowers the field until it is final up to the limit, and sets the nearest seeds. Returns false
   * when cancelled. */
  bool run();

private:
  /** One of the two other sides of the triangle behind a side: from a corner that lies on that
   * side up to the third corner. */
  struct Exit
  {
    Exit(Index side, Index corner, const SideFrame& frame, double at, double turn);

    Index side;
    Index corner;
    /** The corner's place on the side that is the frame's x axis. */
    double at;
    /** 1 where the triangle lies on the left of the line from the corner up, -1 on its right. */
    double turn;
    double length;
    /** The direction from the corner up. */
    double upX;
    double upY;
  };
  /** The lit part of an exit, as fractions from 0 at its corner to 1 at the third corner, and the
   * distances at its ends; a negative one where it is not known. */
  struct Light
  {
    double from;
    double to;
    double atFrom;
    double atTo;
  };
  /** A source at a side, and the distances at the ends of its lit part. */
  struct LitSource
  {
    VirtualSource source;
    double atFirst;
    double atLast;
  };

  bool canTurn(Index vertex) const;
  bool isFrom(const VirtualSource& source, const VertexDistance& vertex) const;
  void fit(LitSource& lit, const SideFrame& frame, const VertexDistance& first,
    const VertexDistance& second) const;

  void startAt(const Label& label, Index number);
  void takeRound();
  void propagateRound();
  void prefetchBehind(Index side) const;
  void propagateVertex(Index vertex);
  void propagateSide(Index side);
  void propagate(
    const SideFrame& frame, const Exit& atFirst, const Exit& atSecond, const VirtualSource& source);
  void bendAt(const SideFrame& frame, const Exit& nearest, const Exit& other,
    const VirtualSource& source, double atCorner);
  void shineThrough(const Exit& exit, const VirtualSource& source, const Light& light);
  void crossEdge(Index side, Index corner, double length, const LitSource& lit);
  void proposeSource(Index side, LitSource lit);
  void proposeDistance(Index vertex, const DistanceOrigin& origin, double value);
  bool isBehindCorners(const SourceStore::Side& at, const LitSource& lit) const;
  void takeOver();
  void lower(const ProposedDistance& proposed);
  void push(Index item, double distance);

  const TriangleMesh& Mesh;
  const SeedFront& Front;
  const ClosedTriangles& Closed;
  const SolveOptions& Options;
  StopLimit& Limit;
  DistanceField& Field;
  SourceWorkspace& Work;
  PassableTriangles Passable;
  /** Whether each vertex is beside a triangle that is not passable; empty where all are. */
  std::vector<bool> BesideBarrier;
  MarchControl Control;
  /** The least value of any label. The queue's keys are distances less this one. */
  double First = 0.0;
  /** Holds sides by their number, and vertices, numbered behind the sides. */
  BucketQueue Queue;
};

}

#endif
