// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedHint_h
#define seeds_SeedHint_h

#include "SeedPicker.h"
#include "SeedRole.h"

#include <QLabel>

namespace seeds
{

class SeedTableModel;

/**
 * The line of the panel that tells what the mouse does now and what else gives points, or why a
 * request was not carried out.
 */
class SeedHint : public QLabel
{
  Q_OBJECT

public:
  SeedHint(const SeedTableModel* model, const SeedRole& role, QWidget* parent);

  /** Tells whether a click adds a point. */
  void setPicking(bool isPicking);
  /** Tells what the mouse does at the pointer. */
  void setOffer(const Offer& offer);
  /** Tells what counts beside the points of the table; see OtherSources. */
  void setOthers(const QString& others);

public Q_SLOTS:
  /** Shows what to do next. */
  void refresh();
  /** Shows why a request was not carried out, until there is something else to show. */
  void complain(const QString& reason);

private:
  QString whatToDo() const;

  const SeedTableModel* Model;
  SeedRole Role;
  bool IsPicking = false;
  Offer AtPointer;
  QString Others;
};

}

#endif
