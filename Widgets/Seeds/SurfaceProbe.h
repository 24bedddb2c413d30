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

/** What is under the pointer. */
struct Probed
{
  /** In the data's coordinates; empty where nothing can be picked. */
  std::optional<Position> point;
  /** Why nothing can be picked, for the user. */
  QString reason;
  /** The pointer is beside the surface, which nobody needs to be told. */
  bool isMissed = false;
};

/**
 * Finds the point of a filter's surface under the pointer. The surface is asked where it is, on the
 * server, with the line of sight; what a view has drawn tells whether something else is in front.
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
   * What a view shows may be known only by the server, which then has to draw again; a preview does
   * not wait for that.
   */
  enum class Care
  {
    Preview,
    Pick
  };

  Probed at(pqRenderView* view, const QPointF& place, Snap snap, Care care);
  /** Where a view draws a point of the data; nothing behind the camera. */
  std::optional<QPointF> placeOf(pqRenderView* view, const Position& point) const;

private:
  std::optional<Position> ask(const Ray& ray, Snap snap);
  bool isCovered(pqRenderView* view, const QPointF& place, const Position& point, Care care) const;

  ShownSurface Surface;
  /** The proxy SurfacePointPicker. */
  vtkSmartPointer<vtkSMProxy> Picker;
};

}

#endif
