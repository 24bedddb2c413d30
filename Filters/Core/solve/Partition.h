// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Partition_h
#define geodesic_Partition_h

#include "base/Index.h"
#include "solve/MarchingFront.h"
#include "solve/StartValue.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace geodesic
{

class StopLimit;

/**
 * How processes that each have a piece of one surface solve together. This base class is for a
 * surface in one piece; there is nothing to send.
 *
 * Vertices that several pieces have are *shared*. The inputs of an update are the same on every
 * piece that shares the vertex, so that the field is that of the whole surface. All calls but the
 * const ones are collective: every piece makes the same calls in the same order.
 */
class Partition
{
public:
  virtual ~Partition() = default;

  /** The number of this piece in the order of gather(), from 0. */
  virtual std::size_t number() const { return 0; }
  /** Whether the surface is in several pieces. */
  virtual bool isDivided() const { return false; }
  /** Whether this piece owns a vertex: of the pieces that share it, exactly one does. */
  virtual bool owns(Index) const { return true; }
  /** The vertices that other pieces have as well, in ascending order. */
  virtual std::span<const Index> sharedVertices() const { return {}; }
  /**
   * For each vertex of this piece the length of the longest side of the triangles round it on all
   * pieces. Empty where the surface is not divided: use VertexRings::longestSides() then.
   */
  virtual std::span<const float> longestSides() const { return {}; }

  /** Runs a step that makes no collective call. If it throws on one piece, this throws on all. */
  virtual void together(const std::function<void()>& step) { step(); }
  /** Returns the numbers of all pieces, one piece after the other; the same on each. */
  virtual std::vector<double> gather(std::span<const double> own)
  {
    return { own.begin(), own.end() };
  }
  /** Sends values of this piece's vertices. Returns those that other pieces sent for vertices that
   * this piece shares, with this piece's vertex numbers. */
  virtual std::vector<StartValue> exchange(std::span<const StartValue>) { return {}; }
  /**
   * Advances the front until nothing is left to do on any piece.
   * @return false when cancelled on any piece
   */
  virtual bool march(MarchingFront& front, StopLimit&)
  {
    front.advance(std::numeric_limits<double>::infinity(), nullptr);
    return !front.isCancelled();
  }
};

}

#endif
