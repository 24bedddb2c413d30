// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_PointText_h
#define seeds_PointText_h

#include "Position.h"

#include <QString>
#include <QVector>

namespace seeds
{

/** Points read from text, or what is wrong with it. */
struct PointsFromText
{
  QVector<Position> points;
  /** Empty where the text is good; otherwise it names the line, and points is empty. */
  QString error;
};

/**
 * Reads x, y and z of one or more points a line, between commas, semicolons or white space. Empty
 * lines and those that start with # are passed over, and a first line of words is a header.
 */
PointsFromText pointsFromText(const QString& text);

/** The points as CSV with a header; reading it gives back every bit. */
QString textFromPoints(const QVector<Position>& points);

/** A number with as many digits as tell it from every other. */
QString exactText(double value);

}

#endif
