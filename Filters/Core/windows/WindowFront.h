// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowFront_h
#define geodesic_WindowFront_h

#include "base/BulkVector.h"
#include "base/PlanePoint.h"
#include "march/BucketQueue.h"
#include "mesh/EdgeTable.h"
#include "mesh/TriangleMesh.h"
#include "solve/DistanceField.h"
#include "solve/PassableTriangles.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"
#include "solve/StopLimit.h"
#include "windows/Arrival.h"
#include "windows/Junctions.h"
#include "windows/KeptWindows.h"
#include "windows/PathStarts.h"
#include "windows/TurnSector.h"
#include "windows/WindowList.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

class ClosedTriangles;
class WindowMerging;
struct LaidTriangle;

/** What a front of windows keeps from run to run, for its memory. */
struct WindowWorkspace
{
  explicit WindowWorkspace(const TriangleMesh& mesh);

  /** The memory of all but the mesh. */
  std::size_t allBytes() const;
  /** Drops what still waits. @param reached the vertices that the front reached */
  void empty(std::span<const Index> reached);

  /** The windows that wait at a half-edge. */
  struct Waiting
  {
    WindowList list;
    Index halfEdge = NoIndex;
    /** The least key of any of them in the queue. */
    double key = 0.0;
  };

  /** For each half-edge the number of its entry in @ref waiting; NoIndex where no window waits. */
  std::vector<Index> places;
  std::vector<Waiting> waiting;
  /** Kept after a run, for its paths. */
  Junctions junctions;
  /** Entries of @ref waiting that no half-edge has. */
  std::vector<Index> free;
  /** For each vertex how the shortest path comes there; with windows that were merged, a path no
   * longer than its distance and excess, and only if there are points from which paths are wanted.
   * Undefined where nothing has come. */
  BulkVector<Arrival> arrivals;
  /** If paths are wanted and windows were merged, all that have crossed a triangle. */
  KeptWindows kept;
  PathStarts starts;
  /** For each vertex by how much the shortest path may be longer than its distance; empty where
   * distances are exact. */
  std::vector<float> excesses;
  /** For each vertex whether paths from it are still to be sent. */
  std::vector<std::uint8_t> isToSend;
  /** The memory of all lists but the junctions', in bytes. */
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
 * another window that waits at the same half-edge. At edges of more than two triangles it must be
 * nearer than all that came there before (see Junctions). The first is the filter of S. Xin, G.
 * Wang, Improving Chen and Han's algorithm on the discrete geodesic problem, ACM Trans. Graph. 28
 * (2009), applied to parts. Else windows that have crossed a triangle are not kept; where paths are
 * wanted (SolveOptions::pathStarts), each vertex remembers the one that gave it its distance. Only
 * windows that were merged are kept then, as they do not tell the straight lines that they were
 * merged from.
 *
 * Round the tip of a spike, or a thin tube, such a window circles as long as it goes on straight,
 * though it was nearer when it first came. Where windows cross triangles very often, the march
 * begins again, with all edges as junctions and all vertices as turns: there windows must be
 * shorter than any path by an end of the edge, by more than rounding can make.
 */
class WindowFront
{
public:
  /** By which part of what is left to the goal of a march windows come later. With all of it, those
   * that lead straight to the goal would not wait for those beside them, which may drop them. */
  static constexpr double PartOfOrder = 0.9;

  /**
   * @param seeds  how many there are
   * @param first  the least key of any seed: its value, and the part of what is left from there
   * @param field  reset; gets distances and nearest seeds
   * @param merging  null: distances are exact. Else they are lower bounds, and the workspace's
   *                 excesses say by how much the shortest paths may be longer.
   */
  WindowFront(const TriangleMesh& mesh, const EdgeTable& edges, const ClosedTriangles& closed,
    const PassableTriangles& passable, const SolveOptions& options, std::size_t seeds, double first,
    StopLimit& limit, DistanceField& field, WindowWorkspace& workspace,
    const WindowMerging* merging = nullptr);
  /** Leaves the workspace empty. */
  ~WindowFront() { this->Work.empty(this->Field.reached()); }
  WindowFront(const WindowFront&) = delete;
  WindowFront& operator=(const WindowFront&) = delete;

