// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedPanel_h
#define seeds_SeedPanel_h

#include "Position.h"
#include "ResultNumbers.h"
#include "SeedPicker.h"
#include "SeedRole.h"

#include <QVector>
#include <QWidget>

class QAction;
class QCheckBox;
class QHBoxLayout;
class QLabel;
class QLayout;
class QMenu;
class QPushButton;
class QToolButton;

namespace seeds
{

class SeedTableModel;
class SeedTableView;

/** The contents of the panel: the button that starts picking, a hint, the table and its tools. */
class SeedPanel : public QWidget
{
  Q_OBJECT

public:
  SeedPanel(SeedTableModel* model, const SeedRole& role, QWidget* parent);

  SeedTableView* table() const { return this->Table; }
  bool isPicking() const;
  void setPicking(bool isOn);
  void setPickable(bool isPickable);
  bool isNumbered() const;
  /** Whether the lengths of segments are written in the view. */
  bool hasLengthsInView() const;
  /** Whether the distance under the pointer is written in the view. */
  bool hasDistanceAtPointer() const;
  /** Shows what the filter's last run has measured, and no error; nothing if @p result is empty. */
  void showResult(const ResultNumbers& result);
  /** Shows what was wrong with the last run; nothing if @p error is empty. */
  void showError(const QString& error);
  /** Shows whether the filter follows a drag. */
  void showLive(bool isLive);
  bool isLive() const;
  /** Adds a widget below all others. */
  void addRow(QWidget* row);
  /** Tells what counts beside the points of the table; see OtherSources. */
  void setOthers(const QString& others);

  /** Shows what the mouse does at the pointer. */
  void setOffer(const Offer& offer);

public Q_SLOTS:
  /** Shows why a request was not carried out. */
  void complain(const QString& reason);
  /** Shows what to do next. */
  void showHint();

Q_SIGNALS:
  void pickToggled(bool isOn);
  void numbersToggled(bool isOn);
  void lengthsToggled(bool isOn);
  void distanceAtPointerToggled(bool isOn);
  void addRequested();

private:
  QString hintText() const;
  QLayout* buildButtons();
  QLayout* buildResult();
  /** A choice of the menu that is kept among ParaView's settings. */
  QAction* addChoice(QMenu* menu, const char* name, const char* setting, const QString& text);
  QToolButton* addButton(QHBoxLayout* row, const char* name, const QString& tip);
  QMenu* buildMenu();
  QAction* addAction(QMenu* menu, const char* name, const QString& text);
  void prepareMenu();
  void updateButtons();
  void addFromSelection();
  void load();
  void save();
  void append(const QVector<Position>& points);

  SeedTableModel* Model;
  SeedRole Role;
  SeedTableView* Table = nullptr;
  QPushButton* Toggle = nullptr;
  QLabel* Hint = nullptr;
  QString Others;
  Offer AtPointer;
  QLabel* Error = nullptr;
  QCheckBox* Live = nullptr;
  QLabel* ResultText = nullptr;
  QToolButton* CopyResult = nullptr;
  ResultNumbers Result;
  QToolButton* Remove = nullptr;
  QToolButton* Up = nullptr;
  QToolButton* Down = nullptr;
  QToolButton* Clear = nullptr;
  QAction* Copy = nullptr;
  QAction* Save = nullptr;
  QAction* FromSelection = nullptr;
  QAction* Numbers = nullptr;
  QAction* LengthsInView = nullptr;
  QAction* DistanceAtPointer = nullptr;
};

}

#endif
