// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedMenu_h
#define seeds_SeedMenu_h

#include "SeedRole.h"

#include <QMenu>

namespace seeds
{

class SeedTableModel;
class SeedTableView;

/**
 * The panel's menu: ways for points into and out of the table, and what is written in the view,
 * which is kept among ParaView's settings.
 */
class SeedMenu : public QMenu
{
  Q_OBJECT

public:
  SeedMenu(SeedTableModel* model, SeedTableView* table, const SeedRole& role, QWidget* parent);

  /** Whether the markers in the view have the numbers of their rows. */
  bool isNumbered() const;
  /** Whether the lengths of segments are written in the view. */
  bool hasLengths() const;
  /** Whether the distance under the pointer is written in the view. */
  bool hasDistanceAtPointer() const;

Q_SIGNALS:
  void numbersToggled(bool isOn);
  void lengthsToggled(bool isOn);
  void distanceAtPointerToggled(bool isOn);
  /** A request was not carried out, for the given reason. */
  void refused(const QString& reason);

private:
  QAction* add(const char* name, const QString& text);
  /** A choice that is kept in a setting. */
  QAction* addChoice(const char* name, const char* setting, const QString& text);
  void enable();
  void addFromSelection();
  void load();
  void save();

  SeedTableModel* Model;
  SeedTableView* Table;
  SeedRole Role;
  QAction* Copy = nullptr;
  QAction* Save = nullptr;
  QAction* FromSelection = nullptr;
  QAction* Numbers = nullptr;
  QAction* Lengths = nullptr;
  QAction* DistanceAtPointer = nullptr;
};

}

#endif
