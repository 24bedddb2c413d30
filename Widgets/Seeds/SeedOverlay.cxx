// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedOverlay.h"

#include "ViewGeometry.h"

#include "pqRenderView.h"
#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkSMRenderViewProxy.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <limits>

namespace seeds
{
namespace
{

// All lengths are in Qt's pixels, which grow with the screen's scale.
constexpr double Radius = 5.5;
constexpr double ChosenRadius = 7.5;
constexpr double Reach = 9.0;
constexpr double PreviewRadius = 8.0;
constexpr double CoveredOpacity = 0.35;

const QColor Dark(20, 20, 20);
const QColor Light(255, 255, 255);
const QColor Refusal(190, 20, 20);

/** Draws text that is legible on any background. */
void drawOutlined(QPainter& painter, const QPointF& baseline, const QString& text)
{
  QPainterPath path;
  path.addText(baseline, painter.font(), text);
  painter.strokePath(path, QPen(Dark, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.fillPath(path, Light);
}

void drawDisc(QPainter& painter, const QPointF& center, double radius, const QColor& color)
{
  painter.setPen(QPen(Dark, 1.0));
  painter.setBrush(Light);
  painter.drawEllipse(center, radius, radius);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawEllipse(center, radius - 2.0, radius - 2.0);
}

/** Draws lines that are legible on any background. */
void drawRimmed(QPainter& painter, const QPainterPath& path, const QColor& color)
{
  const std::pair<QColor, double> strokes[] = { { Dark, 6.0 }, { Light, 5.0 }, { color, 2.5 } };
  for (const auto& [stroke, width] : strokes)
  {
    painter.strokePath(path, QPen(stroke, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  }
}

}

SeedOverlay::SeedOverlay(pqRenderView* view, const SeedRole& role)
  : QWidget(drawingWidgetOf(view))
  , View(view)
  , Role(role)
{
  this->setObjectName("SeedOverlay");
  this->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->setAttribute(Qt::WA_NoSystemBackground);
  this->parentWidget()->installEventFilter(this);
  this->resize(this->parentWidget()->size());
  this->connect(view, &pqView::endRender, this, &SeedOverlay::place);
  this->show();
}

void SeedOverlay::setPoints(const QVector<Position>& points, double thickness)
{
  this->Points = points;
  this->Thickness = thickness;
  this->DoomedRow = -1;
  this->place();
}

void SeedOverlay::place()
{
  if (!this->View)
  {
    return;
  }
  const ViewGeometry geometry(this->View);
  this->Markers.clear();
  for (const Position& point : this->Points)
  {
    this->Markers.append({ geometry.toWidget(point), geometry.isCovered(point, this->Thickness) });
  }
  this->LabelPlaces.clear();
  for (const Position& point : this->LabelPoints)
  {
    this->LabelPlaces.append(
      { geometry.toWidget(point), geometry.isCovered(point, this->Thickness) });
  }
  this->update();
}

void SeedOverlay::setChosenRows(const QVector<int>& rows)
{
  this->ChosenRows = rows;
  this->update();
}

void SeedOverlay::setNumbered(bool isNumbered)
{
  this->IsNumbered = isNumbered;
  this->update();
}

void SeedOverlay::setLabels(const QVector<Position>& points, const QStringList& texts)
{
  this->LabelPoints = points;
  this->LabelTexts = texts;
  this->place();
}

void SeedOverlay::setJoined(bool isJoined)
{
  this->IsJoined = isJoined;
  this->update();
}

void SeedOverlay::setSketch(const QPainterPath& lines, const QColor& color, double width)
{
  this->Sketch = lines;
  const double points = this->View ? width / ViewGeometry(this->View).pixelsPerPoint() : width;
  this->SketchPen = QPen(color, points, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  this->update();
}

void SeedOverlay::setPicture(const QImage& picture)
{
  this->Picture = picture;
  // Markers of another panel are not hidden by it.
  this->lower();
  this->update();
}

void SeedOverlay::setDoomedRow(int row)
{
  if (row != this->DoomedRow)
  {
    this->DoomedRow = row;
    this->update();
  }
}

void SeedOverlay::setPreview(const std::optional<Preview>& preview)
{
  // Only the old and the new place are drawn again, because this is called for every movement of
  // the pointer.
  for (const auto& shown : { this->Shown, preview })
  {
    if (shown)
    {
      this->update(this->rectOf(*shown).toAlignedRect());
    }
  }
  this->Shown = preview;
}

void SeedOverlay::setNote(const QString& text, const QPointF& place)
{
  this->update(this->rectOfNote().toAlignedRect());
  this->Note = text;
  this->NotePlace = place;
  this->update(this->rectOfNote().toAlignedRect());
}

QRectF SeedOverlay::rectOfNote() const
{
  if (this->Note.isEmpty())
  {
    return {};
  }
  // To the right of the pointer and below it, but inside the view.
  const QFontMetrics metrics = this->fontMetrics();
  QRectF rect(this->NotePlace + QPointF(14.0, 14.0),
    QSizeF(metrics.horizontalAdvance(this->Note) + 6.0, metrics.height() + 4.0));
  rect.moveRight(std::min(rect.right(), this->width() - 2.0));
  rect.moveBottom(std::min(rect.bottom(), this->height() - 2.0));
  return rect;
}

QRectF SeedOverlay::rectOf(const Preview& preview) const
{
  const double size = PreviewRadius + 4.0;
  QRectF rect(preview.place - QPointF(size, size), QSizeF(2.0 * size, 2.0 * size));
  if (preview.kind == Preview::Refused)
  {
    rect.setRight(rect.right() + this->fontMetrics().horizontalAdvance(preview.reason) + 24.0);
    rect.setLeft(rect.left() - this->fontMetrics().horizontalAdvance(preview.reason) - 24.0);
    rect.adjust(0.0, -8.0, 0.0, 8.0);
  }
  return rect;
}

int SeedOverlay::rowAt(const QPointF& place) const
{
  vtkCamera* camera = this->View->getRenderViewProxy()->GetRenderer()->GetActiveCamera();
  Position ahead;
  camera->GetDirectionOfProjection(ahead.data());
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int row = 0; row < this->Markers.size(); ++row)
  {
    const Marker& marker = this->Markers[row];
    if (!marker.place || marker.isCovered)
    {
      continue;
    }
    const QPointF away = *marker.place - place;
    const double depth = dot(this->Points[row], ahead);
    if (QPointF::dotProduct(away, away) <= Reach * Reach && depth < least)
    {
      least = depth;
      nearest = row;
    }
  }
  return nearest;
}

bool SeedOverlay::eventFilter(QObject* object, QEvent* event)
{
  if (event->type() == QEvent::Resize)
  {
    this->resize(this->parentWidget()->size());
  }
  return QWidget::eventFilter(object, event);
}

void SeedOverlay::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.drawImage(QPoint(0, 0), this->Picture);
  painter.strokePath(this->Sketch, this->SketchPen);
  if (this->IsJoined)
  {
    this->drawLines(painter);
  }
  this->drawLabels(painter);
  // The chosen markers are drawn last, so that no other marker hides them.
  for (const bool isChosen : { false, true })
  {
    for (int row = 0; row < this->Markers.size(); ++row)
    {
      if (this->Markers[row].place && this->ChosenRows.contains(row) == isChosen)
      {
        this->drawMarker(painter, row);
      }
    }
  }
  if (this->Shown)
  {
    this->drawPreview(painter);
  }
  if (!this->Note.isEmpty())
  {
    this->drawNote(painter);
  }
}

void SeedOverlay::drawLines(QPainter& painter) const
{
  QPainterPath path;
  for (int row = 1; row < this->Markers.size(); ++row)
  {
    if (this->Markers[row - 1].place && this->Markers[row].place)
    {
      path.moveTo(*this->Markers[row - 1].place);
      path.lineTo(*this->Markers[row].place);
    }
  }
  drawRimmed(painter, path, this->Role.color);
}

void SeedOverlay::drawLabels(QPainter& painter) const
{
  for (int i = 0; i < this->LabelPlaces.size(); ++i)
  {
    const Marker& label = this->LabelPlaces[i];
    if (label.place && !label.isCovered)
    {
      drawOutlined(painter, *label.place + QPointF(6.0, -6.0), this->LabelTexts[i]);
    }
  }
}

void SeedOverlay::drawNote(QPainter& painter) const
{
  const QRectF rect = this->rectOfNote();
  drawOutlined(
    painter, { rect.left() + 3.0, rect.top() + 2.0 + this->fontMetrics().ascent() }, this->Note);
}

void SeedOverlay::drawMarker(QPainter& painter, int row) const
{
  const QPointF center = *this->Markers[row].place;
  const bool isChosen = this->ChosenRows.contains(row);
  painter.setOpacity(this->Markers[row].isCovered ? CoveredOpacity : 1.0);
  if (isChosen)
  {
    painter.setPen(QPen(Dark, 1.0));
    painter.setBrush(this->Role.color);
    painter.drawEllipse(center, ChosenRadius + 3.0, ChosenRadius + 3.0);
  }
  drawDisc(painter, center, isChosen ? ChosenRadius : Radius, this->Role.color);
  if (row == this->DoomedRow)
  {
    QPainterPath cross;
    cross.moveTo(center + QPointF(-Reach, -Reach));
    cross.lineTo(center + QPointF(Reach, Reach));
    cross.moveTo(center + QPointF(-Reach, Reach));
    cross.lineTo(center + QPointF(Reach, -Reach));
    drawRimmed(painter, cross, Refusal);
  }
  if (this->IsNumbered)
  {
    drawOutlined(painter, center + QPointF(ChosenRadius + 4.0, -4.0), QString::number(row));
  }
  painter.setOpacity(1.0);
}

void SeedOverlay::drawPreview(QPainter& painter) const
{
  const QPointF center = this->Shown->place;
  QPainterPath path;
  switch (this->Shown->kind)
  {
    case Preview::OnSurface:
      path.addEllipse(center, PreviewRadius, PreviewRadius);
      break;
    case Preview::AtMeshPoint:
      path.addRect(QRectF(center - QPointF(PreviewRadius, PreviewRadius),
        QSizeF(2.0 * PreviewRadius, 2.0 * PreviewRadius)));
      break;
    case Preview::OnPath:
      path.addEllipse(center, PreviewRadius, PreviewRadius);
      path.moveTo(center - QPointF(PreviewRadius, 0.0));
      path.lineTo(center + QPointF(PreviewRadius, 0.0));
      path.moveTo(center - QPointF(0.0, PreviewRadius));
      path.lineTo(center + QPointF(0.0, PreviewRadius));
      break;
    case Preview::Refused:
      path.addEllipse(center, PreviewRadius, PreviewRadius);
      path.moveTo(center + QPointF(-0.7, 0.7) * PreviewRadius);
      path.lineTo(center + QPointF(0.7, -0.7) * PreviewRadius);
      drawRimmed(painter, path, Refusal);
      const double width = this->fontMetrics().horizontalAdvance(this->Shown->reason);
      const bool hasRoom = center.x() + 16.0 + width < this->width();
      const double x = hasRoom ? center.x() + 16.0 : center.x() - 16.0 - width;
      drawOutlined(painter, { x, center.y() + 5.0 }, this->Shown->reason);
      return;
  }
  drawRimmed(painter, path, this->Role.color);
  painter.setPen(Qt::NoPen);
  painter.setBrush(this->Role.color);
  painter.drawEllipse(center, 2.0, 2.0);
}

}
