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

double distanceOf(const PlanePoint& a, const PlanePoint& b)
{
  return std::hypot(a.x - b.x, a.y - b.y);
}

}

FaceField::FaceField(const std::array<PlanePoint, 3>& corners, const std::array<double, 3>& values)
  : Corners(corners)
  , Area(0.5 * orientation(corners[0], corners[1], corners[2]))
  , Size(std::max({ distanceOf(corners[0], corners[1]), distanceOf(corners[1], corners[2]),
      distanceOf(corners[2], corners[0]) }))
  , RoundError(std::numeric_limits<double>::infinity())
{
  double x = 0.0;
  double y = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const PlanePoint& a = corners[(c + 1) % 3];
    const PlanePoint& b = corners[(c + 2) % 3];
    x += values[c] * (a.y - b.y);
    y += values[c] * (b.x - a.x);
  }
  const double slope = std::hypot(x, y) / (2.0 * this->Area);
  this->StraightError = std::abs(slope - 1.0) * this->Size;
  this->findSource(values);
}

void FaceField::findSource(const std::array<double, 3>& values)
{
  for (int c = 0; c < 3; ++c)
  {
    const PlanePoint& a = this->Corners[(c + 1) % 3];
    const PlanePoint& b = this->Corners[(c + 2) % 3];
    const double length = distanceOf(a, b);
    const double first = values[(c + 1) % 3];
    const double second = values[(c + 2) % 3];
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
      const double error = std::abs(distanceOf(source, this->Corners[c]) - values[c]);
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

double FaceField::depth(const PlanePoint& point) const
{
  double depth = std::numeric_limits<double>::infinity();
  for (int c = 0; c < 3; ++c)
  {
    depth = std::min(depth, orientation(this->Corners[c], this->Corners[(c + 1) % 3], point));
  }
  return depth;
}

FaceField::Arc FaceField::arc(const PlanePoint& from, const PlanePoint& to) const
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
  return this->arcOver(from, to, isLong ? angle + 2.0 * std::numbers::pi : angle);
}

FaceField::Arc FaceField::circle(double radius) const
{
  const PlanePoint start{ this->Source.x + radius, this->Source.y };
  return this->arcOver(start, start, 2.0 * std::numbers::pi);
}

FaceField::Arc FaceField::arcOver(const PlanePoint& from, const PlanePoint& to, double angle) const
{
  const PlanePoint& centre = this->Source;
  const double first = distanceOf(centre, from);
  const double second = distanceOf(centre, to);
  const double begin = std::atan2(from.y - centre.y, from.x - centre.x);
  const auto steps = static_cast<int>(std::ceil(std::abs(angle) / LargestStep));
  Arc arc{ { from }, 0.0, 0.0 };
  for (int i = 1; i < steps; ++i)
  {
    const double part = static_cast<double>(i) / steps;
    const double radius = first + part * (second - first);
    arc.points.push_back({ centre.x + radius * std::cos(begin + part * angle),
      centre.y + radius * std::sin(begin + part * angle) });
  }
  arc.points.push_back(to);
  // The radius changes steadily along the arc: Simpson's rule.
  const double turn = std::abs(angle);
  const auto speed = [&](double radius) { return std::hypot(radius * turn, second - first); };
  arc.length = (speed(first) + 4.0 * speed(0.5 * (first + second)) + speed(second)) / 6.0;
  arc.segment = turn * (first * first + first * second + second * second) / 6.0 -
    0.5 * first * second * std::sin(turn);
  return arc;
}

std::vector<double> placesOnEdge(
  double first, double second, double length, bool isRound, double level)
{
  const bool firstIsBelow = first < level;
  const bool secondIsBelow = second < level;
  if (firstIsBelow && secondIsBelow)
  {
    return {};
  }
  const bool differ = firstIsBelow != secondIsBelow;
  if (!isRound || std::abs(second - first) >= length)
  {
    return differ ? std::vector{ std::clamp((level - first) / (second - first), 0.0, 1.0) }
                  : std::vector<double>{};
  }
  // The square of the distance is a parabola: least * at * its middle.
  const double middle = 0.5 * (1.0 - (second - first) * (second + first) / (length * length));
  const double least = (first - middle * length) * (first + middle * length);
  const double squared = (level * level - least) / (length * length);
  const double half = std::sqrt(std::max(squared, 0.0));
  if (differ)
  {
    return { std::clamp(firstIsBelow ? middle + half : middle - half, 0.0, 1.0) };
  }
  if (level > 0.0 && squared > 0.0 && middle - half > 0.0 && middle + half < 1.0)
  {
    return { middle - half, middle + half };
  }
  return {};
}

}
