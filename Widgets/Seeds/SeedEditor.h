// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedEditor_h
#define seeds_SeedEditor_h

#include "LiveUpdate.h"
#include "PickHistory.h"
#include "Position.h"

#include <QObject>
#include <QPointer>

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
 * Turns the gestures of a picker into changes of the points: picks, which Ctrl+Z takes back,
 * removals and drags, which the filter follows where the panel asks for that.
 */
class SeedEditor : public QObject
{
  Q_OBJECT

public:
  SeedEditor(vtkSMProxy* filter, vtkSMDoubleVectorProperty* property, SeedTableModel& model,
    SeedPanel* panel, const ShownSurface& surface);

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
  /** Lets Ctrl+Z take back what was just done to the table. */
  void notePick(const QVector<double>& before);
  /** Lets Ctrl+Z in the view take back the last pick if nothing has followed it. */
  void showUndo();
  void undoPick();
  void startDrag(int row);
  void drag(int row, const Position& point);
  void finishDrag();

  SeedTableModel& Model;
  SeedPanel* Panel;
  const ShownSurface& Surface;
  QPointer<pqRenderView> View;
  QPointer<SeedOverlay> Overlay;
  QPointer<SeedPicker> Picker;
  PickHistory Picks;
  LiveUpdate Live;
  bool IsLive = false;
};

}

#endif
