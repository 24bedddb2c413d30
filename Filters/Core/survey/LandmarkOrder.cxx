// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey/LandmarkOrder.h"

#include <algorithm>
#include <numeric>

namespace geodesic
{
namespace
{

std::vector<double> squaresTo(std::span<const Vector3> points, const Vector3& place)
{
  std::vector<double> squares;
  squares.reserve(points.size());
  for (const Vector3& point : points)
  {
    const Vector3 away = point - place;
    squares.push_back(dot(away, away));
  }
  return squares;
}

}

std::vector<std::size_t> landmarkOrder(std::span<const Vector3> landmarks)
{
  std::vector<std::size_t> order(landmarks.size());
  if (landmarks.empty())
  {
    return order;
  }
  const Vector3 sum = std::accumulate(landmarks.begin(), landmarks.end(), Vector3{});
  const Vector3 middle = (1.0 / static_cast<double>(landmarks.size())) * sum;
  const std::vector<double> fromMiddle = squaresTo(landmarks, middle);
  const auto outermost = std::max_element(fromMiddle.begin(), fromMiddle.end());
  const std::vector<double> squares =
    squaresTo(landmarks, landmarks[static_cast<std::size_t>(outermost - fromMiddle.begin())]);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return squares[a] > squares[b]; });
  return order;
}

}
