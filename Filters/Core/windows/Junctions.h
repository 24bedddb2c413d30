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

  /** Whether an edge has more than two triangles. */
  static bool isAt(const EdgeTable& edges, Index halfEdge);

  /** Lets windows wait. @param key the least of any of them
   * @return the junction, if it is to be queued with that key by the first of its sides; else null
   */
  const Junction* wait(const EdgeTable& edges, const PassableTriangles& passable, Index halfEdge,
    std::span<const Window> windows, double key);

  /** Whether a half-edge is the first of the sides of a junction at which windows wait. */
  bool doWaitAt(Index halfEdge) const;

  /** Lets those parts of the waiting windows pass that are nearest, the nearest windows first.
   * @param passing  gets them
   * @return the junction; its key is that of the windows */
  const Junction& pass(Index halfEdge, std::vector<Coming>& passing);

  void clear();
  /** The memory of the windows. */
  std::size_t bytes() const { return this->Bytes; }

private:
  Junction& at(const EdgeTable& edges, const PassableTriangles& passable, Index halfEdge);

  /** In blocks, as a junction stays in place while others are added. */
  std::deque<Junction> All;
  /** For each half-edge of theirs the number of its junction. */
  std::unordered_map<Index, Index> Places;
  std::vector<Window> Nearer;
  std::size_t Bytes = 0;
};

}

#endif
