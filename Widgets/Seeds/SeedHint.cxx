// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedHint.h"

#include "SeedTableModel.h"

#include <algorithm>

namespace seeds
{

SeedHint::SeedHint(const SeedTableModel* model, const SeedRole& role, QWidget* parent)
  : QLabel(parent)
  , Model(model)
  , Role(role)
{
  this->setWordWrap(true);
  this->connect(model, &QAbstractItemModel::dataChanged, this, &SeedHint::refresh);
  this->connect(model, &QAbstractItemModel::rowsRemoved, this, &SeedHint::refresh);
  this->refresh();
}

void SeedHint::setPicking(bool isPicking)
{
  this->IsPicking = isPicking;
  this->refresh();
}

void SeedHint::setOffer(const Offer& offer)
{
  this->AtPointer = offer;
  this->refresh();
}

void SeedHint::setOthers(const QString& others)
{
  this->Others = others;
  this->refresh();
}

void SeedHint::refresh()
{
  this->setText(this->whatToDo());
  // What is below must not jump while the pointer moves over points and paths.
  const int height = this->heightForWidth(this->width());
  this->setMinimumHeight(this->IsPicking ? std::max(height, this->minimumHeight()) : 0);
}

void SeedHint::complain(const QString& reason)
{
  this->setText(QString("<b>%1</b>").arg(reason.toHtmlEscaped()));
}

QString SeedHint::whatToDo() const
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
    return (this->IsPicking ? tr("<b>Drag</b>: move %1 %2. <b>Shift+click</b>: remove it.")
                            : tr("<b>Drag</b>: move %1 %2. <b>Click, Delete</b>: remove it."))
      .arg(this->Role.name)
      .arg(row);
  }
  if (this->IsPicking)
  {
    return tr("<b>Click</b>: add. <b>Ctrl+click</b>: at a mesh point. <b>Shift+click</b>: remove. "
              "<b>Ctrl+Z</b>: undo the last. <b>Esc</b>: end.");
  }
  if (this->Model->rowCount() == 0)
  {
    return this->Others.isEmpty()
      ? tr("No %1 picked yet: press <b>Pick %2</b>, then click on the surface.")
          .arg(this->Role.name, this->Role.plural())
      : tr("In use: %1.").arg(this->Others.toHtmlEscaped());
  }
  const QString drag = tr("Drag a %1 in the view to move it.").arg(this->Role.name);
  return this->Others.isEmpty() ? drag : tr("%1 Also: %2.").arg(drag, this->Others.toHtmlEscaped());
}

}
