// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/BvhBounds.h"

#include "base/BoundingBox.h"
#include "base/Lanes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace geodesic
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

float roundedDown(double x)
{
  const float rounded = static_cast<float>(x);
  return rounded > x ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
}

float roundedUp(double x)
{
  return -roundedDown(-x);
}

/** Returns x - (axis . x) axis, the part of @p x across an axis, which may be shorter than 1. */
Vector3 across(const Vector3& axis, const Vector3& x)
{
  return x - dot(axis, x) * axis;
}

void setAxis(BvhBounds& bounds, const Vector3& direction)
{
  // Short enough that rounding to floats cannot make the axis longer than 1.
  constexpr double wantedLength = 1.0 - 1e-6;
  const double length = norm(direction);
  const double scale = length > 0.0 && std::isfinite(length) ? wantedLength / length : 0.0;
  bounds.axisParts = { static_cast<float>(scale * direction.x),
    static_cast<float>(scale * direction.y), static_cast<float>(scale * direction.z) };
}

/** A cylinder that grows until it holds all that is added. */
struct Cylinder
{
  double alongLow = Infinity;
  double alongHigh = -Infinity;
  double radius = 0.0;

  void add(double lowest, double highest, double farthest)
  {
    this->alongLow = std::min(this->alongLow, lowest);
    this->alongHigh = std::max(this->alongHigh, highest);
    this->radius = std::max(this->radius, farthest);
  }

  void roundTo(BvhBounds& bounds) const
  {
    bounds.alongLow = roundedDown(this->alongLow);
    bounds.alongHigh = roundedUp(this->alongHigh);
    bounds.radius = roundedUp(this->radius);
  }
};

}

Vector3 BvhBounds::centre() const
{
  const auto middle = [this](int i)
  { return 0.5 * (static_cast<double>(this->low[i]) + static_cast<double>(this->high[i])); };
  return { middle(0), middle(1), middle(2) };
}

BvhBounds BvhBounds::ofTriangles(std::span<const Vector3> corners)
{
  BoundingBox box;
  Vector3 normal;
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    box.add(corners[i]);
    box.add(corners[i + 1]);
    box.add(corners[i + 2]);
    normal = normal + cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
  }
  BvhBounds bounds;
  bounds.low = { roundedDown(box.low.x), roundedDown(box.low.y), roundedDown(box.low.z) };
  bounds.high = { roundedUp(box.high.x), roundedUp(box.high.y), roundedUp(box.high.z) };
  setAxis(bounds, normal);
  const Vector3 axis = bounds.axis();
  const Vector3 centre = bounds.centre();
  Cylinder cylinder;
  for (const Vector3& corner : corners)
  {
    const Vector3 x = corner - centre;
    const double along = dot(axis, x);
    cylinder.add(along, along, norm(across(axis, x)));
  }
  cylinder.roundTo(bounds);
  return bounds;
}

BvhBounds BvhBounds::ofRuns(std::span<const BvhBounds> runs)
{
  BvhBounds bounds = runs[0];
  Vector3 direction;
  for (const BvhBounds& run : runs)
  {
    for (int i = 0; i < 3; ++i)
    {
      bounds.low[i] = std::min(bounds.low[i], run.low[i]);
      bounds.high[i] = std::max(bounds.high[i], run.high[i]);
    }
    direction = direction + run.axis();
  }
  setAxis(bounds, direction);
  const Vector3 axis = bounds.axis();
  const Vector3 centre = bounds.centre();
  Cylinder cylinder;
  for (const BvhBounds& run : runs)
  {
    // Any point of the run is x + s + h a, with x the centre of its cylinder and a its axis. h is
    // in [alongLow, alongHigh]; s is at most as long as the radius, and at right angles to a except
    // where a is shorter than 1.
    const Vector3 x = run.centre() - centre;
    const Vector3 a = run.axis();
    const double squaredLength = dot(a, a);
    const double cosine = squaredLength > 0.0 ? dot(axis, a) / squaredLength : 0.0;
    const double tilt = norm(axis - cosine * a) * run.radius;
    const double along = dot(axis, x);
    const auto [least, most] = std::minmax({ cosine * run.alongLow, cosine * run.alongHigh });
    const double height = std::max(std::abs(run.alongLow), std::abs(run.alongHigh));
    cylinder.add(along + least - tilt, along + most + tilt,
      norm(across(axis, x)) + run.radius + norm(across(axis, a)) * height);
  }
  cylinder.roundTo(bounds);
  return bounds;
}

