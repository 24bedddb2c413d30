// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Partition_h
#define geodesic_Partition_h

#include "base/Index.h"
#include "solve/MarchingFront.h"
#include "solve/StartValue.h"

#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace geodesic
{

class StopLimit;

/**
 * How the processes that have a piece each of one surface solve together. This one is of a surface
 * in one piece.
 *
 * Vertices that several pieces have are *shared*. All that enters an update is the same on every
 * piece that shares the vertex, so that the field is the one of the whole surface. All calls but
 * the const ones are collective: every piece makes the same ones in the same order.
 */
class Partition
{
public:
  virtual ~Partition() = default;

  virtual bool isDivided() const { return false; }
  /** Whether a vertex counts as this piece's: of those that share it one owns it. */
  virtual bool owns(Index) const { return true; }
  /** The vertices that other pieces have as well. */
  virtual std::span<const Index> sharedVertices() const { return {}; }
  /**
   * Of each vertex the length of the longest side of the triangles round it on all pieces. Empty
   * where the surface is not divided: then VertexRings::longestSides() are meant.
   */
  virtual std::span<const float> longestSides() const { return {}; }

  /** Runs a step that makes no collective call. Where it throws on one piece, it does on all. */
  virtual void together(const std::function<void()>& step) { step(); }
  /** What each piece gives, one after the other in the order of the pieces. */
  virtual std::vector<double> gather(std::span<const double> own)
  {
    return { own.begin(), own.end() };
  }
  /** What the other pieces give for vertices that this one shares, by its own vertex numbers. */
  virtual std::vector<StartValue> exchange(std::span<const StartValue>) { return {}; }
  /**
   * Marches until nothing is left to do on any piece.
   * @return false when cancelled on any piece
   */
  virtual bool march(MarchingFront& front, StopLimit&)
  {
    front.advance(std::numeric_limits<double>::infinity());
    return !front.isCancelled();
  }
};

}

#endif
