// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedOverlay_h
#define seeds_SeedOverlay_h

#include "Position.h"
#include "SeedRole.h"

#include <QPointer>
#include <QSet>
#include <QVector>
#include <QWidget>

#include <optional>

class pqRenderView;

namespace seeds
{

/** What the pointer would do. */
struct Preview
{
  enum Kind
  {
    OnSurface,
    AtMeshPoint,
    Refused
  };
  Kind kind;
  /** Of the pick, or, where it is refused, of the pointer; in pixels of the widget. */
  QPointF place;
  /** Why it is refused. */
  QString reason;
};

/**
 * Draws points over a render view, in screen pixels.
 *
 * A widget of its own and not actors in the view, because then a marker moves without the scene
 * being drawn again, which takes a tenth of a second and more on large surfaces without a graphics
 * card. So the markers are not in the view's screenshots.
 */
class SeedOverlay : public QWidget
{
  Q_OBJECT

public:
  SeedOverlay(pqRenderView* view, const SeedRole& role);

  /**
   * @param points     in the space of the view, by rows
   * @param thickness  how far behind what is drawn a point is still seen
   */
  void setPoints(const QVector<Position>& points, double thickness);
  void setChosenRows(const QVector<int>& rows);
  void setNumbered(bool isNumbered);
  void setJoined(bool isJoined);
  void setPreview(const std::optional<Preview>& preview);
  /** The row that a click would remove, -1 for none. */
  void setDoomedRow(int row);

  /**
   * The row of the marker at a place of the widget, the nearest to the camera; -1 for none. One
   * that is behind something is seen faintly, but not there to be taken.
   */
  int rowAt(const QPointF& place) const;

protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  /** A point as the camera now sees it. */
  struct Marker
  {
    /** Nothing behind the camera. */
    std::optional<QPointF> place;
    bool isCovered = false;
  };

  void place();
  QRectF rectOf(const Preview& preview) const;
  void drawLines(QPainter& painter) const;
  void drawMarker(QPainter& painter, int row) const;
  void drawPreview(QPainter& painter) const;

  QPointer<pqRenderView> View;
  SeedRole Role;
  QVector<Position> Points;
  double Thickness = 0.0;
  QVector<Marker> Markers;
  QVector<int> ChosenRows;
  bool IsNumbered = false;
  bool IsJoined = false;
  int DoomedRow = -1;
  std::optional<Preview> Shown;
};

}

#endif
