// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowFront_h
#define geodesic_WindowFront_h

#include "march/BucketQueue.h"
#include "mesh/TriangleMesh.h"
#include "solve/DistanceField.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"
#include "solve/StopLimit.h"
#include "windows/EdgeTable.h"
#include "windows/WindowList.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

class ClosedTriangles;

/** What a front of windows keeps from run to run, for its memory. */
struct WindowWorkspace
{
  explicit WindowWorkspace(const TriangleMesh& mesh);

  /** Drops what still waits. @param reached the vertices that the front reached */
  void empty(std::span<const Index> reached);

  /** The windows that wait at a half-edge. */
  struct Waiting
  {
    WindowList list;
    Index halfEdge = NoIndex;
    /** The least distance of any of them. */
    double least = 0.0;
  };

  /** For each half-edge the number of its entry in @ref waiting; NoIndex where no window waits. */
  std::vector<Index> places;
  std::vector<Waiting> waiting;
  /** Entries of @ref waiting that no half-edge has. */
  std::vector<Index> free;
  /** For each vertex whether paths from it are still to be sent. */
  std::vector<std::uint8_t> isToSend;
  /** The memory of all lists, in bytes. */
  std::size_t bytes = 0;
  BucketQueue queue;
};

/**
 * The march of windows over a mesh. All windows that wait at a half-edge cross its triangle at one
 * time, to its two other edges, where they wait again. A vertex at which shortest paths can turn
 * sends windows of its own. Half-edges and vertices come roughly in the order of their distances;
 * any order gives the same field.
 *
 * A window, or a part of it, is dropped where a path through an end of its edge is shorter, or
 * another window that waits at the same half-edge. The first is the filter of S. Xin, G. Wang,
 * Improving Chen and Han's algorithm on the discrete geodesic problem, ACM Trans. Graph. 28 (2009),
 * applied to parts. Windows that have crossed a triangle are not kept.
 */
class WindowFront
{
public:
  /**
   * @param first  the least value of any seed
   * @param field  reset; gets distances and nearest seeds
   */
  WindowFront(const TriangleMesh& mesh, const EdgeTable& edges, const ClosedTriangles& closed,
    const SolveOptions& options, double first, StopLimit& limit, DistanceField& field,
    WindowWorkspace& workspace);

  /** Starts paths from a point seed. @param number of the seed */
  void startAt(const SurfacePoint& point, double value, Index number);

  /**
   * Marches until no window below the limit is left.
   * @return false when cancelled
   * @throws std::runtime_error where the windows need more memory than SolveOptions::memoryLimit
   */
  bool march();

private:
  /** A triangle laid in the plane: @ref lower and @ref higher on the x axis, the apex above it. */
  struct LaidTriangle
  {
    Index triangle;
    Index lower;
    Index higher;
    Index apex;
    double length;
    double x;
    double y;
  };

  /** An edge to which windows go, and what is known about it. */
  struct Target
  {
    Index halfEdge;
    double length;
    /** Distances at its lower and at its higher end. */
    double atLower;
    double atHigher;
  };

  LaidTriangle laid(Index halfEdge) const;
  Target targetOf(Index halfEdge, Index from, Index to, double length) const;
  double lengthOf(Index a, Index b) const;
  bool isPassable(Index triangle) const
  {
    return this->Passable.empty() || this->Passable[triangle];
  }
  bool canTurn(Index vertex) const
  {
    return this->Edges.canTurn(vertex) || (!this->Turning.empty() && this->Turning[vertex]);
  }
  void findBarriers();

  /** Whether windows can go on from any other triangle of the half-edge's edge. */
  bool leadsOn(Index halfEdge) const;
  /** Lets the windows that wait at a half-edge cross its triangle. */
  void crossTriangle(Index halfEdge);
  /** Gives the apex the distances of the windows that light it. */
  void reachApex(const LaidTriangle& laid, std::span<const Window> windows);
  /** Lets windows go on to the side from the triangle's lower or its higher corner to its apex. */
  void crossTo(const LaidTriangle& laid, std::span<const Window> windows, bool isLower);
  /** Sends straight lines from a point of a triangle through the edge of a half-edge. */
  void sendThrough(Index halfEdge, const Vector3& from, double distance, Index seed);
  /** Sends paths from a vertex through all triangles round it, and along edges. */
  void sendFrom(Index vertex);
  /** Cuts off a window what a path by the ends of its edge can reach on a shorter way, and lets it
   * wait in all other triangles of the edge. */
  void offer(const Target& target, Window window);
  void wait(Index halfEdge, const Window& window, double least);
  /** Gives a vertex a distance if that is less than what it has. */
  void reach(Index vertex, double distance, Index seed);
  void queueVertex(Index vertex, double distance);
  /** Works on an item of the queue: a half-edge, or a vertex after these. */
  void take(Index item);
  /** Follows the targets, reports progress and checks memory; false once the run is cancelled. */
  bool mayGoOn();
  void checkMemory() const;

  const TriangleMesh& Mesh;
  const EdgeTable& Edges;
  const ClosedTriangles& Closed;
  const SolveOptions& Options;
  StopLimit& Limit;
  DistanceField& Field;
  WindowWorkspace& Work;
  /** The queue's keys are distances less this one. */
  double First;
  /** For each triangle whether windows may cross it; empty if they may cross all. */
  std::vector<bool> Passable;
  /** For each vertex whether paths can turn there because of barriers. */
  std::vector<bool> Turning;
  /** The windows that cross a triangle now. */
  WindowList Crossing;
  std::size_t MostBytes;
  /** How many windows have crossed a triangle, and when mayGoOn() looks at things again. */
  std::size_t Crossed = 0;
  std::size_t NextLook = 0;
  std::size_t NextReport;
};

}

#endif
