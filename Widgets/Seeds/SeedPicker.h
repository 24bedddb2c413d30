// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedPicker_h
#define seeds_SeedPicker_h

#include "PathProbe.h"
#include "SeedOverlay.h"
#include "SurfaceProbe.h"

#include <QMouseEvent>
#include <QObject>
#include <QPointer>

#include <memory>

class pqRenderView;

namespace seeds
{

/** What the mouse does at a place that is more than what it does everywhere. */
struct Offer
{
  enum Kind
  {
    Nothing,
    /** A click inserts a point on the path before a row. */
    Insert,
    /** A drag moves the point of a row. */
    Move
  };
  Kind kind = Nothing;
  int row = -1;

  bool operator==(const Offer& other) const
  {
    return this->kind == other.kind && this->row == other.row;
  }
};

/**
 * Turns mouse gestures in a render view into points. While picking is on, a click adds a point, on
 * the path between two points one between them, and a click with Shift removes one. A marker can
 * always be dragged. All other gestures reach the view.
 */
class SeedPicker : public QObject
{
  Q_OBJECT

public:
  SeedPicker(SurfaceProbe& probe, const PathProbe& path, pqRenderView* view, SeedOverlay* overlay);
  ~SeedPicker() override;

  void setPicking(bool isOn);
  /** Whether Ctrl+Z is this picker's; else it is ParaView's undo. */
  void setUndoable(bool isUndoable) { this->IsUndoable = isUndoable; }
  bool isPicking() const { return this->IsPicking; }
  /** Picks the point under the pointer. */
  void pickUnderPointer(SurfaceProbe::Snap snap);

Q_SIGNALS:
  void picked(const seeds::Position& point);
  /** A point of the path was picked, for a new row. */
  void inserted(int row, const seeds::Position& point);
  void removed(int row);
  void dragStarted(int row);
  void dragged(int row, const seeds::Position& point);
  void dragFinished(int row);
  /** What the mouse would do has changed. */
  void offered(const seeds::Offer& offer);
  /** The pointer moved over the view without turning the camera, or a marker with it. */
  void pointed(const QPointF& place);
  /** The pointer does something else now. */
  void pointedAway();
  /** Nothing was picked, for the given reason. */
  void refused(const QString& reason);
  /** The user pressed Escape to stop picking. */
  void escaped();
  /** The user pressed Delete in the view. */
  void deleteRequested();
  /** The user pressed Ctrl+Z in the view, while there is a pick to take back. */
  void undoRequested();

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  bool press(QMouseEvent* event);
  bool pressKey(QKeyEvent* event);
  bool move(QMouseEvent* event);
  bool release(QMouseEvent* event);
  void pick(const QPointF& place, SurfaceProbe::Snap snap);
  /** Shows what a click would do. */
  void preview(const QPointF& place, Qt::KeyboardModifiers modifiers);
  void forgetPreview();
  void offer(const Offer& offer);
  /**
   * Shows the hand cursor over a marker. The cursor is changed only when the pointer enters or
   * leaves a marker, because others set the cursor, too.
   */
  void showHand(bool isOverMarker);
  /** Gives the view the press that was held back, as the start of a drag in the view. */
  void passPressOn();

  SurfaceProbe& Probe;
  const PathProbe& Path;
  QPointer<pqRenderView> View;
  QPointer<SeedOverlay> Overlay;
  QPointer<QWidget> Widget;
  bool IsPicking = false;
  bool HasHand = false;
  bool IsUndoable = false;
  int DraggedRow = -1;
  Offer Offered;
  /** A press that may become a click. */
  std::unique_ptr<QMouseEvent> Held;
  bool IsPassingOn = false;
};

}

#endif
