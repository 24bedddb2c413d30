// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedTableView_h
#define seeds_SeedTableView_h

#include <QTableView>
#include <QVector>

namespace seeds
{

class SeedTableModel;

/** The table of the seeds: chosen, ordered, copied and removed by row. */
class SeedTableView : public QTableView
{
  Q_OBJECT

public:
  SeedTableView(SeedTableModel* model, QWidget* parent);

  /** The chosen rows, upwards. */
  QVector<int> chosenRows() const;
  /** Chooses rows that stand together and scrolls to them. */
  void choose(int first, int count = 1);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return this->sizeHint(); }

public Q_SLOTS:
  void copy();
  void paste();
  void remove();
  void moveUp();
  void moveDown();

Q_SIGNALS:
  /** What was pasted is no list of points. */
  void refused(const QString& reason);
  void chosenRowsChanged();

protected:
  void keyPressEvent(QKeyEvent* event) override;

private:
  SeedTableModel* Model;
};

}

#endif
