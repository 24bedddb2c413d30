// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowList_h
#define geodesic_WindowList_h

#include "windows/Window.h"

#include <span>
#include <vector>

namespace geodesic
{

/**
 * The windows that wait at a half-edge, in the order of their places on the edge. Of two that
 * overlap, each point keeps the one that is nearer: windows of a list never overlap. Adjacent
 * windows of one source, as they come past a vertex in a plane, become one.
 */
class WindowList
{
public:
  std::span<const Window> windows() const { return this->Windows; }
  std::span<Window> windows() { return this->Windows; }
  /** Keeps only the first windows. */
  void keep(std::size_t count) { this->Windows.resize(count); }
  bool isEmpty() const { return this->Windows.empty(); }
  void clear() { this->Windows.clear(); }
  std::size_t bytes() const { return this->Windows.capacity() * sizeof(Window); }

  /** Adds those parts of a window that are nearer than what the list has there. Time O(1) if the
   * window belongs at the end, else linear in what comes behind it. */
  void insert(const Window& window)
  {
    if (this->Windows.empty() || this->Windows.back().last <= window.first)
    {
      this->append(window, window.first);
    }
    else if (!this->insertBehind(window))
    {
      this->insertAmong(window);
    }
  }

  /** Adds windows, one after the other on the edge, each as insert(). Those that come from the
   * triangle's other side may lie before all that wait here: both are gone through once. */
  void insertAll(std::span<const Window> windows);

  /** Appends those parts of a window that are nearer than what this list has there. */
  void appendNearer(const Window& window, std::vector<Window>& parts) const;

  /** Exchanges the windows of two lists. */
  void swap(WindowList& other) { this->Windows.swap(other.Windows); }

private:
  /** Adds a window, from a place on, behind the others, or makes the last one longer if that has
   * the same source and touches it. */
  void append(const Window& window, double first);
  /** Divides the end of the last window and the beginning of another one between them, if each is
   * nearer at its own end. That is what happens most often on curved surfaces, where parts of a
   * front meet behind a vertex. @return false if it is not so, and nothing is changed */
  bool insertBehind(const Window& window);
  void insertAmong(const Window& window);

  std::vector<Window> Windows;
};

}

#endif
