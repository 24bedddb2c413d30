// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_ViewGeometry_h
#define seeds_ViewGeometry_h

#include "Position.h"

#include <QPointF>
#include <QPointer>

#include <optional>

class QWidget;
class pqRenderView;
class vtkRenderer;

namespace seeds
{

struct Ray
{
  Position origin;
  Position direction;
};

/** Converts between places of a render view's widget and the space that the view shows. */
class ViewGeometry
{
public:
  explicit ViewGeometry(pqRenderView* view);

  /**
   * The place where a point in space is drawn, in Qt's pixels; none if the point is behind the
   * camera.
   */
  std::optional<QPointF> toWidget(const Position& point) const;
  /**
   * The ray from the camera through a place of the widget. It begins at the near clipping plane.
   */
  Ray rayThrough(const QPointF& place) const;
  /** Whether the view is drawn in this process; otherwise a server draws it. */
  bool isDrawnHere() const;
  /**
   * Whether what was drawn at a point's pixel is nearer to the camera than the point, by more than
   * a tolerance. Always false if a server draws, or nothing was drawn yet.
   */
  bool isCovered(const Position& point, double tolerance) const;
  /** The pixel of the render window at a place of the widget, counted from its lower left corner.
   */
  std::array<int, 2> pixelAt(const QPointF& place) const;

  /** How many pixels around one count as its neighbours where depths are compared. */
  static constexpr int DepthReach = 4;
  /** Pixels of the window for one of Qt's. */
  double pixelsPerPoint() const;

private:
  /** A point in space as pixels from the window's lower left corner, and depth from 0 to 1. */
  Position toWindow(const Position& point) const;
  /**
   * The depth of what was drawn at a pixel; 1 on the background. It is the farthest depth of 9 x 9
   * pixels, so that neither the slope of a surface counts as something in front of it nor a path of
   * 4 pixels on it, which is drawn a little in front.
   */
  double drawnDepth(const std::array<int, 2>& pixel) const;
  Position toSpace(double x, double y, double depth) const;
  int windowHeight() const;

  QPointer<pqRenderView> View;
  vtkRenderer* Renderer;
};

/** Returns the widget inside a render view that draws and receives mouse events. */
QWidget* drawingWidgetOf(pqRenderView* view);

}

#endif
