// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SurfaceProbe_h
#define seeds_SurfaceProbe_h

#include "Position.h"
#include "ShownSurface.h"
#include "ViewGeometry.h"

#include <QString>

#include <optional>

namespace seeds
{

/** The result of a probe under the pointer. */
struct Probed
{
  /** The point in the data's coordinates; none if nothing can be picked. */
  std::optional<Position> point;
  /** Why nothing can be picked, as a message for the user. */
  QString reason;
  /** Whether the pointer is beside the surface. Then the user needs no message. */
  bool isMissed = false;
};

/**
 * Finds the point of a filter's surface under the pointer, and the filter's distance there. The
 * server finds where the ray from the camera meets the surface; what a view has drawn tells whether
 * something else is in front.
 */
class SurfaceProbe
{
public:
  SurfaceProbe(vtkSMProxy* filter, const ShownSurface& surface);

  enum class Snap
  {
    ToSurface,
    ToMeshPoint
  };

  /**
   * How carefully to test whether something is in front. If only the server knows what a view
   * shows, it has to draw again for the test; a pick waits for that, a preview does not.
   */
  enum class Care
  {
    Preview,
    Pick
  };

  /**
   * What an array of points of the filter's output has at a place of the view; none where the
   * pointer is beside the surface or something is in front. NaN where the array has no value.
   */
  std::optional<double> valueAt(
    pqRenderView* view, const QPointF& place, const QByteArray& arrayName);
  Probed at(pqRenderView* view, const QPointF& place, Snap snap, Care care);
  /** The place where a view draws a point of the data; none if the point is behind the camera. */
  std::optional<QPointF> placeOf(pqRenderView* view, const Position& point) const;

private:
  std::optional<Position> ask(const Ray& ray, Snap snap);
  Ray rayThrough(pqRenderView* view, const QPointF& place) const;
  bool isCovered(pqRenderView* view, const QPointF& place, const Position& point, Care care) const;

  ShownSurface Surface;
  vtkSmartPointer<vtkSMProxy> Filter;
  /** Proxies SurfacePointPicker: one for the filter's input, and one for its output, as each keeps
   * the surface of its data. */
  vtkSmartPointer<vtkSMProxy> Picker;
  vtkSmartPointer<vtkSMProxy> Meter;
};

}

#endif
