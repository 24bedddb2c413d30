// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveOptions_h
#define geodesic_SolveOptions_h

#include "base/Index.h"
#include "mesh/SurfacePoint.h"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <span>

namespace geodesic
{

/** Whether the front may stop when any target is final, or only when all are. */
enum class TargetMode
{
  Any,
  All
};

class Partition;

/** Thrown where a path on a part of a surface depends on triangles outside that part. */
class IncompleteRing : public std::exception
{
public:
  explicit IncompleteRing(Index vertex)
    : Vertex(vertex)
  {
  }
  /** A vertex on the path some of whose triangles are missing. */
  Index vertex() const { return this->Vertex; }
  const char* what() const noexcept override
  {
    return "The mesh lacks triangles round a vertex of the path.";
  }

private:
  Index Vertex;
};

/** Options of a solver's run. Spans borrow the caller's arrays. */
struct SolveOptions
{
  /**
   * The cost of a unit of length at each vertex, from 1e-30 to 1e30. The cost of a triangle is the
   * mean of its corners' costs; distances are lengths times cost. Empty: 1 everywhere.
   */
  std::span<const double> cost;
  /** One flag for each vertex: the front never enters non-zero ones. Empty: none. */
  std::span<const std::uint8_t> excluded;
  /** One flag for each triangle: the front never crosses non-zero ones. Their vertices, and their
   * edges to other triangles, stay open. Empty: none. */
  std::span<const std::uint8_t> closedTriangles;
  /** Vertices up to this distance get their final one, farther ones get none. At least 0. */
  double maximumDistance = std::numeric_limits<double>::infinity();
  /**
   * For each vertex the distance from which on its own is of no use, such as the one that runs
   * before have given it. A distance below that is the same as else; another is missing or too
   * large, as the front need not go there. Must not change during the run. Empty: all are of use.
   */
  std::span<const double> usefulBelow;
  /**
   * Whether cost and barriers are the same arrays, with the same content, as in the solver's run
   * before, on all pieces: what a run checks and prepares of them, in time O(n), is then kept.
   */
  bool keepsSurface = false;
  /**
   * The targets to reach. A target is three vertices: the corners of a point's triangle, or the
   * same vertex three times. It is reached when all three are. Vertices farther than the last
   * target that targetMode needs get no distance. Empty: no targets.
   */
  std::span<const Triangle> targets;
  TargetMode targetMode = TargetMode::Any;
  /** By how much vertices may be farther than a target and yet get a distance. */
  double beyondTargets = 0.0;
  /**
   * Whether only paths to the targets matter. Vertices that none of these can pass then get no
   * distance, or one that is too large; those on shortest paths get the same one as else. Needs
   * TargetMode::All. Where the surface is in several pieces, and with virtual sources, all vertices
   * are treated alike.
   */
  bool onlyTowardsTargets = false;
  /**
   * Whether DistanceField::nearestSeed matters. If not, curves that go on straight from each other
   * are solved as one (see joinedCurves()), which is faster where there are many, and the nearest
   * seed is any of these. Exact and bounded distances don't look at it.
   */
  bool numbersSeeds = true;
  /**
   * Called each time that the march has taken another progressInterval vertices from its queue,
   * with the number of vertices so far; now and then again with the same number where many seeds
   * are placed or nothing new is reached. Before marches of many seeds, between them and after them
   * it is called as well, whatever progressInterval is, and each call counts as one vertex. A
   * search for paths (PathFinder) also calls it between marches, and counts what it looks at there.
   * Returning false cancels the run.
   */
  std::function<bool(std::size_t)> onProgress;
  std::size_t progressInterval = 100;
  /** The most memory that exact and bounded distances may take beside the mesh, in bytes. 0: three
   * quarters of the machine's. Other methods don't look at it. */
  std::size_t memoryLimit = 0;
  /** By how much distances may be too large, in parts of each distance itself; above 0. For
   * BoundedSolver only. */
  double tolerance = 1e-3;
  /**
   * Points from which paths to their nearest seeds are wanted, for solvers that find these along
   * with the field (DistanceSolver::findsPaths()); other solvers have no use for them.
   */
  std::span<const SurfacePoint> pathStarts;
  /**
   * The most threads that share one march of fast marching; 64 at most are used. Marches that may
   * stop early, at a maximum distance or targets, or are on pieces of a surface, are on one thread;
   * so are those with costs that differ by orders of magnitude, all other methods, and all marches
   * without vector extensions (see Platform.h). The field is the same on any number, to 1e-9, but
   * on several threads not to the last bit from run to run.
   */
  std::size_t threads = 1;
  /** Whether fast marching goes over intrinsic triangles, see IntrinsicMarchingSolver: where many
   * triangles are thin, it is faster and more exact. Others don't look at it. */
  bool isIntrinsic = false;
  /** So many vertices there must be for each thread that shares a march: below that it gains too
   * little. */
  std::size_t verticesOfThread = std::size_t{ 1 } << 16;
  /**
   * How to solve together with the other pieces of the surface. Each piece is given the same seeds,
   * targets and limits; a target that only other pieces have has the vertices NoIndex. Null: the
   * surface is in one piece.
   */
  Partition* partition = nullptr;
  /**
   * For paths only. One flag for each vertex: non-zero where the mesh is a part of a larger surface
   * and lacks some of the triangles round the vertex. A path that depends on them throws
   * IncompleteRing. Empty: the mesh is the whole surface.
   */
  std::span<const std::uint8_t> incomplete;

  bool isExcluded(Index vertex) const { return !this->excluded.empty() && this->excluded[vertex]; }
  bool isIncomplete(Index vertex) const
  {
    return !this->incomplete.empty() && this->incomplete[vertex];
  }
  bool isClosed(Index triangle) const
  {
    return !this->closedTriangles.empty() && this->closedTriangles[triangle];
  }
};

}

#endif
