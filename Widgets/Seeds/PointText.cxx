// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointText.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <cmath>

namespace seeds
{
namespace
{

QString tr(const char* text)
{
  return QCoreApplication::translate("PointText", text);
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
    const QStringList words = line.split(QRegularExpression("[\\s,;]+"), Qt::SkipEmptyParts);
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
