// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedEditor_h
#define seeds_SeedEditor_h

#include "EditHistory.h"
#include "LiveUpdate.h"
#include "Position.h"

#include <QObject>
#include <QPointer>
#include <QVector>

#include <functional>

class pqRenderView;
class vtkSMDoubleVectorProperty;
class vtkSMProxy;

namespace seeds
{

class SeedOverlay;
class SeedPanel;
class SeedPicker;
class SeedTableModel;
class ShownSurface;

/**
 * Turns the gestures of a picker into changes of the points: picks, removals and drags, which the
 * filter follows where the panel asks for that. Ctrl+Z in the view takes them back.
 */
class SeedEditor : public QObject
{
  Q_OBJECT

public:
  /** @param dragged  see LiveUpdate */
  SeedEditor(vtkSMProxy* filter, vtkSMDoubleVectorProperty* property, vtkSMProperty* dragged,
    SeedTableModel& model, SeedPanel* panel, const ShownSurface& surface);

  /** Follows a view's picker for as long as it lives. */
  void follow(SeedPicker* picker, pqRenderView* view, SeedOverlay* overlay);

Q_SIGNALS:
  /** A drag has moved a point, which the filter does not follow. */
  void moved();
  /** Such a drag has ended. */
  void dropped();

private:
  void pick(const Position& point);
  void insert(int row, const Position& point);
  /** Changes the table, and lets Ctrl+Z take that back. */
  void edit(const std::function<void()>& change);
  /** Lets Ctrl+Z in the view take back what was last done there, if nothing has followed it. */
  void showUndo();
  void undo();
  void beginLive();
  void startDrag(int row);
  void drag(int row, const Position& point);
  void finishDrag();

  SeedTableModel& Model;
  SeedPanel* Panel;
  const ShownSurface& Surface;
  QPointer<pqRenderView> View;
  QPointer<SeedOverlay> Overlay;
  QPointer<SeedPicker> Picker;
  EditHistory Edits;
  LiveUpdate Live;
  bool IsLive = false;
  QVector<double> BeforeDrag;
};

}

#endif
