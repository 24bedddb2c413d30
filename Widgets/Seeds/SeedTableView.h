// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedTableView_h
#define seeds_SeedTableView_h

#include "Position.h"

#include <QTableView>
#include <QVector>

namespace seeds
{

class SeedTableModel;

/** The table of the points, in which rows can be chosen, ordered, copied and removed. */
class SeedTableView : public QTableView
{
  Q_OBJECT

public:
  SeedTableView(SeedTableModel* model, QWidget* parent);

  /** The chosen rows in increasing order. */
  QVector<int> chosenRows() const;
  /** Chooses @p count consecutive rows and scrolls to them. */
  void choose(int first, int count = 1);
  /** Adds points to the model as its last rows, and chooses them. */
  void append(const QVector<Position>& points);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return this->sizeHint(); }

public Q_SLOTS:
  void copy();
  void paste();
  void remove();
  void moveUp();
  void moveDown();

Q_SIGNALS:
  /** The pasted text is not a list of points. */
  void refused(const QString& reason);
  void chosenRowsChanged();

protected:
  void keyPressEvent(QKeyEvent* event) override;

private:
  SeedTableModel* Model;
};

}

#endif
