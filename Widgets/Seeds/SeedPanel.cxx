// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedPanel.h"

#include "ErrorNote.h"
#include "LiveUpdate.h"
#include "PointText.h"
#include "SeedTableModel.h"
#include "SeedTableView.h"
#include "SelectedPositions.h"

#include "pqApplicationCore.h"
#include "pqFileDialog.h"
#include "pqPVApplicationCore.h"
#include "pqSelectionManager.h"
#include "pqSettings.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace seeds
{
namespace
{

constexpr const char* NumbersSetting = "SurfaceSeeds/ShowNumbers";
constexpr const char* LengthsSetting = "SurfaceSeeds/ShowLengths";
constexpr const char* DistanceSetting = "SurfaceSeeds/ShowDistanceAtPointer";

/** Makes an icon that looks like the preview at the pointer. */
QIcon targetIcon(const QColor& color)
{
  QPixmap pixmap(64, 64);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(color, 8.0));
  painter.drawEllipse(QPointF(32.0, 32.0), 25.0, 25.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawEllipse(QPointF(32.0, 32.0), 9.0, 9.0);
  return QIcon(pixmap);
}

}

SeedPanel::SeedPanel(SeedTableModel* model, const SeedRole& role, QWidget* parent)
  : QWidget(parent)
  , Model(model)
  , Role(role)
{
  this->Toggle = new QPushButton(targetIcon(role.color), tr("Pick %1").arg(role.plural()));
  this->Toggle->setObjectName("Pick");
  this->Toggle->setCheckable(true);
  this->Toggle->setToolTip(tr("Click on the surface in the 3D view to add a %1 there. Without this "
                              "button: P adds one at the pointer, Ctrl+P at a mesh point.")
                             .arg(role.name));
  this->Hint = new QLabel;
  this->Hint->setObjectName("Hint");
  this->Hint->setWordWrap(true);
  this->Table = new SeedTableView(model, this);
  this->Table->setObjectName("Table");

  this->Live = new QCheckBox(tr("Live update"), this);
  this->Live->setObjectName("LiveUpdate");
  this->Live->setToolTip(
    tr("Compute and draw the result while a %1 is dragged. Until you choose, it "
       "is on where the last run took less than 50 ms.")
      .arg(role.name));
  this->Error = new QLabel(this);
  this->Error->setObjectName("Error");
  this->Error->setWordWrap(true);
  this->Error->setVisible(false);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2, 2, 2, 2);
  column->setSpacing(3);
  column->addWidget(this->Toggle);
  column->addWidget(this->Hint);
  column->addWidget(this->Table);
  column->addLayout(this->buildButtons());
  column->addWidget(this->Live);
  column->addWidget(this->Error);
  column->addLayout(this->buildResult());

  this->connect(this->Toggle, &QPushButton::toggled, this,
    [this](bool isOn)
    {
      this->showHint();
      Q_EMIT this->pickToggled(isOn);
    });
  for (const auto signal : { &QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved })
  {
    this->connect(model, signal, this, &SeedPanel::updateButtons);
  }
  this->connect(model, &QAbstractItemModel::dataChanged, this, &SeedPanel::showHint);
  this->connect(model, &QAbstractItemModel::rowsRemoved, this, &SeedPanel::showHint);
  this->connect(this->Table, &SeedTableView::chosenRowsChanged, this, &SeedPanel::updateButtons);
  this->connect(this->Live, &QCheckBox::clicked, this, &LiveUpdate::setWanted);
  this->connect(this->Table, &SeedTableView::refused, this, &SeedPanel::complain);
  this->updateButtons();
  this->showHint();
}

QToolButton* SeedPanel::addButton(QHBoxLayout* row, const char* name, const QString& tip)
{
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setAutoRaise(true);
  row->addWidget(button);
  return button;
}

QLayout* SeedPanel::buildButtons()
{
  auto* row = new QHBoxLayout;
  row->setSpacing(1);
  QToolButton* add =
    this->addButton(row, "Add", tr("Add a row, at the middle of the input, and edit it"));
  add->setIcon(QIcon(":/QtWidgets/Icons/pqPlus.svg"));
  this->Remove = this->addButton(row, "Remove", tr("Remove the chosen rows"));
  this->Remove->setIcon(QIcon(":/QtWidgets/Icons/pqMinus.svg"));
  this->Up = this->addButton(row, "Up", tr("Move the chosen rows up"));
  this->Up->setArrowType(Qt::UpArrow);
  this->Down = this->addButton(row, "Down", tr("Move the chosen rows down"));
  this->Down->setArrowType(Qt::DownArrow);
  this->Clear = this->addButton(row, "Clear", tr("Remove all rows"));
  this->Clear->setIcon(QIcon(":/QtWidgets/Icons/pqDelete.svg"));
  row->addStretch();
  QToolButton* more = this->addButton(row, "More", tr("Copy, paste, load, save and more"));
  more->setIcon(QIcon(":/QtWidgets/Icons/pqShowMenu.svg"));
  more->setPopupMode(QToolButton::InstantPopup);
  more->setMenu(this->buildMenu());

  this->connect(add, &QToolButton::clicked, this, &SeedPanel::addRequested);
  this->connect(this->Remove, &QToolButton::clicked, this->Table, &SeedTableView::remove);
  this->connect(this->Up, &QToolButton::clicked, this->Table, &SeedTableView::moveUp);
  this->connect(this->Down, &QToolButton::clicked, this->Table, &SeedTableView::moveDown);
  this->connect(this->Clear, &QToolButton::clicked, this->Model, &SeedTableModel::clear);
  return row;
}

