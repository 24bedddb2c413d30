// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_KeptWindows_h
#define geodesic_KeptWindows_h

#include "base/Index.h"
#include "mesh/EdgeTable.h"
#include "windows/Window.h"

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

namespace geodesic
{

/** Windows that have crossed triangles, by the half-edges that they crossed: for paths back through
 * them. Memory: 4 bytes for each triangle once any were kept, and 56 for each window. */
class KeptWindows
{
public:
  /** Forgets all windows. Time linear in their number, but for the first time that any are to be
   * kept: then in the number of triangles. */
  void start(std::size_t numberOfTriangles, bool areWanted)
  {
    for (const Kept& kept : this->Windows)
    {
      this->Last[EdgeTable::triangleOf(kept.halfEdge)] = NoIndex;
    }
    this->Windows.clear();
    this->AreWanted = areWanted;
    if (areWanted)
    {
      this->Last.resize(numberOfTriangles, NoIndex);
    }
  }

  bool areWanted() const { return this->AreWanted; }

  void keep(Index halfEdge, std::span<const Window> windows)
  {
    Index& last = this->Last[EdgeTable::triangleOf(halfEdge)];
    for (const Window& window : windows)
    {
      const Index number = static_cast<Index>(this->Windows.size());
      this->Windows.push_back({ window, halfEdge, last });
      last = number;
    }
  }

  /** Calls @p visit with each window that crossed a half-edge. */
  template <class Visit>
  void visit(Index halfEdge, const Visit& visit) const
  {
    for (Index i = this->Last[EdgeTable::triangleOf(halfEdge)]; i != NoIndex;
         i = this->Windows[i].before)
    {
      if (this->Windows[i].halfEdge == halfEdge)
      {
        visit(this->Windows[i].window);
      }
    }
  }

  /** The memory of the windows. */
  std::size_t bytes() const { return this->Windows.size() * sizeof(Kept); }

private:
  struct Kept
  {
    Window window;
    Index halfEdge;
    /** The one that crossed the same triangle before. */
    Index before;
  };

  bool AreWanted = false;
  /** In blocks, as to move them all when they become more would take long. */
  std::deque<Kept> Windows;
  /** For each triangle the number of the last window that crossed it. */
  std::vector<Index> Last;
};

}

#endif
