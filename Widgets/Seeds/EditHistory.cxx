// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EditHistory.h"

namespace seeds
{

void EditHistory::add(const Edit& edit)
{
  if (edit.before == edit.after)
  {
    return;
  }
  if (!this->canUndo(edit.before))
  {
    this->Edits.clear();
  }
  this->Edits.append(edit);
}

bool EditHistory::canUndo(const QVector<double>& values) const
{
  return !this->Edits.isEmpty() && this->Edits.back().after == values;
}

EditHistory::Edit EditHistory::takeLast()
{
  return this->Edits.takeLast();
}

}
