// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SortUnique_h
#define geodesic_SortUnique_h

#include <algorithm>
#include <vector>

namespace geodesic
{

/** Sorts values in increasing order and removes duplicates. Time O(n log n). */
template <class T>
void sortUnique(std::vector<T>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}

#endif
