// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveOptions_h
#define geodesic_SolveOptions_h

#include "base/Index.h"

#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <span>

namespace geodesic
{

/** Which of the targets must be final before the front may stop. */
enum class TargetMode
{
  Any,
  All
};

class Partition;

/** Thrown where a path on a part of a surface depends on what lies beyond that part. */
class IncompleteRing : public std::exception
{
public:
  explicit IncompleteRing(Index vertex)
    : Vertex(vertex)
  {
  }
  /** Whose triangles are not all there. */
  Index vertex() const { return this->Vertex; }
  const char* what() const noexcept override
  {
    return "The mesh lacks triangles round a vertex of the path.";
  }

private:
  Index Vertex;
};

struct SolveOptions
{
  /**
   * Cost of a unit of length at each vertex, positive and finite; that of a triangle is the mean of
   * its corners'. Empty: 1. Distances are lengths times cost.
   */
  std::span<const double> cost;
  /** One flag a vertex: non-zero ones are never entered by the front. Empty: none. */
  std::span<const std::uint8_t> excluded;
  /** One flag a triangle: the front never crosses non-zero ones; their border stays open. Empty:
   * none. */
  std::span<const std::uint8_t> closedTriangles;
  /** No vertex farther than this gets a distance, every nearer one gets its final one. */
  double maximumDistance = std::numeric_limits<double>::infinity();
  /**
   * What to reach: each target is a set of three vertices (the corners round a point; three times
   * the same for a vertex) and reached when all of them are. Nothing farther than the last one
   * needed gets a distance. Empty: none.
   */
  std::span<const Triangle> targets;
  TargetMode targetMode = TargetMode::Any;
  /**
   * Called with the number of vertices taken from the queue so far, each time that another
   * @a progressInterval were; returning false cancels the run.
   */
  std::function<bool(std::size_t)> onProgress;
  std::size_t progressInterval = 100;
  /**
   * How to solve together with the other pieces of the surface, each of which is given the same
   * seeds, targets and limits. A target that is on other pieces only has the corners NoIndex. Null:
   * the surface is in one piece.
   */
  Partition* partition = nullptr;
  /**
   * For paths only. One flag a vertex: non-zero where the mesh, a part of a larger surface, lacks
   * some of the triangles round it. A path that depends on them ends in IncompleteRing. Empty: the
   * mesh is the surface.
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
