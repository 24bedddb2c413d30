// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedTableModel_h
#define seeds_SeedTableModel_h

#include "Position.h"

#include <QAbstractTableModel>
#include <QVector>

namespace seeds
{

/**
 * A property's numbers as a table of points: each row has x, y and z of one point. If the number of
 * values is not a multiple of 3, which only a script can cause, the last row has empty cells.
 */
class SeedTableModel : public QAbstractTableModel
{
  Q_OBJECT

public:
  using QAbstractTableModel::QAbstractTableModel;

  const QVector<double>& values() const { return this->Values; }
  /** Replaces all values. This is not an edit. */
  void setValues(const QVector<double>& values);

  /** The complete points. */
  QVector<Position> points() const;
  /**
   * Shows the length from each row to the next in a fourth column, which is not part of the values;
   * without lengths there is no such column.
   */
  void setLengths(const QVector<double>& lengths);
  int numberOfPoints() const { return this->Values.size() / 3; }
  /** Moves one point. This is not an edit, so that a whole drag can be one. */
  void setPoint(int row, const Position& point);

  ///@{
  /** Edits. Each call emits edited() once. */
  void append(const QVector<Position>& points);
  void insert(int row, const Position& point);
  void removeRows(const QVector<int>& rows);
  /** Moves rows so that they stand before the row @p to and keep their order. */
  void moveRows(const QVector<int>& rows, int to);
  void clear();
  void replace(const QVector<double>& values) { this->edit(values); }
  ///@}

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

  ///@{
  /** Lets rows be dragged to another place in the same table. */
  Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
    const QModelIndex& parent) override;
  ///@}

Q_SIGNALS:
  /** The user has changed the points. */
  void edited();
  /** Some rows were moved; they are now @p count rows from row @p first on. */
  void rowsPlaced(int first, int count);

private:
  void edit(const QVector<double>& values);
  QVariant lengthData(int row, int role) const;

  QVector<double> Values;
  QVector<double> Lengths;
};

}

#endif
