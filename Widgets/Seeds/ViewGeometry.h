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

/** How a render view's widget and the space that it shows belong together. */
class ViewGeometry
{
public:
  explicit ViewGeometry(pqRenderView* view);

  /** Where a point in space is drawn, in the pixels of Qt; nothing behind the camera. */
  std::optional<QPointF> toWidget(const Position& point) const;
  /** The line of sight through a place of the widget, from the near clipping plane. */
  Ray rayThrough(const QPointF& place) const;
  /** Whether what the view draws is known here; otherwise a server draws it. */
  bool isDrawnHere() const;
  /**
   * Whether a point in space is behind what was drawn over it, by more than a tolerance; never
   * where a server draws.
   */
  bool isCovered(const Position& point, double tolerance) const;
  /** The pixel of the render window at a place of the widget, counted from its lower left corner.
   */
  std::array<int, 2> pixelAt(const QPointF& place) const;

private:
  /** In pixels from the window's lower left corner, and depth from 0 to 1. */
  Position toWindow(const Position& point) const;
  /**
   * The depth of what was drawn, of 3 x 3 pixels the farthest, so that the slope of a surface does
   * not count as something in front of it; 1 on the background.
   */
  double drawnDepth(const std::array<int, 2>& pixel) const;
  Position toSpace(double x, double y, double depth) const;
  double pixelsPerPoint() const;
  int windowHeight() const;

  QPointer<pqRenderView> View;
  vtkRenderer* Renderer;
};

/** The widget inside of a render view that draws and gets the mouse. */
QWidget* drawingWidgetOf(pqRenderView* view);

}

#endif
