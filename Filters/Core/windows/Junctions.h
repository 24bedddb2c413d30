// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Junctions_h
#define geodesic_Junctions_h

#include "base/Index.h"
#include "windows/Window.h"
#include "windows/WindowList.h"

#include <cstddef>
#include <deque>
#include <span>
#include <unordered_map>
#include <vector>

namespace geodesic
{

class EdgeTable;
class PassableTriangles;

/**
 * The windows at edges of more than two triangles, where a front divides and its parts can cross
 * each other's sheets for ever. All windows that come to such an edge wait there together. Of
 * those, and of all that went on from it before, each point of the edge keeps the nearest, from
 * whichever sheet it came, and only that goes on. So each sheet is entered as often as the nearest
 * windows of the edge change, however many come.
 */
class Junctions
{
public:
  /** A window that comes, and the half-edge of the triangle that it comes from. */
  struct Coming
  {
    Window window;
    Index from;
  };

  struct Junction
  {
    /** The edge's half-edges whose triangles may be crossed. */
    std::vector<Index> sides;
    std::vector<Coming> waiting;
    /** The least key of those that wait. */
    double key = 0.0;
    /** The nearest of all that went on. */
    WindowList passed;
  };

  /** Lets windows wait. @param key the least of any of them
   * @return whether the edge is to be queued with that key, by its first half-edge */
  bool wait(const EdgeTable& edges, const PassableTriangles& passable, Index halfEdge,
    std::span<const Window> windows, double key);

  /** Whether windows wait at the junction of an edge. @param first  its first half-edge */
  bool doWaitAt(Index first) const;

  /** Lets those parts of the waiting windows pass that are nearest, the nearest windows first.
   * @param first    the edge's first half-edge
   * @param passing  gets them
   * @return the junction */
  const Junction& pass(Index first, std::vector<Coming>& passing);

  /** The windows that went on from an edge: the nearest at each of its points. None where no front
   * divided. @param first  its first half-edge */
  std::span<const Window> passedAt(Index first) const;

  void clear();
  /** The memory of the windows. */
  std::size_t bytes() const { return this->Bytes; }

private:
  Junction& at(const EdgeTable& edges, const PassableTriangles& passable, Index halfEdge);

  /** In blocks, as a junction stays in place while others are added. */
  std::deque<Junction> All;
  /** For the first half-edge of each edge the number of its junction. */
  std::unordered_map<Index, Index> Places;
  std::vector<Window> Nearer;
  std::size_t Bytes = 0;
};

}

#endif
