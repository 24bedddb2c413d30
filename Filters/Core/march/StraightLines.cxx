// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/StraightLines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace geodesic
{
namespace
{

/** So many vertices, or blocks of them, are in a block. */
constexpr std::size_t BlockSize = 32;
constexpr std::size_t BlocksOfBlock = 8;

double square(double x)
{
  return x * x;
}

/** The square of the least distance of a box from a place. */
double leastSquare(const BoundingBox& box, const Vector3& place)
{
  const Vector3 toBox = box.nearestTo(place) - place;
  return dot(toBox, toBox);
}

/** The square of the largest one. */
double largestSquare(const BoundingBox& box, const Vector3& place)
{
  return square(std::max(place.x - box.low.x, box.high.x - place.x)) +
    square(std::max(place.y - box.low.y, box.high.y - place.y)) +
    square(std::max(place.z - box.low.z, box.high.z - place.z));
}

}

StraightLines::StraightLines(std::span<const Vector3> positions)
  : Positions(positions)
  , Boxes(1)
{
  this->Boxes[0].resize((positions.size() + BlockSize - 1) / BlockSize);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    this->Boxes[0][i / BlockSize].add(positions[i]);
  }
  while (this->Boxes.back().size() > 1)
  {
    const std::vector<BoundingBox>& inner = this->Boxes.back();
    std::vector<BoundingBox> outer((inner.size() + BlocksOfBlock - 1) / BlocksOfBlock);
    for (std::size_t i = 0; i < inner.size(); ++i)
    {
      outer[i / BlocksOfBlock].add(inner[i].low, inner[i].high);
    }
    this->Boxes.push_back(std::move(outer));
  }
  this->Places.resize(this->Boxes.size());
}

void StraightLines::measure(std::span<const Vector3> places, double most, const Visit& visit)
{
  if (!this->Positions.empty())
  {
    this->measure(this->Boxes.size() - 1, 0, places, square(most), visit);
  }
}

void StraightLines::measure(std::size_t level, std::size_t block, std::span<const Vector3> places,
  double mostSquare, const Visit& visit)
{
  const BoundingBox& box = this->Boxes[level][block];
  double most = mostSquare;
  for (const Vector3& place : places)
  {
    most = std::min(most, largestSquare(box, place));
  }
  std::vector<Vector3>& left = this->Places[level];
  left.clear();
  std::copy_if(places.begin(), places.end(), std::back_inserter(left),
    [&](const Vector3& place) { return leastSquare(box, place) <= most; });
  if (left.empty())
  {
    return;
  }
  if (level == 0)
  {
    this->measureVertices(block, left, visit);
    return;
  }
  const std::size_t first = block * BlocksOfBlock;
  const std::size_t last = std::min(first + BlocksOfBlock, this->Boxes[level - 1].size());
  for (std::size_t inner = first; inner < last; ++inner)
  {
    this->measure(level - 1, inner, left, mostSquare, visit);
  }
}

void StraightLines::measureVertices(
  std::size_t block, std::span<const Vector3> places, const Visit& visit) const
{
  const std::size_t first = block * BlockSize;
  const std::size_t count = std::min(BlockSize, this->Positions.size() - first);
  // Coordinates apart, so that a compiler makes loops of several numbers at once.
  std::array<double, BlockSize> x{};
  std::array<double, BlockSize> y{};
  std::array<double, BlockSize> z{};
  std::array<double, BlockSize> least;
  for (std::size_t i = 0; i < count; ++i)
  {
    x[i] = this->Positions[first + i].x;
    y[i] = this->Positions[first + i].y;
    z[i] = this->Positions[first + i].z;
  }
  least.fill(std::numeric_limits<double>::infinity());
  for (const auto& [px, py, pz] : places)
  {
    for (std::size_t i = 0; i < BlockSize; ++i)
    {
      const double found = square(x[i] - px) + square(y[i] - py) + square(z[i] - pz);
      least[i] = found < least[i] ? found : least[i];
    }
  }
  visit(static_cast<Index>(first), std::span(least).first(count));
}

}
