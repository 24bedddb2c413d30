// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowMerging_h
#define geodesic_WindowMerging_h

namespace geodesic
{

class WindowList;
struct Window;

/**
 * Makes neighbouring windows of a half-edge one, as far as an error bound allows it.
 *
 * The merged window says nowhere more than the two did, and as much at its ends. So a front of
 * merged windows never says more than the true distance; algorithm.md has the proof. By how much
 * the shortest path to one of its points may be longer, at most, each window carries with it
 * (Window::excess), as do the vertices. Windows merge only while this stays within the tolerance
 * times the least distance in the window. Along straight lines the excess stays and the distance
 * grows, so that the bound holds from then on.
 * V. Surazhsky and others, Fast exact and approximate geodesics on meshes, ACM Trans. Graph. 24
 * (2005), merge windows too, but by errors of each merge alone.
 */
class WindowMerging
{
public:
  /** @param tolerance  the largest excess, in parts of the distance */
  explicit WindowMerging(double tolerance);

  /** Merges neighbours in a list, from its beginning to its end. Time linear in their number. */
  void merge(WindowList& list) const;

private:
  /** Makes @p left reach over @p right too. @return false where that can't be, and nothing is
   * changed */
  bool mergeInto(Window& left, const Window& right) const;

  double Tolerance;
};

}

#endif
