// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_ResultRow_h
#define seeds_ResultRow_h

#include "ResultNumbers.h"

#include <QWidget>

class QLabel;

namespace seeds
{

/** What the filter's last run has measured, and a button that copies it. */
class ResultRow : public QWidget
{
  Q_OBJECT

public:
  explicit ResultRow(QWidget* parent);

  /** Shows a result; nothing if it is empty. */
  void setResult(const ResultNumbers& result);

private:
  ResultNumbers Result;
  QLabel* Text = nullptr;
};

}

#endif
