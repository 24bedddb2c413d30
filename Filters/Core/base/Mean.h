// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Mean_h
#define geodesic_Mean_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace geodesic
{

/** The mean of numbers; 0 if there are none. Four sums run side by side: one alone would wait for
 * each addition. */
inline double meanOf(std::span<const float> numbers)
{
  std::array<double, 4> sums{};
  std::size_t i = 0;
  for (; i + sums.size() <= numbers.size(); i += sums.size())
  {
    for (std::size_t s = 0; s < sums.size(); ++s)
    {
      sums[s] += numbers[i + s];
    }
  }
  for (; i < numbers.size(); ++i)
  {
    sums[0] += numbers[i];
  }
  const double count = std::max(1.0, static_cast<double>(numbers.size()));
  return ((sums[0] + sums[1]) + (sums[2] + sums[3])) / count;
}

/** The largest of numbers that are not negative; 0 if there are none. */
inline float largestOf(std::span<const float> numbers)
{
  std::array<float, 8> largest{};
  std::size_t i = 0;
  for (; i + largest.size() <= numbers.size(); i += largest.size())
  {
    for (std::size_t s = 0; s < largest.size(); ++s)
    {
      largest[s] = std::max(largest[s], numbers[i + s]);
    }
  }
  for (; i < numbers.size(); ++i)
  {
    largest[0] = std::max(largest[0], numbers[i]);
  }
  return *std::max_element(largest.begin(), largest.end());
}

}

#endif