void FourBvhBounds::set(std::size_t run, const BvhBounds& bounds)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Low[i][run] = bounds.low[i];
    this->High[i][run] = bounds.high[i];
    this->Axis[i][run] = bounds.axisParts[i];
  }
  this->AlongLow[run] = bounds.alongLow;
  this->AlongHigh[run] = bounds.alongHigh;
  this->Radius[run] = bounds.radius;
}

FourBvhBounds::SquaredDistances FourBvhBounds::squaredDistances(const Vector3& query) const
{
#if GEODESIC_HAS_LANES
  // Two at a time: compilers turn a plain loop into branches, which no processor can predict.
  using Real = Pair;
#else
  using Real = double;
#endif
  SquaredDistances result;
  for (std::size_t first = 0; first < Runs; first += lanes<Real>)
  {
    this->squaredDistances<Real>(query, first, result);
  }
  return result;
}

template <class Real>
void FourBvhBounds::squaredDistances(
  const Vector3& query, std::size_t first, SquaredDistances& result) const
{
  // The gap is NaN where no float can hold the box. It then counts as 0, as largest() returns its
  // second number.
  const auto outside = [](const Real& x, const Real& low, const Real& high)
  { return largest(largest(low - x, x - high), Real()); };
  const auto realIn = [first](const Numbers& numbers)
  {
    if constexpr (lanes<Real> == 1)
    {
      return Real{ numbers[first] };
    }
    else
    {
      return Real{ numbers[first], numbers[first + 1] };
    }
  };
  const auto vectorIn = [&](const std::array<Numbers, 3>& numbers) {
    return Vector3Of<Real>{ realIn(numbers[0]), realIn(numbers[1]), realIn(numbers[2]) };
  };
  const Vector3Of<Real> q{ Real() + query.x, Real() + query.y, Real() + query.z };
  const Vector3Of<Real> low = vectorIn(this->Low);
  const Vector3Of<Real> high = vectorIn(this->High);
  const Vector3Of<Real> axis = vectorIn(this->Axis);
  const Vector3Of<Real> toBox{ outside(q.x, low.x, high.x), outside(q.y, low.y, high.y),
    outside(q.z, low.z, high.z) };
  const Vector3Of<Real> x = q - (Real() + 0.5) * (low + high);
  const Real along = dot(axis, x);
  // As the axis a is not longer than 1, (a . x)^2 + |x - (a . x) a|^2 is at most |x|^2.
  const Real gapAlong = outside(along, realIn(this->AlongLow), realIn(this->AlongHigh));
  const Real gapAcross = largest(norm(x - along * axis) - realIn(this->Radius), Real());
  const Real toCylinder = gapAlong * gapAlong + gapAcross * gapAcross;
  const Real least = largest(toCylinder, dot(toBox, toBox));
  const Real toCentre = dot(x, x);
  std::memcpy(&result.least[first], &least, sizeof least);
  std::memcpy(&result.toCentre[first], &toCentre, sizeof toCentre);
}

std::array<double, 3> FourBvhBounds::low(std::size_t run) const
{
  return { this->Low[0][run], this->Low[1][run], this->Low[2][run] };
}

std::array<double, 3> FourBvhBounds::high(std::size_t run) const
{
  return { this->High[0][run], this->High[1][run], this->High[2][run] };
}

}
