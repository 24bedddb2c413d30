// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Any text from a CSV file or the clipboard: it gives points, which written and read again are the
// same, or an error.

#include "PointText.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto read =
    seeds::pointsFromText(QString::fromUtf8(reinterpret_cast<const char*>(data), int(size)));
  if (read.points.isEmpty() == read.error.isEmpty())
  {
    std::abort();
  }
  for (const auto& point : read.points)
  {
    for (const double coordinate : point)
    {
      if (!std::isfinite(coordinate))
      {
        std::abort();
      }
    }
  }
  const auto again = seeds::pointsFromText(seeds::textFromPoints(read.points));
  if (again.points != read.points)
  {
    std::abort();
  }
  return 0;
}
