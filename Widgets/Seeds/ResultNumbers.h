// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_ResultNumbers_h
#define seeds_ResultNumbers_h

#include "Position.h"

#include <QString>
#include <QVector>

class vtkSMPropertyGroup;
class vtkSMProxy;

namespace seeds
{

/** What a filter's last run has measured, in the data's unit of length. */
struct ResultNumbers
{
  /** The name and value of the number that sums it up, and the number of segments if there are any.
   */
  QString summary;
  /** What to know about the numbers; empty if there is nothing. */
  QString notice;
  /** That number; 0 where there is none. */
  double value = 0.0;
  /** The length of each segment from a row to the next; negative where no path joins them. */
  QVector<double> lengths;
  /** The point in the middle of each segment. */
  QVector<Position> middles;

  /** What was wrong with the run; empty if nothing was. */
  QString error;
  /** How long it took, in seconds; 0 if that is not known. */
  double runTime = 0.0;

  /** All numbers as lines of text, their parts separated by tabs. */
  QString text() const;

  /**
   * Asks the server for the information properties of a group with the functions Result (one
   * number), Lengths (one for each segment), Middles (three for each), Error and Notice (texts) and
   * RunTime. Each may be left out.
   */
  static ResultNumbers of(vtkSMProxy* filter, vtkSMPropertyGroup* group);
};

/** A length with six digits. */
QString lengthText(double length);

}

#endif