  /** Starts paths from a point seed. @param number of the seed */
  void startAt(const SurfacePoint& point, double value, Index number);

  /** Gives a vertex the value of a seed from which other paths start. Paths can turn there only as
   * at any vertex. */
  void set(Index vertex, double value, Index number) { this->reach(vertex, value, number, {}); }

  /** Starts a straight front to both sides of a line in a triangle, or to one side where the line
   * lies along a side. */
  void startAlong(
    Index triangle, const SurfacePoint& from, const SurfacePoint& to, double value, Index number);

  /**
   * Follows the targets, reports progress and checks memory; false once the run is cancelled. To be
   * asked after each seed; march() asks by itself.
   * @throws std::runtime_error as march()
   */
  bool mayGoOn();

  /**
   * Marches until no window below the limit is left, or windows circle (see beginsAgain()).
   * @return false when cancelled
   * @throws std::runtime_error where the run needs more memory than SolveOptions::memoryLimit
   */
  bool march();

  /** Whether windows circled, or many points were hidden, so that the march must begin again: with
   * the seeds, which are to be started as before. */
  bool beginsAgain();

private:
  /** An edge to which windows go, and what is known about it. */
  struct Target
  {
    Index halfEdge;
    double length;
    /** Distances at its lower and at its higher end. */
    double atLower;
    double atHigher;
    /** Where the goal of the paths lies, if there is one; as a window's source. */
    PlanePoint goal;
  };

  Target targetOf(Index halfEdge, Index from, Index to, double length) const;
  /** A lower bound of the length of paths through a window to the goal. */
  double shortestToGoal(const Window& window, const PlanePoint& goal) const;
  bool canTurn(Index vertex) const
  {
    return this->Edges.canTurn(vertex) || this->isTurning(vertex);
  }
  /** Whether paths are known to turn there, whatever the angles are. */
  bool isTurning(Index vertex) const { return !this->Turning.empty() && this->Turning[vertex]; }
  /** By how much the shortest path to a vertex may be longer than its distance. */
  float excessAt(Index vertex) const
  {
    return this->Work.excesses.empty() ? 0.0F : this->Work.excesses[vertex];
  }
  void findTurnsAtBarriers();
  /** Makes the workspace ready for a march. */
  void begin();

