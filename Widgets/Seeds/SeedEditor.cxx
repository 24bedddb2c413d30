// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedEditor.h"

#include "SeedOverlay.h"
#include "SeedPanel.h"
#include "SeedPicker.h"
#include "SeedTableModel.h"
#include "SeedTableView.h"
#include "ShownSurface.h"

#include "pqRenderView.h"

namespace seeds
{

SeedEditor::SeedEditor(vtkSMProxy* filter, vtkSMDoubleVectorProperty* property,
  SeedTableModel& model, SeedPanel* panel, const ShownSurface& surface)
  : Model(model)
  , Panel(panel)
  , Surface(surface)
  , Live(filter, property)
{
  for (const auto signal : { &QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved })
  {
    this->connect(&model, signal, this, &SeedEditor::showUndo);
  }
  this->connect(&model, &QAbstractItemModel::dataChanged, this, &SeedEditor::showUndo);
}

void SeedEditor::follow(SeedPicker* picker, pqRenderView* view, SeedOverlay* overlay)
{
  this->Picker = picker;
  this->View = view;
  this->Overlay = overlay;
  this->connect(picker, &SeedPicker::picked, this, &SeedEditor::pick);
  this->connect(picker, &SeedPicker::inserted, this, &SeedEditor::insert);
  this->connect(
    picker, &SeedPicker::removed, this, [this](int row) { this->Model.removeRows({ row }); });
  this->connect(picker, &SeedPicker::deleteRequested, this->Panel->table(), &SeedTableView::remove);
  this->connect(picker, &SeedPicker::undoRequested, this, &SeedEditor::undoPick);
  this->connect(picker, &SeedPicker::dragStarted, this, &SeedEditor::startDrag);
  this->connect(picker, &SeedPicker::dragged, this, &SeedEditor::drag);
  this->connect(picker, &SeedPicker::dragFinished, this, &SeedEditor::finishDrag);
  this->connect(picker, &QObject::destroyed, &this->Live, &LiveUpdate::abandon);
}

void SeedEditor::pick(const Position& point)
{
  const QVector<double> before = this->Model.values();
  this->Panel->table()->append({ point });
  this->notePick(before);
}

void SeedEditor::insert(int row, const Position& point)
{
  const QVector<double> before = this->Model.values();
  this->Model.insert(row, point);
  this->Panel->table()->choose(row);
  this->notePick(before);
}

void SeedEditor::notePick(const QVector<double>& before)
{
  this->Picks.add(before, this->Model.values());
  this->showUndo();
}

void SeedEditor::showUndo()
{
  if (this->Picker)
  {
    this->Picker->setUndoable(this->Picks.canUndo(this->Model.values()));
  }
}

void SeedEditor::undoPick()
{
  this->Model.replace(this->Picks.undo());
  this->showUndo();
}

void SeedEditor::startDrag(int row)
{
  this->Panel->table()->choose(row);
  this->IsLive = this->Panel->isLive() && this->Live.isPossible();
  if (this->IsLive)
  {
    this->Live.begin(this->View, this->Overlay, this->Surface.thickness());
  }
}

void SeedEditor::drag(int row, const Position& point)
{
  // An undo during a drag can remove the row.
  if (row >= this->Model.numberOfPoints())
  {
    return;
  }
  this->Model.setPoint(row, point);
  if (this->IsLive)
  {
    this->Live.push(this->Model.values());
  }
  else
  {
    Q_EMIT this->moved();
  }
}

void SeedEditor::finishDrag()
{
  if (this->IsLive)
  {
    this->Live.finish();
  }
  else
  {
    Q_EMIT this->dropped();
  }
}

}
