// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// What the panel reads from a CSV file and the clipboard: points or an error, never other numbers
// than those that are written there.

#include "PointText.h"

#include <QLocale>

#include <gtest/gtest.h>

#include <clocale>

using namespace seeds;

namespace
{

void expectPoints(const QString& text, const QVector<Position>& points)
{
  const PointsFromText read = pointsFromText(text);
  EXPECT_EQ(read.error.toStdString(), "") << text.toStdString();
  EXPECT_EQ(read.points, points) << text.toStdString();
}

void expectError(const QString& text, const char* named)
{
  const PointsFromText read = pointsFromText(text);
  EXPECT_TRUE(read.points.isEmpty()) << text.toStdString();
  EXPECT_TRUE(read.error.contains(named)) << read.error.toStdString();
}

}

TEST(PointText, NumbersAreThoseThatAreWritten)
{
  expectPoints("1.5,2.5,3.5", { { 1.5, 2.5, 3.5 } });
  expectPoints("1.5, 2.5, 3.5", { { 1.5, 2.5, 3.5 } });
  expectPoints("1,2,3", { { 1, 2, 3 } });
  expectPoints("1 , 2 , 3", { { 1, 2, 3 } });
  expectPoints("1,2,3;4,5,6", { { 1, 2, 3 }, { 4, 5, 6 } });
  expectPoints("0,0,0 1,1,1 2,2,2", { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } });
  expectPoints("1;2;3", { { 1, 2, 3 } });
  expectPoints("# a comment\r\nx,y,z\r\n\r\n-1e-3\t2\t3E2\n", { { -1e-3, 2, 300 } });
}

// As spread sheets write them where the decimal mark is a comma.
TEST(PointText, DecimalCommasAreRead)
{
  expectPoints("x;y;z\n1,5;2,5;-3,25", { { 1.5, 2.5, -3.25 } });
  expectPoints("1,5;2;0", { { 1.5, 2, 0 } });
  expectPoints("1,5\t2,5\t3,5", { { 1.5, 2.5, 3.5 } });
  expectPoints("1,5e2; 2,5; 3", { { 150, 2.5, 3 } });
  expectError("0;0;0\n1.000,5;2;3", "1.000.5");
}

TEST(PointText, WhatIsNoPointIsNamed)
{
  expectError("0,0,0\n1,2", "Line 2 has 2 numbers");
  expectError("0,0,0\n1,nan,2", "\"nan\" is not a number");
  expectError("0,0,0\n1,1e999,2", "1e999");
  expectError("0,0,0\n\"; DROP TABLE points; --,1,2", "is not a number");
  expectError("0,0,0\n__import__('os'),1,2", "__import__('os')");
  expectError(QString("0,0,0\n") + QString(1000000, 'x') + ",1,2", "is not a number");
  expectError(QString::fromUtf8("0,0,0\n\xe2\x80\x9c"
                                "1,2,3"),
    "is not a number");
  expectError("", "no points");
}

// The user's language makes no difference.
TEST(PointText, NumbersDoNotDependOnTheLocale)
{
  const QVector<Position> points{ { 0.1, 1.0 / 3.0, -2.5e-300 } };
  const QString text = textFromPoints(points);
  expectPoints(text, points);
  const bool hasComma = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  QLocale::setDefault(QLocale(QLocale::German));
  EXPECT_EQ(textFromPoints(points), text);
  expectPoints(text, points);
  QLocale::setDefault(QLocale::c());
  if (hasComma)
  {
    std::setlocale(LC_ALL, "C");
  }
}
