// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedPicker.h"

#include "ParaViewVersions.h"
#include "pqRenderView.h"
#include "vtkMatrix4x4.h"

#include <QApplication>
#include <QCursor>
#include <QKeyEvent>

namespace seeds
{
namespace
{

using Snap = SurfaceProbe::Snap;
using Care = SurfaceProbe::Care;

Snap snapOf(Qt::KeyboardModifiers modifiers)
{
  return modifiers & Qt::ControlModifier ? Snap::ToMeshPoint : Snap::ToSurface;
}

}

SeedPicker::SeedPicker(
  SurfaceProbe& probe, const PathProbe& path, pqRenderView* view, SeedOverlay* overlay)
  : Probe(probe)
  , Path(path)
  , View(view)
  , Overlay(overlay)
  , Widget(drawingWidgetOf(view))
{
  this->Widget->installEventFilter(this);
}

SeedPicker::~SeedPicker()
{
  this->setPicking(false);
}

void SeedPicker::setPicking(bool isOn)
{
  this->IsPicking = isOn;
  this->Held.reset();
  if (!this->Widget)
  {
    return;
  }
  if (isOn)
  {
    this->Widget->setCursor(Qt::CrossCursor);
    this->Widget->setFocus();
  }
  else
  {
    this->Widget->unsetCursor();
    this->forgetPreview();
  }
}

void SeedPicker::pickUnderPointer(Snap snap)
{
  const QPoint place = this->Widget->mapFromGlobal(QCursor::pos());
  if (this->Widget->rect().contains(place))
  {
    this->pick(place, snap);
  }
  else
  {
    Q_EMIT this->refused(tr("The pointer is not in the 3D view"));
  }
}

bool SeedPicker::eventFilter(QObject* object, QEvent* event)
{
  if (this->IsPassingOn || !this->View || !this->Overlay)
  {
    return false;
  }
  switch (event->type())
  {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return this->press(static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return this->move(static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return this->release(static_cast<QMouseEvent*>(event));
    case QEvent::Leave:
      this->forgetPreview();
      Q_EMIT this->pointedAway();
      return false;
    case QEvent::ShortcutOverride:
      // Otherwise ParaView's menu has the key, and there is no key press.
      if (this->IsUndoable && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Undo))
      {
        event->accept();
        return true;
      }
      return false;
    case QEvent::KeyPress:
      if (this->pressKey(static_cast<QKeyEvent*>(event)))
      {
        return true;
      }
      [[fallthrough]];
    case QEvent::KeyRelease:
    {
      auto* key = static_cast<QKeyEvent*>(event);
      if (this->IsPicking && key->key() == Qt::Key_Escape)
      {
        if (event->type() == QEvent::KeyPress)
        {
          Q_EMIT this->escaped();
        }
        return true;
      }
      if (this->IsPicking && (key->key() == Qt::Key_Control || key->key() == Qt::Key_Shift))
      {
        this->preview(
          this->Widget->mapFromGlobal(QCursor::pos()), QApplication::queryKeyboardModifiers());
      }
      return false;
    }
    default:
      return QObject::eventFilter(object, event);
  }
}

bool SeedPicker::pressKey(QKeyEvent* event)
{
  if (this->IsUndoable && event->matches(QKeySequence::Undo))
  {
    Q_EMIT this->undoRequested();
    return true;
  }
  if (event->key() == Qt::Key_Delete)
  {
    Q_EMIT this->deleteRequested();
    return true;
  }
  return false;
}

bool SeedPicker::press(QMouseEvent* event)
{
  if (event->button() != Qt::LeftButton)
  {
    this->forgetPreview();
    Q_EMIT this->pointedAway();
    return false;
  }
  const bool isRemoval = this->IsPicking && (event->modifiers() & Qt::ShiftModifier);
  const int row = isRemoval ? -1 : this->Overlay->rowAt(placeOf(*event));
  if (row >= 0)
  {
    this->DraggedRow = row;
    this->forgetPreview();
    Q_EMIT this->dragStarted(row);
    return true;
  }
  if (!this->IsPicking)
  {
    Q_EMIT this->pointedAway();
    return false;
  }
  // A click must not reach the view, which would draw the scene twice. The press of a drag is
  // passed on later.
  this->Held = copyOf(*event);
  return true;
}

bool SeedPicker::move(QMouseEvent* event)
{
  if (this->DraggedRow >= 0)
  {
    const auto probed =
      this->Probe.at(this->View, placeOf(*event), snapOf(event->modifiers()), Care::Preview);
    if (probed.point)
    {
      Q_EMIT this->dragged(this->DraggedRow, *probed.point);
    }
    Q_EMIT this->pointed(placeOf(*event));
    return true;
  }
  if (this->Held)
  {
    const QPointF moved = placeOf(*event) - placeOf(*this->Held);
    if (moved.manhattanLength() < QApplication::startDragDistance())
    {
      return true;
    }
    this->passPressOn();
  }
  else if (event->buttons() == Qt::NoButton)
  {
    this->preview(placeOf(*event), event->modifiers());
    Q_EMIT this->pointed(placeOf(*event));
  }
  return false;
}

bool SeedPicker::release(QMouseEvent* event)
{
  if (event->button() != Qt::LeftButton)
  {
    return false;
  }
  if (this->DraggedRow >= 0)
  {
    const int row = this->DraggedRow;
    this->DraggedRow = -1;
    Q_EMIT this->dragFinished(row);
    return true;
  }
  if (!this->Held)
  {
    return false;
  }
  const auto held = std::move(this->Held);
  const QPointF place = placeOf(*held);
  if (!(held->modifiers() & Qt::ShiftModifier))
  {
    this->pick(place, snapOf(held->modifiers()));
  }
  else if (const int row = this->Overlay->rowAt(place); row >= 0)
  {
    Q_EMIT this->removed(row);
  }
  return true;
}

void SeedPicker::passPressOn()
{
  const auto held = std::move(this->Held);
  this->forgetPreview();
  Q_EMIT this->pointedAway();
  this->IsPassingOn = true;
  QApplication::sendEvent(this->Widget, held.get());
  this->IsPassingOn = false;
}

void SeedPicker::pick(const QPointF& place, Snap snap)
{
  this->forgetPreview();
  const Probed probed = this->Probe.at(this->View, place, snap, Care::Pick);
  if (probed.point)
  {
    const auto onPath =
      snap == Snap::ToSurface ? this->Path.at(this->View, place, *probed.point) : std::nullopt;
    if (onPath)
    {
      Q_EMIT this->inserted(onPath->row, onPath->point);
    }
    else
    {
      Q_EMIT this->picked(*probed.point);
    }
    return;
  }
  this->Overlay->setPreview(Preview{ Preview::Refused, place, probed.reason });
  Q_EMIT this->refused(probed.reason);
}

void SeedPicker::preview(const QPointF& place, Qt::KeyboardModifiers modifiers)
{
  const bool isRemoval = this->IsPicking && (modifiers & Qt::ShiftModifier);
  const int row = this->Overlay->rowAt(place);
  this->Overlay->setDoomedRow(isRemoval ? row : -1);
  this->showHand(row >= 0 && !isRemoval);
  this->offer(row >= 0 && !isRemoval ? Offer{ Offer::Move, row } : Offer());
  if (row >= 0 || isRemoval || !this->IsPicking)
  {
    this->Overlay->setPreview({});
    return;
  }
  const Snap snap = snapOf(modifiers);
  const Probed probed = this->Probe.at(this->View, place, snap, Care::Preview);
  if (probed.isMissed)
  {
    this->Overlay->setPreview({});
    return;
  }
  if (!probed.point)
  {
    this->Overlay->setPreview(Preview{ Preview::Refused, place, probed.reason });
    return;
  }
  const auto onPath =
    snap == Snap::ToSurface ? this->Path.at(this->View, place, *probed.point) : std::nullopt;
  if (onPath)
  {
    this->offer({ Offer::Insert, onPath->row });
    this->Overlay->setPreview(Preview{
      Preview::OnPath, this->Probe.placeOf(this->View, onPath->point).value_or(place), {} });
    return;
  }
  const auto drawn = this->Probe.placeOf(this->View, *probed.point);
  this->Overlay->setPreview(
    Preview{ snap == Snap::ToMeshPoint ? Preview::AtMeshPoint : Preview::OnSurface,
      drawn.value_or(place), {} });
}

void SeedPicker::showHand(bool isOverMarker)
{
  if (isOverMarker == this->HasHand)
  {
    return;
  }
  this->HasHand = isOverMarker;
  if (isOverMarker)
  {
    this->Widget->setCursor(Qt::OpenHandCursor);
  }
  else if (this->IsPicking)
  {
    this->Widget->setCursor(Qt::CrossCursor);
  }
  else
  {
    this->Widget->unsetCursor();
  }
}

void SeedPicker::offer(const Offer& offer)
{
  if (!(offer == this->Offered))
  {
    this->Offered = offer;
    Q_EMIT this->offered(offer);
  }
}

void SeedPicker::forgetPreview()
{
  this->offer({});
  if (this->Overlay)
  {
    this->Overlay->setPreview({});
    this->Overlay->setDoomedRow(-1);
  }
}

}
