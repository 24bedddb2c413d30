// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_KeptWindows_h
#define geodesic_KeptWindows_h

#include "base/Index.h"
#include "windows/Window.h"

#include <cstddef>
#include <span>
#include <vector>

namespace geodesic
{

/** Windows that have crossed triangles, by the half-edges that they crossed: for paths back through
 * them. Memory: 4 bytes for each half-edge once any were kept, and 56 for each window. */
class KeptWindows
{
public:
  /** Forgets all windows. Time linear in their number, but for the first time that any are to be
   * kept: then in the number of half-edges. */
  void start(std::size_t numberOfHalfEdges, bool areWanted)
  {
    for (const Kept& kept : this->Windows)
    {
      this->Last[kept.halfEdge] = NoIndex;
    }
    this->Windows.clear();
    this->AreWanted = areWanted;
    if (areWanted)
    {
      this->Last.resize(numberOfHalfEdges, NoIndex);
    }
  }

  bool areWanted() const { return this->AreWanted; }

  void keep(Index halfEdge, std::span<const Window> windows)
  {
    for (const Window& window : windows)
    {
      const Index number = static_cast<Index>(this->Windows.size());
      this->Windows.push_back({ window, halfEdge, this->Last[halfEdge] });
      this->Last[halfEdge] = number;
    }
  }

  /** Calls @p visit with each window that crossed a half-edge. */
  template <class Visit>
  void visit(Index halfEdge, const Visit& visit) const
  {
    for (Index i = this->Last[halfEdge]; i != NoIndex; i = this->Windows[i].before)
    {
      visit(this->Windows[i].window);
    }
  }

  /** The memory of the windows. */
  std::size_t bytes() const { return this->Windows.capacity() * sizeof(Kept); }

private:
  struct Kept
  {
    Window window;
    Index halfEdge;
    /** The one that crossed the same half-edge before. */
    Index before;
  };

  bool AreWanted = false;
  std::vector<Kept> Windows;
  /** For each half-edge the number of the last window that crossed it. */
  std::vector<Index> Last;
};

}

#endif
