// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_PathProbe_h
#define seeds_PathProbe_h

#include "Position.h"
#include "ShownSurface.h"

#include <QByteArray>
#include <QPointF>

#include <optional>

namespace seeds
{

/** A point on a path, in the data's coordinates, and the row that it would have among the
 * waypoints. */
struct PathPlace
{
  int row;
  Position point;
};

/**
 * Finds the place of a filter's path under the pointer. The server finds the nearest point of the
 * path; the view tells whether it is drawn near the pointer.
 */
class PathProbe
{
public:
  /**
   * @param segments  the cell array of the filter's output that numbers the segments from waypoint
   * to waypoint; empty if the output is no path through the points
   */
  PathProbe(vtkSMProxy* filter, const ShownSurface& surface, const QByteArray& segments);

  /** Tells the number of waypoints and of segments of the last run. */
  void setCounts(int waypoints, int segments);
  /**
   * The place of the path under the pointer; none where the path is farther than some pixels,
   * hidden, or not up to date.
   * @param onSurface  the point of the surface under the pointer, in the data's coordinates
   */
  std::optional<PathPlace> at(
    pqRenderView* view, const QPointF& place, const Position& onSurface) const;

private:
  bool isShownIn(pqRenderView* view) const;

  vtkSmartPointer<vtkSMProxy> Filter;
  ShownSurface Surface;
  /** The proxy NearestOnLines. */
  vtkSmartPointer<vtkSMProxy> Finder;
  QByteArray Segments;
  bool JoinsWaypoints = false;
};

}

#endif
