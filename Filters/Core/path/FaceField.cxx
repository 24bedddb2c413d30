// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/FaceField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace geodesic
{
namespace
{

/** The largest angle between two points of an arc: chords are then 2e-4 radii from it at most. */
constexpr double LargestStep = std::numbers::pi / 90.0;
/** The source of a face's seed has the distances of all corners but for this part of its size. */
constexpr double ExactSource = 1e-6;
/** Costs that differ by less are the same. */
constexpr double SameCost = 1e-12;
/** A cost that is more than so many times that of another corner jumps in the face. */
constexpr double MostOfSmooth = 2.0;
/** By so much, in parts of a face's size, distances from a line through it may differ from that. */
constexpr double ExactLine = 1e-3;

double distanceOf(const PlanePoint& a, const PlanePoint& b)
{
  return std::hypot(a.x - b.x, a.y - b.y);
}

/** The slope of the linear function with these values at the corners of a face. */
PlanePoint slopeOf(const std::array<PlanePoint, 3>& corners, const std::array<double, 3>& values)
{
  const double twice = orientation(corners[0], corners[1], corners[2]);
  PlanePoint slope;
  for (int c = 0; c < 3; ++c)
  {
    const PlanePoint& a = corners[(c + 1) % 3];
    const PlanePoint& b = corners[(c + 2) % 3];
    slope.x += values[c] * (a.y - b.y) / twice;
    slope.y += values[c] * (b.x - a.x) / twice;
  }
  return slope;
}

/** A point, given by its weights at the corners. */
PlanePoint blended(const std::array<PlanePoint, 3>& corners, const std::array<double, 3>& weights)
{
  PlanePoint point;
  for (int c = 0; c < 3; ++c)
  {
    point.x += weights[c] * corners[c].x;
    point.y += weights[c] * corners[c].y;
  }
  return point;
}

}

FaceField::FaceField(const std::array<PlanePoint, 3>& corners, const std::array<double, 3>& values,
  const std::array<double, 3>& costs)
  : Corners(corners)
  , Slope(slopeOf(corners, values))
  , Cost((costs[0] + costs[1] + costs[2]) / 3.0)
  , CostAtSource(Cost)
  , Area(0.5 * orientation(corners[0], corners[1], corners[2]))
  , Size(std::max({ distanceOf(corners[0], corners[1]), distanceOf(corners[1], corners[2]),
      distanceOf(corners[2], corners[0]) }))
  , RoundError(std::numeric_limits<double>::infinity())
{
  this->StraightError =
    std::abs(std::hypot(this->Slope.x, this->Slope.y) / this->Cost - 1.0) * this->Size;
  const auto [least, most] = std::minmax_element(costs.begin(), costs.end());
  if (*most <= MostOfSmooth * *least)
  {
    this->findLine({ values[0] / costs[0], values[1] / costs[1], values[2] / costs[2] });
  }
  this->findSource({ values[0] / this->Cost, values[1] / this->Cost, values[2] / this->Cost });
  if (*most - *least > SameCost * *most)
  {
    this->CostSlope = slopeOf(corners, costs);
    this->HasSource = false;
    this->findSeed(values, costs);
  }
}

void FaceField::findLine(const std::array<double, 3>& lengths)
{
  for (int c = 0; c < 3; ++c)
  {
    // The line has this corner on one side and the others on the other.
    std::array<double, 3> ofSides = lengths;
    ofSides[c] = -ofSides[c];
    const PlanePoint slope = slopeOf(this->Corners, ofSides);
    const double error = std::abs(std::hypot(slope.x, slope.y) - 1.0) * this->Size;
    if (error < std::min(this->StraightError, ExactLine * this->Size))
    {
      this->StraightError = error;
      this->CornerBeyondLine = c;
    }
  }
}

void FaceField::findSource(const std::array<double, 3>& lengths)
{
  for (int c = 0; c < 3; ++c)
  {
    const PlanePoint& a = this->Corners[(c + 1) % 3];
    const PlanePoint& b = this->Corners[(c + 2) % 3];
    const double length = distanceOf(a, b);
    const double first = lengths[(c + 1) % 3];
    const double second = lengths[(c + 2) % 3];
    // The source is at this place along the edge, and as far from it.
    const double along = 0.5 * (length + (first - second) * (first + second) / length);
    const double squared = (first - along) * (first + along);
    if (!(squared > -ExactSource * this->Size * this->Size))
    {
      continue;
    }
    const double away = std::sqrt(std::max(squared, 0.0));
    const PlanePoint unit{ (b.x - a.x) / length, (b.y - a.y) / length };
    for (const double side : { -away, away })
    {
      const PlanePoint source{ a.x + along * unit.x - side * unit.y,
        a.y + along * unit.y + side * unit.x };
      const double error = std::abs(distanceOf(source, this->Corners[c]) - lengths[c]);
      if (error < this->RoundError)
      {
        this->RoundError = error;
        this->Source = source;
      }
    }
  }
  this->HasSource = this->RoundError <= ExactSource * this->Size && this->isRound() &&
    this->depth(this->Source) > 0.0;
}

void FaceField::findSeed(const std::array<double, 3>& values, const std::array<double, 3>& costs)
{
  // From a seed in the face no corner is farther than its longest side, at its dearest cost.
  const double farthest = this->Size * *std::max_element(costs.begin(), costs.end());
  if (*std::max_element(values.begin(), values.end()) > farthest)
  {
    return;
  }
  constexpr double third = 1.0 / 3.0;
  const std::array<double, 3> starts[] = { { third, third, third }, { 0.5, 0.5, 0.0 },
    { 0.0, 0.5, 0.5 }, { 0.5, 0.0, 0.5 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  for (const auto& weights : starts)
  {
    PlanePoint seed = blended(this->Corners, weights);
    if (this->approachSeed(seed, values, costs))
    {
      this->Source = seed;
      this->CostAtSource = this->costAt(seed);
      this->RoundError = 0.0;
      this->HasSource = this->depth(seed) > 0.0;
      this->IsSeedOfVaryingCost = true;
      return;
    }
  }
}

/** Newton's method for the place of the seed; false where that is none. */
bool FaceField::approachSeed(
  PlanePoint& seed, const std::array<double, 3>& values, const std::array<double, 3>& costs) const
{
  const double exact = ExactSource * this->Size * this->Cost;
  constexpr int mostSteps = 40;
  for (int step = 0; step < mostSteps; ++step)
  {
    // The least squares of the three errors: with their derivatives J, J'J move = -J' errors.
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    PlanePoint right;
    double largest = 0.0;
    const double costHere = this->costAt(seed);
    for (int c = 0; c < 3; ++c)
    {
      const PlanePoint way{ this->Corners[c].x - seed.x, this->Corners[c].y - seed.y };
      const double length = std::hypot(way.x, way.y);
      const double mean = 0.5 * (costHere + costs[c]);
      const double error = length * mean - values[c];
      largest = std::max(largest, std::abs(error));
      const double inverse = length > 0.0 ? mean / length : 0.0;
      const PlanePoint slope{ 0.5 * length * this->CostSlope.x - inverse * way.x,
        0.5 * length * this->CostSlope.y - inverse * way.y };
      xx += slope.x * slope.x;
      xy += slope.x * slope.y;
      yy += slope.y * slope.y;
      right.x -= slope.x * error;
      right.y -= slope.y * error;
    }
    const double determinant = xx * yy - xy * xy;
    const PlanePoint move{ (yy * right.x - xy * right.y) / determinant,
      (xx * right.y - xy * right.x) / determinant };
    const double far = std::hypot(move.x, move.y);
    constexpr double settled = 1e-14;
    if (largest <= exact && !(far > settled * this->Size && step + 1 < mostSteps))
    {
      return this->depth(seed) >= -exact * this->Size;
    }
    if (!(far < 2.0 * this->Size))
    {
      return false;
    }
    seed = { seed.x + move.x, seed.y + move.y };
  }
  return false;
}

double FaceField::costAt(const PlanePoint& point) const
{
  const PlanePoint centre = blended(this->Corners, { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 });
  return this->Cost + (point.x - centre.x) * this->CostSlope.x +
    (point.y - centre.y) * this->CostSlope.y;
}

double FaceField::depth(const PlanePoint& point) const
{
  double depth = std::numeric_limits<double>::infinity();
  for (int c = 0; c < 3; ++c)
  {
    depth = std::min(depth, orientation(this->Corners[c], this->Corners[(c + 1) % 3], point));
  }
  return depth;
}

bool FaceField::flowsOut(int corner) const
{
  const PlanePoint& a = this->Corners[(corner + 1) % 3];
  const PlanePoint& b = this->Corners[(corner + 2) % 3];
  if (this->isRound())
  {
    return orientation(a, b, this->Source) > 0.0;
  }
  return this->CornerBeyondLine >= 0 ||
    this->Slope.x * (b.y - a.y) - this->Slope.y * (b.x - a.x) > 0.0;
}

double FaceField::radius(double level, const PlanePoint& direction) const
{
  // r (C + (C + r s)) / 2 = level, where s is the slope of the cost in that direction.
  const double slope = direction.x * this->CostSlope.x + direction.y * this->CostSlope.y;
  const double cost = this->CostAtSource;
  const double root = std::sqrt(std::max(cost * cost + 2.0 * level * slope, 0.0));
  return 2.0 * level / (cost + root);
}

FaceField::Arc FaceField::arc(const PlanePoint& from, const PlanePoint& to, double level) const
{
  if (!this->isRound())
  {
    return { { from, to }, distanceOf(from, to), 0.0 };
  }
  const double angle = std::atan2(orientation(this->Source, from, to),
    (from.x - this->Source.x) * (to.x - this->Source.x) +
      (from.y - this->Source.y) * (to.y - this->Source.y));
  // The turn is counterclockwise. Beside a source outside of the face it is less than half a
  // circle, and below 0 by rounding only.
  const bool isLong = angle < (this->HasSource ? 0.0 : -0.5 * std::numbers::pi);
  return this->arcOver(from, to, isLong ? angle + 2.0 * std::numbers::pi : angle, level);
}

FaceField::Arc FaceField::circle(double level) const
{
  const PlanePoint start{ this->Source.x + this->radius(level, { 1.0, 0.0 }), this->Source.y };
  return this->arcOver(start, start, 2.0 * std::numbers::pi, level);
}

FaceField::Arc FaceField::arcOver(
  const PlanePoint& from, const PlanePoint& to, double angle, double level) const
{
  const PlanePoint& centre = this->Source;
  const double first = distanceOf(centre, from);
  const double second = distanceOf(centre, to);
  const double begin = std::atan2(from.y - centre.y, from.x - centre.x);
  const auto steps = std::max(static_cast<int>(std::ceil(std::abs(angle) / LargestStep)), 1);
  const auto direction = [&](double part) {
    return PlanePoint{ std::cos(begin + part * angle), std::sin(begin + part * angle) };
  };
  // Without a seed's own rule the radius changes steadily along the arc.
  const auto radiusAt = [&](double part)
  {
    return this->IsSeedOfVaryingCost ? this->radius(level, direction(part))
                                     : first + part * (second - first);
  };
  Arc arc{ { from }, 0.0, -0.5 * first * second * std::sin(std::abs(angle)) };
  const double turn = std::abs(angle) / steps;
  double before = first;
  for (int i = 1; i <= steps; ++i)
  {
    // Simpson's rule for each step.
    const double middle = radiusAt((i - 0.5) / steps);
    const double after = i == steps ? second : radiusAt(static_cast<double>(i) / steps);
    const auto speed = [&](double radius, double rise) { return std::hypot(radius * turn, rise); };
    arc.length +=
      (speed(before, 4.0 * middle - 3.0 * before - after) + 4.0 * speed(middle, after - before) +
        speed(after, 3.0 * after + before - 4.0 * middle)) /
      6.0;
    arc.segment += turn * (before * before + 4.0 * middle * middle + after * after) / 12.0;
    if (i < steps)
    {
      const PlanePoint unit = direction(static_cast<double>(i) / steps);
      arc.points.push_back({ centre.x + after * unit.x, centre.y + after * unit.y });
    }
    before = after;
  }
  arc.points.push_back(to);
  return arc;
}

}