  /** Whether windows can go on from any other triangle of the half-edge's edge. */
  bool leadsOn(Index halfEdge) const;
  /** Keeps windows that are about to cross, merged, if paths are wanted. */
  void keepForPaths(Index halfEdge, std::span<const Window> windows);
  /** Makes the windows that wait at a half-edge those that cross. */
  void takeWaiting(Index halfEdge);
  /** Lets the windows of @ref Crossing cross the triangle of a half-edge. */
  void crossTriangle(Index halfEdge);
  /** Gives the apex the distances of the windows that light it. */
  void reachApex(Index halfEdge, const LaidTriangle& laid, std::span<const Window> windows);
  /** Lets windows go on to the side from the triangle's lower or its higher corner to its apex. */
  void crossTo(const LaidTriangle& laid, std::span<const Window> windows, bool isLower);
  /** Sends straight lines from a point of a triangle through the edge of a half-edge, or of a
   * vertex through a part of it. */
  void sendThrough(Index halfEdge, const Vector3& from, double distance, Index seed,
    float excess = 0.0F, const TurnSector::Part& part = {});
  /** Sends a straight front from a line of a triangle, from @p a to @p b, through the edge of a
   * half-edge. */
  void sendStraight(Index halfEdge, const Vector3& a, const Vector3& b, double value, Index seed);
  /** Sends paths from a vertex through triangles round it, and along edges. */
  void sendFrom(Index vertex);
  /** Finds where shortest paths go on from a vertex; false if that may be anywhere. */
  bool findSector(Index vertex);
  /** Cuts off the window offered last what a path by the ends of its edge can reach on a shorter
   * path; withdraws it if nothing is left, or nothing that the run needs. */
  void cutOffered(const Target& target);
  /** Lets the windows that were offered to an edge wait to cross its other triangle, or at the
   * junction of its triangles. */
  void letOfferedWait(Index halfEdge);
  void waitAtJunction(Index halfEdge);
  /** Lets the windows that wait at a junction cross all triangles but those that they come from.
   * @param first  the first half-edge of the junction's edge
   * @return false when cancelled */
  bool passJunction(Index first);
  void waitAt(Index halfEdge);
  /** Gives a vertex a distance if that is less than what it has.
   * @param excess  by how much the shortest path may be longer */
  void reach(
    Index vertex, double distance, Index seed, const Arrival& arrival, float excess = 0.0F);
  /** Notes the windows that light points of a triangle from which paths are wanted. */
  void reachStarts(Index halfEdge, const LaidTriangle& laid, std::span<const Window> windows);
  /** The queue's key of a vertex. */
  double keyOf(Index vertex) const;
  void queueVertex(Index vertex);
  /** Works on the queue until nothing below the limit is left.
   * @return false when cancelled */
  bool takeAll();
  /**
   * Lets paths turn at vertices from which a neighbour is nearer along the edge than any path that
   * was found. There is none but for rounding: between long needles all lines are as short to the
   * last digits as those past either side of a vertex, and none may be left that leads behind it.
   * @return whether there are any
   */
  bool turnBeforeHidden();
  /** Whether windows wait at a half-edge's edge as at a junction. */
  bool isJunction(Index halfEdge) const
  {
    return this->DoesRemember || this->Edges.isOfMany(halfEdge);
  }
  /** Works on an item of the queue: a half-edge, or a vertex after these.
   * @return false when cancelled */
  bool take(Index item);
  /** The memory of the run but for the mesh. */
  std::size_t bytes() const
  {
    return this->Edges.bytes() + this->Field.bytes() + this->Work.allBytes();
  }
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
  const PassableTriangles& Passable;
  /** For each vertex whether paths turn there whatever the angles are: because of barriers, or as
   * they leave a neighbour out. Empty where there is none. */
  std::vector<bool> Turning;
  /** Of the queue. */
  double BucketWidth;
  /** Makes windows fewer before they cross; null where distances are exact. */
  const WindowMerging* Merging = nullptr;
  /** The windows that cross a triangle. */
  WindowList Crossing;
  /** Where on the crossed edge the line of each of them to the apex passes. */
  std::vector<double> BesideApex;
  /** The windows that are offered to an edge, and their least key. */
  std::vector<Window> Offered;
  double LeastKey = DistanceField::Unreached;
  TurnSector Sector;
  /** Those that pass a junction. */
  std::vector<Junctions::Coming> Passing;
  std::size_t MostBytes;
  static constexpr std::size_t LookInterval = 1024;
  /** How many windows have crossed a triangle, and when mayGoOn() looks at things again. */
  std::size_t Crossed = 0;
  std::size_t NextLook = LookInterval;
  /** For each vertex, windows are taken to cross a triangle no more often than this where they
   * don't circle: usually 3 to 10 times, on a Bunny flattened by 10,000 too. */
  static constexpr std::size_t FewTakes = 64;
  /** So many at a time count as one more. */
  static constexpr std::size_t ManyWindows = 64;
  std::size_t Takes = 0;
  /** Whether the march must begin again; and whether it has, and remembers what passed each edge.
   */
  bool DoCircle = false;
  bool DoesRemember = false;
  /** The number of vertices last reported, and the next one. */
  std::size_t LastReport = 0;
  std::size_t NextReport;
};

}

#endif
