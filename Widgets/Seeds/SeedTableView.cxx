// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedTableView.h"

#include "PointText.h"
#include "SeedTableModel.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QStyledItemDelegate>

#include <algorithm>

namespace seeds
{
namespace
{

constexpr int FewestRows = 3;
constexpr int MostRows = 8;
/** For the rounding of heights on scaled screens, which would cost a scroll bar. */
constexpr int Slack = 2;

/**
 * Shows a number with as many of its digits as there is room for, because an ellipsis would tell
 * nothing.
 */
class NumberDelegate : public QStyledItemDelegate
{
public:
  using QStyledItemDelegate::QStyledItemDelegate;

protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
  {
    QStyledItemDelegate::initStyleOption(option, index);
    const QVariant value = index.data(Qt::EditRole);
    const int margin = option->widget->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1;
    const int room = option->rect.width() - 2 * margin;
    bool isNumber = false;
    option->text.toDouble(&isNumber);
    for (int digits = MostDigits;
         isNumber && digits > 1 && option->fontMetrics.horizontalAdvance(option->text) > room;
         --digits)
    {
      option->text = QString::number(value.toDouble(), 'g', digits);
    }
  }

private:
  static constexpr int MostDigits = 5;
};

}

SeedTableView::SeedTableView(SeedTableModel* model, QWidget* parent)
  : QTableView(parent)
  , Model(model)
{
  this->setModel(model);
  this->setItemDelegate(new NumberDelegate(this));
  this->setSelectionBehavior(QAbstractItemView::SelectRows);
  // In the table the Tab key would never leave it. While a cell is edited it goes on to the next.
  this->setTabKeyNavigation(false);
  this->setDragDropMode(QAbstractItemView::InternalMove);
  this->setDragDropOverwriteMode(false);
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  this->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  // Else a moment of being narrow would leave a vertical one behind.
  this->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  this->horizontalHeader()->setHighlightSections(false);
  this->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  this->verticalHeader()->setDefaultSectionSize(this->fontMetrics().height() + 6);
  this->verticalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
  const auto resize = [this] { this->updateGeometry(); };
  this->connect(model, &QAbstractItemModel::rowsInserted, this, resize);
  this->connect(model, &QAbstractItemModel::rowsRemoved, this, resize);
  this->connect(model, &QAbstractItemModel::columnsInserted, this, resize);
  this->connect(model, &QAbstractItemModel::columnsInserted, this,
    [this]
    {
      this->selectionModel()->select(this->selectionModel()->selection(),
        QItemSelectionModel::Select | QItemSelectionModel::Rows);
    });
  this->connect(this->selectionModel(), &QItemSelectionModel::selectionChanged, this,
    &SeedTableView::chosenRowsChanged);
  this->connect(model, &SeedTableModel::rowsPlaced, this, &SeedTableView::choose);
}

QVector<int> SeedTableView::chosenRows() const
{
  QVector<int> rows;
  for (const QModelIndex& index : this->selectionModel()->selectedIndexes())
  {
    if (index.column() == 0)
    {
      rows.append(index.row());
    }
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

void SeedTableView::choose(int first, int count)
{
  const QModelIndex top = this->Model->index(first, 0);
  this->selectionModel()->setCurrentIndex(top, QItemSelectionModel::NoUpdate);
  this->selectionModel()->select(
    QItemSelection(top, this->Model->index(first + count - 1, this->Model->columnCount() - 1)),
    QItemSelectionModel::ClearAndSelect);
  this->scrollTo(top);
}

void SeedTableView::append(const QVector<Position>& points)
{
  const int first = this->Model->numberOfPoints();
  this->Model->append(points);
  this->choose(first, points.size());
}

QSize SeedTableView::sizeHint() const
{
  const int rows = std::clamp(this->Model->rowCount(), FewestRows, MostRows);
  return { this->verticalHeader()->sizeHint().width() +
      3 * this->fontMetrics().horizontalAdvance("0000"),
    this->horizontalHeader()->sizeHint().height() +
      rows * this->verticalHeader()->defaultSectionSize() + 2 * this->frameWidth() + Slack };
}

void SeedTableView::copy()
{
  const QVector<Position> points = this->Model->points();
  QVector<Position> chosen;
  for (const int row : this->chosenRows())
  {
    if (row < points.size())
    {
      chosen.append(points[row]);
    }
  }
  QApplication::clipboard()->setText(textFromPoints(chosen.isEmpty() ? points : chosen));
}

void SeedTableView::paste()
{
  const PointsFromText pasted = pointsFromText(QApplication::clipboard()->text());
  if (!pasted.error.isEmpty())
  {
    Q_EMIT this->refused(pasted.error);
    return;
  }
  this->append(pasted.points);
}

void SeedTableView::remove()
{
  const QVector<int> rows = this->chosenRows();
  if (rows.isEmpty())
  {
    return;
  }
  this->Model->removeRows(rows);
  this->clearSelection();
}

void SeedTableView::moveUp()
{
  const QVector<int> rows = this->chosenRows();
  if (!rows.isEmpty() && rows.front() > 0)
  {
    this->Model->moveRows(rows, rows.front() - 1);
  }
}

void SeedTableView::moveDown()
{
  const QVector<int> rows = this->chosenRows();
  if (!rows.isEmpty() && rows.back() + 1 < this->Model->numberOfPoints())
  {
    this->Model->moveRows(rows, rows.back() + 2);
  }
}

void SeedTableView::keyPressEvent(QKeyEvent* event)
{
  if (event->matches(QKeySequence::Copy))
  {
    this->copy();
  }
  else if (event->matches(QKeySequence::Paste))
  {
    this->paste();
  }
  else if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace)
  {
    this->remove();
  }
  else
  {
    QTableView::keyPressEvent(event);
  }
}

}
