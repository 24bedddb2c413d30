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
  vtkSMProperty* dragged, SeedTableModel& model, SeedPanel* panel, const ShownSurface& surface)
  : Model(model)
  , Panel(panel)
  , Surface(surface)
  , Live(filter, property, dragged)
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
  this->connect(picker, &SeedPicker::removed, this,
    [this](int row) { this->edit([this, row] { this->Model.removeRows({ row }); }); });
  this->connect(picker, &SeedPicker::deleteRequested, this,
    [this] { this->edit([this] { this->Panel->table()->remove(); }); });
  this->connect(picker, &SeedPicker::undoRequested, this, &SeedEditor::undo);
  this->connect(picker, &SeedPicker::dragStarted, this, &SeedEditor::startDrag);
  this->connect(picker, &SeedPicker::dragged, this, &SeedEditor::drag);
  this->connect(picker, &SeedPicker::dragFinished, this, &SeedEditor::finishDrag);
  this->connect(picker, &QObject::destroyed, &this->Live, &LiveUpdate::abandon);
}

void SeedEditor::pick(const Position& point)
{
  this->edit([&] { this->Panel->table()->append({ point }); });
}

void SeedEditor::insert(int row, const Position& point)
{
  this->edit(
    [&]
    {
      this->Model.insert(row, point);
      this->Panel->table()->choose(row);
    });
}

void SeedEditor::edit(const std::function<void()>& change)
{
  const QVector<double> before = this->Model.values();
  change();
  this->Edits.add({ before, this->Model.values(), false });
  this->showUndo();
}

void SeedEditor::showUndo()
{
  if (this->Picker)
  {
    this->Picker->setUndoable(this->Edits.canUndo(this->Model.values()));
  }
}

void SeedEditor::undo()
{
  const EditHistory::Edit edit = this->Edits.takeLast();
  this->Model.replace(edit.before);
  if (edit.isApplied && this->Live.isPossible())
  {
    this->beginLive();
    this->Live.push(edit.before);
    this->Live.finish();
  }
  this->showUndo();
}

void SeedEditor::beginLive()
{
  this->Live.begin(this->View, this->Overlay, this->Surface.thickness());
}

void SeedEditor::startDrag(int row)
{
  this->Panel->table()->choose(row);
  this->BeforeDrag = this->Model.values();
  this->IsLive = this->Panel->isLive() && this->Live.isPossible();
  if (this->IsLive)
  {
    this->beginLive();
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
  this->Edits.add({ this->BeforeDrag, this->Model.values(), this->IsLive });
  this->showUndo();
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
