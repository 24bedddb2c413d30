// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_PointText_h
#define seeds_PointText_h

#include "Position.h"

#include <QString>
#include <QVector>

namespace seeds
{

/** Points read from text, or the error in the text. */
struct PointsFromText
{
  QVector<Position> points;
  /** Empty if the text is valid. Otherwise it names the line, and points is empty. */
  QString error;
};

/**
 * Reads x, y and z of one or more points from each line, separated by commas, semicolons or white
 * space. Where the latter two make whole points, commas are decimal marks. Empty lines, lines that
 * start with #, and a first line of words (a header) are skipped.
 */
PointsFromText pointsFromText(const QString& text);

/** Writes the points as CSV with a header. Reading the text gives exactly the same numbers. */
QString textFromPoints(const QVector<Position>& points);

/** Writes a number with as many digits as distinguish it from every other number. */
QString exactText(double value);

}

#endif
