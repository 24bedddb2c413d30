// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedPanel_h
#define seeds_SeedPanel_h

#include "ResultNumbers.h"
#include "SeedRole.h"

#include <QWidget>

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QLayout;
class QPushButton;
class QToolButton;

namespace seeds
{

class ResultRow;
class SeedHint;
class SeedMenu;
class SeedTableModel;
class SeedTableView;

/** The contents of the panel: the button that starts picking, a hint, the table and its tools. */
class SeedPanel : public QWidget
{
  Q_OBJECT

public:
  SeedPanel(SeedTableModel* model, const SeedRole& role, QWidget* parent);

  SeedHint* hint() const { return this->Hint; }
  SeedTableView* table() const { return this->Table; }
  SeedMenu* menu() const { return this->Menu; }
  bool isPicking() const;
  void setPicking(bool isOn);
  void setPickable(bool isPickable);
  /** Shows what the filter's last run has measured, and no error; nothing if @p result is empty. */
  void showResult(const ResultNumbers& result);
  /** Shows what was wrong with the last run; nothing if @p error is empty. */
  void showError(const QString& error);
  /** Shows whether the filter follows a drag. */
  void showLive(bool isLive);
  bool isLive() const;
  /** Adds a widget below all others. */
  void addRow(QWidget* row);

Q_SIGNALS:
  void pickToggled(bool isOn);
  void addRequested();

private:
  QLayout* buildButtons();
  QToolButton* addButton(QHBoxLayout* row, const char* name, const QString& tip);
  void updateButtons();

  SeedTableModel* Model;
  SeedTableView* Table = nullptr;
  QPushButton* Toggle = nullptr;
  SeedHint* Hint = nullptr;
  SeedMenu* Menu = nullptr;
  QLabel* Error = nullptr;
  QCheckBox* Live = nullptr;
  ResultRow* Result = nullptr;
  QToolButton* Remove = nullptr;
  QToolButton* Up = nullptr;
  QToolButton* Down = nullptr;
  QToolButton* Clear = nullptr;
};

}

#endif
