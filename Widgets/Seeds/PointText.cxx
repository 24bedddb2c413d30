// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointText.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace seeds
{
namespace
{

QString tr(const char* text)
{
  return QCoreApplication::translate("PointText", text);
}

/** The numbers of a line, as they are written. A comma is a decimal mark where semicolons or white
 * space make whole points of the line, and each comma stands inside of a word of its own: spread
 * sheets of many countries write 1,5;2,5;0. */
QStringList wordsOf(const QString& line)
{
  static const QRegularExpression other("[\\s;]+");
  static const QRegularExpression any("[\\s,;]+");
  static const QRegularExpression inside("^[^,]*[0-9],[0-9][^,]*$");
  QStringList words = line.split(other, Qt::SkipEmptyParts);
  const bool areDecimal = words.size() % 3 == 0 &&
    std::all_of(words.begin(), words.end(),
      [](const QString& word) { return !word.contains(',') || inside.match(word).hasMatch(); });
  if (!areDecimal)
  {
    return line.split(any, Qt::SkipEmptyParts);
  }
  words.replaceInStrings(",", ".");
  return words;
}

}

PointsFromText pointsFromText(const QString& text)
{
  PointsFromText result;
  const QStringList lines = text.split(QRegularExpression("\r\n|\n|\r"));
  bool isFirst = true;
  for (int i = 0; i < lines.size(); ++i)
  {
    const QString line = lines[i].trimmed();
    if (line.isEmpty() || line.startsWith('#'))
    {
      continue;
    }
    const QStringList words = wordsOf(line);
    QVector<double> numbers;
    QString notANumber;
    for (const QString& word : words)
    {
      bool isNumber = false;
      numbers.append(word.toDouble(&isNumber));
      if (!isNumber || !std::isfinite(numbers.back()))
      {
        notANumber = word;
      }
    }
    const bool isHeader = isFirst && !notANumber.isEmpty();
    isFirst = false;
    if (isHeader)
    {
      continue;
    }
    if (!notANumber.isEmpty())
    {
      return { {}, tr("Line %1: \"%2\" is not a number.").arg(i + 1).arg(notANumber) };
    }
    if (numbers.size() % 3 != 0)
    {
      return {
        {},
        tr("Line %1 has %2 numbers; give x, y and z of each point.").arg(i + 1).arg(numbers.size())
      };
    }
    for (int k = 0; k < numbers.size(); k += 3)
    {
      result.points.append({ numbers[k], numbers[k + 1], numbers[k + 2] });
    }
  }
  if (result.points.isEmpty())
  {
    result.error = tr("There are no points in this text; give x, y and z of each point.");
  }
  return result;
}

QString exactText(double value)
{
  return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

QString textFromPoints(const QVector<Position>& points)
{
  QString text = "x,y,z\n";
  for (const Position& p : points)
  {
    text += QString("%1,%2,%3\n").arg(exactText(p[0]), exactText(p[1]), exactText(p[2]));
  }
  return text;
}

}
