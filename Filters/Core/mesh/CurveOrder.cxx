// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/CurveOrder.h"

#include "base/BoundingBox.h"
#include "mesh/MortonCurve.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace geodesic
{

std::vector<Index> orderAlongCurve(const std::vector<Vector3>& positions)
{
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), Index{ 0 });
  BoundingBox box;
  for (const Vector3& position : positions)
  {
    box.add(position);
  }
  constexpr double least = 1e-30;
  constexpr double most = 1e30;
  const double diagonal = norm(box.high - box.low);
  if (!(diagonal > least && diagonal < most))
  {
    return order;
  }
  const MortonCurve curve(box);
  std::vector<std::pair<std::uint64_t, Index>> keyed;
  keyed.reserve(positions.size());
  for (const Index i : order)
  {
    keyed.emplace_back(curve.codeOf(positions[i]), i);
  }
  std::sort(keyed.begin(), keyed.end());
  std::transform(
    keyed.begin(), keyed.end(), order.begin(), [](const auto& entry) { return entry.second; });
  return order;
}

}
