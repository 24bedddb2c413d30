// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedOverlay_h
#define seeds_SeedOverlay_h

#include "Position.h"
#include "SeedRole.h"

#include <QImage>
#include <QPainterPath>
#include <QPen>
#include <QPointer>
#include <QSet>
#include <QStringList>
#include <QVector>
#include <QWidget>

#include <optional>

class pqRenderView;

namespace seeds
{

/** What a click at the pointer would do. */
struct Preview
{
  enum Kind
  {
    OnSurface,
    AtMeshPoint,
    OnPath,
    Refused
  };
  Kind kind;
  /**
   * The place of the picked point or, if the pick is refused, of the pointer; in the widget's
   * pixels.
   */
  QPointF place;
  /** Why the pick is refused. */
  QString reason;
};

/**
 * Draws points over a render view, in screen pixels.
 *
 * The markers are drawn by a widget and not by actors in the view, so that they can move without
 * drawing the scene again. That takes a tenth of a second and more for large surfaces without a
 * graphics card. Therefore the markers are not in the view's screenshots.
 */
class SeedOverlay : public QWidget
{
  Q_OBJECT
  Q_PROPERTY(QString note READ note)

public:
  SeedOverlay(pqRenderView* view, const SeedRole& role);

  /**
   * @param points     in the coordinates of the view, one for each row
   * @param thickness  how far a point can be behind a drawn surface and still count as visible
   */
  void setPoints(const QVector<Position>& points, double thickness);
  void setChosenRows(const QVector<int>& rows);
  void setNumbered(bool isNumbered);
  /** Writes texts at points in the coordinates of the view, where nothing is in front of them. */
  void setLabels(const QVector<Position>& points, const QStringList& texts);
  /** Writes a text beside the pointer; an empty one for none. */
  void setNote(const QString& text, const QPointF& place);
  QString note() const { return this->Note; }
  void setJoined(bool isJoined);
  /**
   * Draws lines, in the widget's pixels, below all markers; none if empty.
   * @param width  in pixels of the render window
   */
  void setSketch(const QPainterPath& lines, const QColor& color, double width);
  /** Draws a picture over all of the view, below all else; none if null. */
  void setPicture(const QImage& picture);
  void setPreview(const std::optional<Preview>& preview);
  /** Sets the row that a click would remove; -1 for none. */
  void setDoomedRow(int row);

  /**
   * The row of the marker at a place of the widget, that of the marker nearest to the camera if
   * there are several; -1 for none. A marker behind something is drawn faintly and is not returned.
   */
  int rowAt(const QPointF& place) const;

protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  /** The marker of a point, as the camera sees it now. */
  struct Marker
  {
    /** None if the point is behind the camera. */
    std::optional<QPointF> place;
    bool isCovered = false;
  };

  void place();
  QRectF rectOf(const Preview& preview) const;
  QRectF rectOfNote() const;
  void drawLines(QPainter& painter) const;
  void drawMarker(QPainter& painter, int row) const;
  void drawLabels(QPainter& painter) const;
  void drawNote(QPainter& painter) const;
  void drawPreview(QPainter& painter) const;

  QPointer<pqRenderView> View;
  SeedRole Role;
  QVector<Position> Points;
  double Thickness = 0.0;
  QVector<Marker> Markers;
  QVector<Position> LabelPoints;
  QStringList LabelTexts;
  QVector<Marker> LabelPlaces;
  QVector<int> ChosenRows;
  bool IsNumbered = false;
  bool IsJoined = false;
  int DoomedRow = -1;
  std::optional<Preview> Shown;
  QString Note;
  QPointF NotePlace;
  QImage Picture;
  QPainterPath Sketch;
  QPen SketchPen;
};

}

#endif
