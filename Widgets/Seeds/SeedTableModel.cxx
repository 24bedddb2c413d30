// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedTableModel.h"

#include "ParaViewVersions.h"
#include "PointText.h"
#include "ResultNumbers.h"

#include <QDataStream>
#include <QIODevice>
#include <QMimeData>

#include <algorithm>
#include <cmath>

namespace seeds
{
namespace
{

constexpr const char* RowsMimeType = "application/x-surface-seed-rows";
constexpr int LengthColumn = 3;

}

void SeedTableModel::setValues(const QVector<double>& values)
{
  const int before = this->rowCount();
  const int after = (values.size() + 2) / 3;
  if (after > before)
  {
    this->beginInsertRows({}, before, after - 1);
    this->Values = values;
    this->endInsertRows();
  }
  else if (after < before)
  {
    this->beginRemoveRows({}, after, before - 1);
    this->Values = values;
    this->endRemoveRows();
  }
  this->Values = values;
  if (after > 0)
  {
    Q_EMIT this->dataChanged(this->index(0, 0), this->index(after - 1, 2));
  }
}

void SeedTableModel::setLengths(const QVector<double>& lengths)
{
  if (lengths.isEmpty() == this->Lengths.isEmpty())
  {
    this->Lengths = lengths;
    if (!lengths.isEmpty() && this->rowCount() > 0)
    {
      Q_EMIT this->dataChanged(
        this->index(0, LengthColumn), this->index(this->rowCount() - 1, LengthColumn));
    }
  }
  else if (lengths.isEmpty())
  {
    this->beginRemoveColumns({}, LengthColumn, LengthColumn);
    this->Lengths.clear();
    this->endRemoveColumns();
  }
  else
  {
    this->beginInsertColumns({}, LengthColumn, LengthColumn);
    this->Lengths = lengths;
    this->endInsertColumns();
  }
}

QVector<Position> SeedTableModel::points() const
{
  QVector<Position> points;
  for (int row = 0; row < this->numberOfPoints(); ++row)
  {
    points.append({ this->Values[3 * row], this->Values[3 * row + 1], this->Values[3 * row + 2] });
  }
  return points;
}

void SeedTableModel::setPoint(int row, const Position& point)
{
  std::copy(point.begin(), point.end(), this->Values.begin() + 3 * row);
  Q_EMIT this->dataChanged(this->index(row, 0), this->index(row, 2));
}

void SeedTableModel::edit(const QVector<double>& values)
{
  this->setValues(values);
  Q_EMIT this->edited();
}

void SeedTableModel::append(const QVector<Position>& points)
{
  QVector<double> values = this->Values.mid(0, 3 * this->numberOfPoints());
  for (const Position& point : points)
  {
    for (const double coordinate : point)
    {
      values.append(coordinate);
    }
  }
  this->edit(values);
}

void SeedTableModel::insert(int row, const Position& point)
{
  QVector<double> values = this->Values.mid(0, 3 * row);
  values += QVector<double>(point.begin(), point.end());
  values += this->Values.mid(3 * row);
  this->edit(values);
}

void SeedTableModel::removeRows(const QVector<int>& rows)
{
  QVector<double> values;
  for (int i = 0; i < this->Values.size(); ++i)
  {
    if (!rows.contains(i / 3))
    {
      values.append(this->Values[i]);
    }
  }
  this->edit(values);
}

void SeedTableModel::moveRows(const QVector<int>& rows, int to)
{
  const QVector<Position> points = this->points();
  QVector<Position> moved;
  QVector<Position> before;
  QVector<Position> after;
  for (int row = 0; row < points.size(); ++row)
  {
    (rows.contains(row) ? moved : row < to ? before : after).append(points[row]);
  }
  QVector<double> values;
  for (const Position& point : before + moved + after)
  {
    values += QVector<double>(point.begin(), point.end());
  }
  this->edit(values);
  Q_EMIT this->rowsPlaced(before.size(), moved.size());
}

void SeedTableModel::clear()
{
  this->edit({});
}

int SeedTableModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : (this->Values.size() + 2) / 3;
}

int SeedTableModel::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : this->Lengths.isEmpty() ? LengthColumn : LengthColumn + 1;
}

QVariant SeedTableModel::data(const QModelIndex& index, int role) const
{
  if (index.column() == LengthColumn)
  {
    return this->lengthData(index.row(), role);
  }
  const int at = 3 * index.row() + index.column();
  if (at >= this->Values.size())
  {
    return {};
  }
  switch (role)
  {
    case Qt::DisplayRole:
      return shownNumber(this->Values[at]);
    case Qt::EditRole:
    case Qt::ToolTipRole:
      return exactText(this->Values[at]);
    case Qt::TextAlignmentRole:
      return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    default:
      return {};
  }
}

QVariant SeedTableModel::lengthData(int row, int role) const
{
  if (role == Qt::TextAlignmentRole)
  {
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (row >= this->Lengths.size())
  {
    return {};
  }
  switch (role)
  {
    case Qt::DisplayRole:
      return lengthText(this->Lengths[row]);
    case Qt::EditRole:
      return exactText(this->Lengths[row]);
    case Qt::ToolTipRole:
      return tr("The length from here to the next: %1").arg(exactText(this->Lengths[row]));
    default:
      return {};
  }
}

QVariant SeedTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (role != Qt::DisplayRole)
  {
    return {};
  }
  if (orientation == Qt::Horizontal)
  {
    return section == LengthColumn ? tr("length") : QString("xyz"[section]);
  }
  return section;
}

bool SeedTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
  bool isNumber = false;
  const double number = value.toString().trimmed().toDouble(&isNumber);
  if (role != Qt::EditRole || !isNumber || !std::isfinite(number))
  {
    return false;
  }
  const int at = 3 * index.row() + index.column();
  QVector<double> values = this->Values;
  values.resize(std::max(static_cast<int>(values.size()), at + 1));
  values[at] = number;
  this->edit(values);
  return true;
}

Qt::ItemFlags SeedTableModel::flags(const QModelIndex& index) const
{
  if (!index.isValid())
  {
    return Qt::ItemIsDropEnabled;
  }
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index) | Qt::ItemIsDragEnabled;
  return index.column() == LengthColumn ? flags : flags | Qt::ItemIsEditable;
}

QStringList SeedTableModel::mimeTypes() const
{
  return { RowsMimeType };
}

QMimeData* SeedTableModel::mimeData(const QModelIndexList& indexes) const
{
  QVector<int> rows;
  for (const QModelIndex& index : indexes)
  {
    if (!rows.contains(index.row()))
    {
      rows.append(index.row());
    }
  }
  QByteArray bytes;
  QDataStream stream(&bytes, QIODevice::WriteOnly);
  stream << rows;
  auto* data = new QMimeData;
  data->setData(RowsMimeType, bytes);
  return data;
}

bool SeedTableModel::dropMimeData(
  const QMimeData* data, Qt::DropAction, int row, int, const QModelIndex& parent)
{
  QVector<int> rows;
  QDataStream stream(data->data(RowsMimeType));
  stream >> rows;
  const int to = parent.isValid() ? parent.row() : row < 0 ? this->rowCount() : row;
  this->moveRows(rows, to);
  // False, because the rows are moved already and the view must not remove them.
  return false;
}

}
