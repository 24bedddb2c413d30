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
#include "sources/SideFrame.h"
#include "sources/SourceStore.h"

#include <array>
#include <cstdint>
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
  Index label;
  double offset;
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
  /** For each vertex the origin of its distance. */
  std::vector<DistanceOrigin> origins;
  /** For each vertex whether it waits in the queue. */
  std::vector<std::uint8_t> isQueued;
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
  /** A corner of the triangle behind a side that lies on the side, and the side of that triangle
   * from it to the opposite corner. */
  struct Exit
  {
    Index side;
    Index corner;
    /** The corner's place on the side that is the frame's x axis. */
    double at;
    /** 1 where the triangle lies on the left of the line from the corner up, -1 on its right. */
    double turn;
  };

  /** The distance at a vertex for the first, second and third corner of a triangle. */
  struct Corners
  {
    Index first;
    Index second;
    Index third;
  };
  Corners cornersOf(Index side) const;
  SideFrame frameOf(const Corners& corners) const;
  /** Moves a source to the distances at its side's corners that come from the same place. */
  void fit(VirtualSource& source, const Corners& corners, double length) const;
  /** The distance at a vertex if it comes from the same place as that of a source, else infinity.
   */
  double distanceFrom(const VirtualSource& source, Index vertex) const;

  void startAt(const Label& label, Index number);
  void takeRound();
  void propagateVertex(Index vertex);
  void propagateSide(Index side);
  void propagate(Index side, const Corners& corners, const SideFrame& frame, VirtualSource source);
  VirtualSource bentAt(const VirtualSource& source, double at, const Exit& nearest) const;
  void shineThrough(
    const Exit& exit, const SideFrame& frame, const VirtualSource& source, double from, double to);
  void crossEdge(Index side, Index corner, double length, const VirtualSource& source);
  void proposeSource(Index side, VirtualSource source);
  void proposeDistance(Index vertex, const DistanceOrigin& origin, double value);
  bool isUseful(const Corners& corners, const SideFrame& frame, const SeenSource& seen) const;
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
  MarchControl Control;
  /** The least value of any label. The queue's keys are distances less this one. */
  double First = 0.0;
  /** Holds sides by their number, and vertices, numbered behind the sides. */
  BucketQueue Queue;
};

}

#endif