QAction* SeedPanel::addAction(QMenu* menu, const char* name, const QString& text)
{
  QAction* action = menu->addAction(text);
  action->setObjectName(name);
  return action;
}

QAction* SeedPanel::addChoice(
  QMenu* menu, const char* name, const char* setting, const QString& text)
{
  QAction* choice = this->addAction(menu, name, text);
  choice->setCheckable(true);
  choice->setChecked(pqApplicationCore::instance()->settings()->value(setting, false).toBool());
  this->connect(choice, &QAction::toggled, this,
    [setting](bool isOn) { pqApplicationCore::instance()->settings()->setValue(setting, isOn); });
  return choice;
}

QLayout* SeedPanel::buildResult()
{
  auto* row = new QHBoxLayout;
  this->ResultText = new QLabel(this);
  this->ResultText->setObjectName("Result");
  this->ResultText->setWordWrap(true);
  this->ResultText->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addWidget(this->ResultText, 1);
  this->CopyResult = this->addButton(row, "CopyResult", tr("Copy the result with all its digits"));
  this->CopyResult->setText(tr("Copy"));
  this->connect(this->CopyResult, &QToolButton::clicked, this,
    [this] { QApplication::clipboard()->setText(this->Result.text()); });
  this->showResult({});
  return row;
}

void SeedPanel::showResult(const ResultNumbers& result)
{
  this->Result = result;
  this->ResultText->setText(QString("<b>%1</b>").arg(result.summary.toHtmlEscaped()));
  this->ResultText->setVisible(!result.summary.isEmpty());
  this->CopyResult->setVisible(!result.summary.isEmpty());
  this->showError({});
}

void SeedPanel::showError(const QString& error)
{
  this->Error->setStyleSheet(ErrorNote::styleFor(this));
  this->Error->setText(QString("<b>%1</b>").arg(error.toHtmlEscaped()));
  this->Error->setVisible(!error.isEmpty());
}

void SeedPanel::showLive(bool isLive)
{
  this->Live->setChecked(isLive);
}

bool SeedPanel::isLive() const
{
  return this->Live->isChecked();
}

void SeedPanel::setOthers(const QString& others)
{
  this->Others = others;
  this->showHint();
}

void SeedPanel::addRow(QWidget* row)
{
  this->layout()->addWidget(row);
}

bool SeedPanel::hasLengthsInView() const
{
  return this->LengthsInView->isChecked();
}

bool SeedPanel::hasDistanceAtPointer() const
{
  return this->DistanceAtPointer->isVisible() && this->DistanceAtPointer->isChecked();
}

QMenu* SeedPanel::buildMenu()
{
  auto* menu = new QMenu(this);
  menu->setObjectName("Menu");
  this->Copy = this->addAction(menu, "Copy", tr("Copy"));
  QAction* paste = this->addAction(menu, "Paste", tr("Paste"));
  menu->addSeparator();
  QAction* load = this->addAction(menu, "Load", tr("Load CSV..."));
  this->Save = this->addAction(menu, "Save", tr("Save CSV..."));
  menu->addSeparator();
  this->FromSelection = this->addAction(menu, "FromSelection", tr("From Selection"));
  menu->addSeparator();
  this->Numbers = this->addChoice(menu, "Numbers", NumbersSetting, tr("Show Numbers"));
  this->LengthsInView =
    this->addChoice(menu, "Lengths", LengthsSetting, tr("Show Lengths In View"));
  this->DistanceAtPointer =
    this->addChoice(menu, "DistanceAtPointer", DistanceSetting, tr("Show Distance At Pointer"));
  this->DistanceAtPointer->setVisible(!this->Role.distances.isEmpty());

  this->connect(this->Copy, &QAction::triggered, this->Table, &SeedTableView::copy);
  this->connect(paste, &QAction::triggered, this->Table, &SeedTableView::paste);
  this->connect(load, &QAction::triggered, this, &SeedPanel::load);
  this->connect(this->Save, &QAction::triggered, this, &SeedPanel::save);
  this->connect(this->FromSelection, &QAction::triggered, this, &SeedPanel::addFromSelection);
  this->connect(this->Numbers, &QAction::toggled, this, &SeedPanel::numbersToggled);
  this->connect(this->LengthsInView, &QAction::toggled, this, &SeedPanel::lengthsToggled);
  this->connect(
    this->DistanceAtPointer, &QAction::toggled, this, &SeedPanel::distanceAtPointerToggled);
  this->connect(menu, &QMenu::aboutToShow, this, &SeedPanel::prepareMenu);
  return menu;
}

