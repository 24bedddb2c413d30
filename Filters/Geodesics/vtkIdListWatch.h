// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIdListWatch_h
#define vtkIdListWatch_h

#include "vtkIdList.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <vector>

/**
 * Notices when a list of ids that a filter takes as an option is edited in place: vtkIdList does
 * not change its modification time by itself, so this keeps a copy and compares.
 */
class vtkIdListWatch
{
public:
  /**
   * Returns the time at which @p list, which may be null, was last found to have other contents.
   * Time O(length).
   */
  vtkMTimeType TimeOf(vtkIdList* list)
  {
    if (!list)
    {
      return 0;
    }
    const vtkIdType* ids = list->GetPointer(0);
    const vtkIdType* end = ids + list->GetNumberOfIds();
    if (!std::equal(ids, end, this->Seen.begin(), this->Seen.end()))
    {
      this->Seen.assign(ids, end);
      this->Changed.Modified();
    }
    return std::max(this->Changed.GetMTime(), list->GetMTime());
  }

private:
  std::vector<vtkIdType> Seen;
  vtkTimeStamp Changed;
};

#endif
