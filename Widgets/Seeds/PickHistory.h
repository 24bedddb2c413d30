// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_PickHistory_h
#define seeds_PickHistory_h

#include <QVector>

namespace seeds
{

/**
 * The picks that can be taken back. A pick that something else followed, an edit of the table or a
 * drag, cannot, and neither can those before it.
 */
class PickHistory
{
public:
  /** Notes the values of the table before and after a pick. */
  void add(const QVector<double>& before, const QVector<double>& after);
  /** Whether the last thing that happened to the values is a pick. */
  bool canUndo(const QVector<double>& values) const;
  /** Takes back the last pick; returns the values before it. Only where canUndo(). */
  QVector<double> undo();

private:
  struct Pick
  {
    QVector<double> before;
    QVector<double> after;
  };
  QVector<Pick> Picks;
};

}

#endif
