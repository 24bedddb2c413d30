// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedPanel.h"

#include "ErrorNote.h"
#include "LiveUpdate.h"
#include "ResultRow.h"
#include "SeedHint.h"
#include "SeedMenu.h"
#include "SeedTableModel.h"
#include "SeedTableView.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace seeds
{
namespace
{

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
{
  this->Toggle = new QPushButton(targetIcon(role.color), tr("Pick %1").arg(role.plural()));
  this->Toggle->setObjectName("Pick");
  this->Toggle->setCheckable(true);
  this->Toggle->setToolTip(
    tr("Click on the surface in the 3D view to add a %1 there. The key P adds "
       "one at the pointer, Ctrl+P at a mesh point, also without this button.")
      .arg(role.name));
  this->Hint = new SeedHint(model, role, this);
  this->Hint->setObjectName("Hint");
  this->Error = new QLabel(this);
  this->Error->setObjectName("Error");
  this->Error->setWordWrap(true);
  this->Error->setVisible(false);
  // The Tab key goes from one to the next in the order in which they are made.
  this->Result = new ResultRow(this);
  this->Result->setObjectName("Result");
  this->Table = new SeedTableView(model, this);
  this->Table->setObjectName("Table");
  this->Menu = new SeedMenu(model, this->Table, role, this);
  this->Menu->setObjectName("Menu");
  QLayout* buttons = this->buildButtons();
  this->Live = new QCheckBox(tr("Live update"), this);
  this->Live->setObjectName("LiveUpdate");
  this->Live->setToolTip(
    tr("Compute and draw the result while a %1 is dragged. Until you tick or untick it, it "
       "is on if the last run took less than 50 ms.")
      .arg(role.name));

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2, 2, 2, 2);
  column->setSpacing(3);
  column->addWidget(this->Toggle);
  column->addWidget(this->Hint);
  // Above the table the result is seen without scrolling.
  column->addWidget(this->Error);
  column->addWidget(this->Result);
  column->addWidget(this->Table);
  column->addLayout(buttons);
  column->addWidget(this->Live);

  this->connect(this->Toggle, &QPushButton::toggled, this->Hint, &SeedHint::setPicking);
  this->connect(this->Toggle, &QPushButton::toggled, this, &SeedPanel::pickToggled);
  for (const auto signal : { &QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved })
  {
    this->connect(model, signal, this, &SeedPanel::updateButtons);
  }
  this->connect(this->Table, &SeedTableView::chosenRowsChanged, this, &SeedPanel::updateButtons);
  this->connect(this->Live, &QCheckBox::clicked, this, &LiveUpdate::setWanted);
  this->connect(this->Table, &SeedTableView::refused, this->Hint, &SeedHint::complain);
  this->connect(this->Menu, &SeedMenu::refused, this->Hint, &SeedHint::complain);
  this->updateButtons();
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
    this->addButton(row, "Add", tr("Add a row with the middle of the input, and edit it"));
  add->setIcon(QIcon(":/QtWidgets/Icons/pqPlus.svg"));
  this->Remove = this->addButton(row, "Remove", tr("Remove the selected rows"));
  this->Remove->setIcon(QIcon(":/QtWidgets/Icons/pqMinus.svg"));
  this->Up = this->addButton(row, "Up", tr("Move the selected rows up"));
  this->Up->setArrowType(Qt::UpArrow);
  this->Down = this->addButton(row, "Down", tr("Move the selected rows down"));
  this->Down->setArrowType(Qt::DownArrow);
  this->Clear = this->addButton(row, "Clear", tr("Remove all rows"));
  this->Clear->setIcon(QIcon(":/QtWidgets/Icons/pqDelete.svg"));
  row->addStretch();
  QToolButton* more = this->addButton(row, "More", tr("Copy, paste, load, save and more"));
  more->setIcon(QIcon(":/QtWidgets/Icons/pqShowMenu.svg"));
  more->setPopupMode(QToolButton::InstantPopup);
  more->setMenu(this->Menu);

  this->connect(add, &QToolButton::clicked, this, &SeedPanel::addRequested);
  this->connect(this->Remove, &QToolButton::clicked, this->Table, &SeedTableView::remove);
  this->connect(this->Up, &QToolButton::clicked, this->Table, &SeedTableView::moveUp);
  this->connect(this->Down, &QToolButton::clicked, this->Table, &SeedTableView::moveDown);
  this->connect(this->Clear, &QToolButton::clicked, this->Model, &SeedTableModel::clear);
  return row;
}

void SeedPanel::showResult(const ResultNumbers& result)
{
  this->Result->setResult(result);
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

void SeedPanel::addRow(QWidget* row)
{
  this->layout()->addWidget(row);
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

void SeedPanel::updateButtons()
{
  const bool hasChosen = !this->Table->chosenRows().isEmpty();
  this->Remove->setEnabled(hasChosen);
  this->Up->setEnabled(hasChosen);
  this->Down->setEnabled(hasChosen);
  this->Clear->setEnabled(this->Model->rowCount() > 0);
}

}
