// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RoundedTube.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace geodesic::testing
{
namespace
{

/** Long steps and then short ones, four times. */
std::vector<double> stepsAround(Index perSide, Index perFillet, double ratio)
{
  std::vector<double> steps;
  for (int side = 0; side < 4; ++side)
  {
    steps.insert(steps.end(), perSide, 1.0);
    steps.insert(steps.end(), perFillet, 1.0 / ratio);
  }
  return steps;
}

}

RoundedTube::RoundedTube(Index perSide, Index perFillet, double ratio, unsigned seed)
{
  constexpr double movedPart = 0.3;
  const std::vector<double> steps = stepsAround(perSide, perFillet, ratio);
  const Index around = static_cast<Index>(steps.size());
  const double turn = 0.5 * std::numbers::pi / (perFillet + 1);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-movedPart, movedPart);
  double z = 0.0;
  for (Index row = 0; row <= around; ++row)
  {
    const bool isBorder = row == 0 || row == around;
    const double reach = isBorder ? 0.0 : std::min(steps[row - 1], steps[row]);
    Vector3 corner;
    double along = 0.0;
    double heading = 0.0;
    for (Index i = 0; i < around; ++i)
    {
      // Points move along the folds of the tube only, so that every triangle stays in its facet.
      const double height = z + reach * move(random);
      this->Tube.points.push_back({ corner.x, corner.y, height });
      this->Flat.push_back({ along, height, 0.0 });
      corner = corner + steps[i] * Vector3{ std::cos(heading), std::sin(heading), 0.0 };
      along += steps[i];
      const bool isLastOfSide = i % (perSide + perFillet) + 1 >= perSide;
      heading += isLastOfSide ? turn : 0.0;
    }
    this->Perimeter = along;
    z += row < around ? steps[row] : 0.0;
  }
  addRingCells(this->Tube, 0, around, around + 1);
}

std::vector<double> RoundedTube::distancesFrom(const SurfacePoint& source) const
{
  const Triangle& corners = this->Tube.triangles[source.triangle];
  Vector3 from;
  for (int c = 0; c < 3; ++c)
  {
    Vector3 corner = this->Flat[corners[c]];
    // A triangle across the seam has corners at both ends of the unrolled profile.
    corner.x -=
      this->Perimeter * std::round((corner.x - this->Flat[corners[0]].x) / this->Perimeter);
    from = from + source.weights[c] * corner;
  }
  std::vector<double> distances;
  for (const Vector3& to : this->Flat)
  {
    const double aside = std::remainder(to.x - from.x, this->Perimeter);
    distances.push_back(std::hypot(aside, to.y - from.y));
  }
  return distances;
}

}
