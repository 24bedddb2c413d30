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

/** How far positive numbers are spread: their mean by their harmonic mean. 1 if all are equal, or
 * if there are none; what is not positive is left out. */
inline double spreadOf(std::span<const float> numbers)
{
  constexpr std::size_t lanes = 4;
  std::array<double, lanes> counts{};
  std::array<double, lanes> sums{};
  std::array<double, lanes> sumsOfInverses{};
  for (std::size_t i = 0; i < numbers.size(); i += lanes)
  {
    for (std::size_t s = 0; s < std::min(lanes, numbers.size() - i); ++s)
    {
      const double number = numbers[i + s];
      const bool isPositive = number > 0.0;
      counts[s] += isPositive ? 1.0 : 0.0;
      sums[s] += isPositive ? number : 0.0;
      sumsOfInverses[s] += isPositive ? 1.0 / number : 0.0;
    }
  }
  const auto total = [](const std::array<double, lanes>& of)
  { return (of[0] + of[1]) + (of[2] + of[3]); };
  const double count = total(counts);
  return count > 0.0 ? total(sums) * total(sumsOfInverses) / (count * count) : 1.0;
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
