// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_ViewSnapshot_h
#define seeds_ViewSnapshot_h

#include "Position.h"

#include <QPointF>

#include <array>
#include <optional>
#include <vector>

class pqRenderView;

namespace seeds
{

/**
 * What a view shows at a moment: where points are drawn, and whether something is in front of them.
 * Takes less time than ViewGeometry for many points. It is right until the camera or the scene
 * changes, in a view that is drawn in this process.
 */
class ViewSnapshot
{
public:
  explicit ViewSnapshot(pqRenderView* view);

  /**
   * The place where a point is seen, in Qt's pixels; none if it is behind the camera, outside the
   * view, or farther than a tolerance behind what is drawn there (see ViewGeometry::isCovered).
   */
  std::optional<QPointF> placeOf(const Position& point, double tolerance) const;

private:
  /** As parts of the window from its lower left corner, and the depth from 0 to 1; none if behind.
   */
  std::optional<Position> project(const Position& point) const;

  std::array<double, 16> Matrix{};
  Position Ahead{};
  int Width = 0;
  int Height = 0;
  double PixelsPerPoint = 1.0;
  /** At each pixel the farthest depth of those around it. */
  std::vector<float> Depths;
};

}

#endif
