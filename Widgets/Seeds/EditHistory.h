// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_EditHistory_h
#define seeds_EditHistory_h

#include <QVector>

namespace seeds
{

/**
 * What was done in the view, a pick, a drag or a removal, and can be taken back there. What
 * something else followed, as an edit of the table, cannot, and neither can what was before it.
 */
class EditHistory
{
public:
  struct Edit
  {
    /** The values of the table before and after. */
    QVector<double> before;
    QVector<double> after;
    /** Whether it was applied at once. */
    bool isApplied;
  };

  /** Notes an edit, if it changed anything. */
  void add(const Edit& edit);
  /** Whether the last thing that happened to the values is an edit that was noted. */
  bool canUndo(const QVector<double>& values) const;
  /** Forgets the last edit, and returns it. Only where canUndo(). */
  Edit takeLast();

private:
  QVector<Edit> Edits;
};

}

#endif
