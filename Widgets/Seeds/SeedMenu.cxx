// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedMenu.h"

#include "PointText.h"
#include "SeedTableModel.h"
#include "SeedTableView.h"
#include "SelectedPositions.h"

#include "pqApplicationCore.h"
#include "pqFileDialog.h"
#include "pqPVApplicationCore.h"
#include "pqSelectionManager.h"
#include "pqSettings.h"

#include <QFile>

namespace seeds
{
namespace
{

constexpr const char* NumbersSetting = "SurfaceSeeds/ShowNumbers";
constexpr const char* LengthsSetting = "SurfaceSeeds/ShowLengths";
constexpr const char* DistanceSetting = "SurfaceSeeds/ShowDistanceAtPointer";

}

SeedMenu::SeedMenu(
  SeedTableModel* model, SeedTableView* table, const SeedRole& role, QWidget* parent)
  : QMenu(parent)
  , Model(model)
  , Table(table)
  , Role(role)
{
  this->Copy = this->add("Copy", tr("Copy"));
  QAction* paste = this->add("Paste", tr("Paste"));
  this->addSeparator();
  QAction* load = this->add("Load", tr("Load CSV..."));
  this->Save = this->add("Save", tr("Save CSV..."));
  this->addSeparator();
  this->FromSelection = this->add("FromSelection", tr("From Selection"));
  this->addSeparator();
  this->Numbers = this->addChoice("Numbers", NumbersSetting, tr("Show Numbers"));
  this->Lengths = this->addChoice("Lengths", LengthsSetting, tr("Show Lengths In View"));
  this->DistanceAtPointer =
    this->addChoice("DistanceAtPointer", DistanceSetting, tr("Show Distance At Pointer"));
  this->DistanceAtPointer->setVisible(!role.distances.isEmpty());

  this->connect(this->Copy, &QAction::triggered, table, &SeedTableView::copy);
  this->connect(paste, &QAction::triggered, table, &SeedTableView::paste);
  this->connect(load, &QAction::triggered, this, &SeedMenu::load);
  this->connect(this->Save, &QAction::triggered, this, &SeedMenu::save);
  this->connect(this->FromSelection, &QAction::triggered, this, &SeedMenu::addFromSelection);
  this->connect(this->Numbers, &QAction::toggled, this, &SeedMenu::numbersToggled);
  this->connect(this->Lengths, &QAction::toggled, this, &SeedMenu::lengthsToggled);
  this->connect(
    this->DistanceAtPointer, &QAction::toggled, this, &SeedMenu::distanceAtPointerToggled);
  this->connect(this, &QMenu::aboutToShow, this, &SeedMenu::enable);
}

bool SeedMenu::isNumbered() const
{
  return this->Numbers->isChecked();
}

bool SeedMenu::hasLengths() const
{
  return this->Lengths->isChecked();
}

bool SeedMenu::hasDistanceAtPointer() const
{
  return this->DistanceAtPointer->isVisible() && this->DistanceAtPointer->isChecked();
}

QAction* SeedMenu::add(const char* name, const QString& text)
{
  QAction* action = this->addAction(text);
  action->setObjectName(name);
  return action;
}

QAction* SeedMenu::addChoice(const char* name, const char* setting, const QString& text)
{
  QAction* choice = this->add(name, text);
  choice->setCheckable(true);
  choice->setChecked(pqApplicationCore::instance()->settings()->value(setting, false).toBool());
  this->connect(choice, &QAction::toggled, this,
    [setting](bool isOn) { pqApplicationCore::instance()->settings()->setValue(setting, isOn); });
  return choice;
}

void SeedMenu::enable()
{
  const bool hasRows = this->Model->rowCount() > 0;
  this->Copy->setEnabled(hasRows);
  this->Save->setEnabled(hasRows);
  this->FromSelection->setEnabled(
    pqPVApplicationCore::instance()->selectionManager()->hasActiveSelection());
}

void SeedMenu::addFromSelection()
{
  const QVector<Position> points = selectedPositions();
  if (points.isEmpty())
  {
    Q_EMIT this->refused(tr("Nothing is selected."));
    return;
  }
  this->Table->append(points);
}

void SeedMenu::load()
{
  pqFileDialog dialog(nullptr, this->parentWidget(), tr("Load %1").arg(this->Role.plural()),
    QString(), tr("Points as text (*.csv *.txt *.xyz);;All files (*)"));
  dialog.setObjectName("LoadPoints");
  dialog.setFileMode(pqFileDialog::ExistingFile);
  if (dialog.exec() != QDialog::Accepted)
  {
    return;
  }
  QFile file(dialog.getSelectedFiles().front());
  if (!file.open(QIODevice::ReadOnly))
  {
    Q_EMIT this->refused(tr("%1: %2").arg(file.fileName(), file.errorString()));
    return;
  }
  const PointsFromText loaded = pointsFromText(QString::fromUtf8(file.readAll()));
  if (!loaded.error.isEmpty())
  {
    Q_EMIT this->refused(loaded.error);
    return;
  }
  this->Table->append(loaded.points);
}

void SeedMenu::save()
{
  pqFileDialog dialog(nullptr, this->parentWidget(), tr("Save %1").arg(this->Role.plural()),
    QString(), tr("Points as text (*.csv);;All files (*)"));
  dialog.setObjectName("SavePoints");
  dialog.setFileMode(pqFileDialog::AnyFile);
  if (dialog.exec() != QDialog::Accepted)
  {
    return;
  }
  QFile file(dialog.getSelectedFiles().front());
  const QByteArray text = textFromPoints(this->Model->points()).toUtf8();
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.flush())
  {
    Q_EMIT this->refused(tr("%1: %2").arg(file.fileName(), file.errorString()));
  }
}

}
