// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PickHistory.h"

namespace seeds
{

void PickHistory::add(const QVector<double>& before, const QVector<double>& after)
{
  if (!this->canUndo(before))
  {
    this->Picks.clear();
  }
  this->Picks.append({ before, after });
}

bool PickHistory::canUndo(const QVector<double>& values) const
{
  return !this->Picks.isEmpty() && this->Picks.back().after == values;
}

QVector<double> PickHistory::undo()
{
  return this->Picks.takeLast().before;
}

}