void SeedPanel::prepareMenu()
{
  this->FromSelection->setEnabled(
    pqPVApplicationCore::instance()->selectionManager()->hasActiveSelection());
}

bool SeedPanel::isPicking() const
{
  return this->Toggle->isChecked();
}

void SeedPanel::setPicking(bool isOn)
{
  this->Toggle->setChecked(isOn);
}

void SeedPanel::setPickable(bool isPickable)
{
  this->Toggle->setEnabled(isPickable);
}

bool SeedPanel::isNumbered() const
{
  return this->Numbers->isChecked();
}

void SeedPanel::updateButtons()
{
  const bool hasRows = this->Model->rowCount() > 0;
  const bool hasChosen = !this->Table->chosenRows().isEmpty();
  this->Remove->setEnabled(hasChosen);
  this->Up->setEnabled(hasChosen);
  this->Down->setEnabled(hasChosen);
  this->Clear->setEnabled(hasRows);
  this->Copy->setEnabled(hasRows);
  this->Save->setEnabled(hasRows);
}

void SeedPanel::setOffer(const Offer& offer)
{
  this->AtPointer = offer;
  this->showHint();
}

void SeedPanel::showHint()
{
  this->Hint->setText(this->hintText());
  // What is below must not jump while the pointer moves over points and paths.
  const int height = this->Hint->heightForWidth(this->Hint->width());
  this->Hint->setMinimumHeight(
    this->isPicking() ? std::max(height, this->Hint->minimumHeight()) : 0);
}

QString SeedPanel::hintText() const
{
  const int row = this->AtPointer.row;
  if (this->AtPointer.kind == Offer::Insert)
  {
    const int next = row < this->Model->numberOfPoints() ? row : 0;
    return tr("<b>Click</b>: insert a %1 between %2 and %3.")
      .arg(this->Role.name)
      .arg(row - 1)
      .arg(next);
  }
  if (this->AtPointer.kind == Offer::Move)
  {
    return (this->isPicking() ? tr("<b>Drag</b>: move %1 %2. <b>Shift+click</b>: remove it.")
                              : tr("<b>Drag</b>: move %1 %2. <b>Click, Delete</b>: remove it."))
      .arg(this->Role.name)
      .arg(row);
  }
  if (this->isPicking())
  {
    return tr("<b>Click</b>: add. <b>Ctrl+click</b>: at a mesh point. <b>Shift+click</b>: remove. "
              "<b>Ctrl+Z</b>: take the last back. <b>Esc</b>: end.");
  }
  if (this->Model->rowCount() == 0)
  {
    return this->Others.isEmpty()
      ? tr("No %1 picked yet: press <b>Pick %2</b>, then click on the surface.")
          .arg(this->Role.name, this->Role.plural())
      : tr("What counts: %1.").arg(this->Others.toHtmlEscaped());
  }
  const QString drag = tr("Drag a %1 in the view to move it.").arg(this->Role.name);
  return this->Others.isEmpty() ? drag : tr("%1 Also: %2.").arg(drag, this->Others.toHtmlEscaped());
}

void SeedPanel::complain(const QString& reason)
{
  this->Hint->setText(QString("<b>%1</b>").arg(reason.toHtmlEscaped()));
}

void SeedPanel::append(const QVector<Position>& points)
{
  const int first = this->Model->numberOfPoints();
  this->Model->append(points);
  this->Table->choose(first, points.size());
}

void SeedPanel::addFromSelection()
{
  const QVector<Position> points = selectedPositions();
  if (points.isEmpty())
  {
    this->complain(tr("Nothing is selected."));
    return;
  }
  this->append(points);
}

void SeedPanel::load()
{
  pqFileDialog dialog(nullptr, this, tr("Load %1").arg(this->Role.plural()), QString(),
    tr("Points as text (*.csv *.txt *.xyz);;All files (*)"));
  dialog.setObjectName("LoadPoints");
  dialog.setFileMode(pqFileDialog::ExistingFile);
  if (dialog.exec() != QDialog::Accepted)
  {
    return;
  }
  QFile file(dialog.getSelectedFiles().front());
  if (!file.open(QIODevice::ReadOnly))
  {
    this->complain(tr("%1: %2").arg(file.fileName(), file.errorString()));
    return;
  }
  const PointsFromText loaded = pointsFromText(QString::fromUtf8(file.readAll()));
  if (!loaded.error.isEmpty())
  {
    this->complain(loaded.error);
    return;
  }
  this->append(loaded.points);
}

void SeedPanel::save()
{
  pqFileDialog dialog(nullptr, this, tr("Save %1").arg(this->Role.plural()), QString(),
    tr("Points as text (*.csv);;All files (*)"));
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
    this->complain(tr("%1: %2").arg(file.fileName(), file.errorString()));
  }
}

}
