// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/StraightLines.h"

#include "base/BoundingBox.h"
#include "base/Index.h"
#include "mesh/TriangleMesh.h"

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
constexpr std::size_t BlockSize = 64;
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

/** The boxes of blocks, of blocks of blocks and so on; the last is one box. */
std::vector<std::vector<BoundingBox>> boxesOf(std::span<const Vector3> positions)
{
  std::vector<std::vector<BoundingBox>> levels(1);
  levels[0].resize((positions.size() + BlockSize - 1) / BlockSize);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    levels[0][i / BlockSize].add(positions[i]);
  }
  while (levels.back().size() > 1)
  {
    const std::vector<BoundingBox>& inner = levels.back();
    std::vector<BoundingBox> outer((inner.size() + BlocksOfBlock - 1) / BlocksOfBlock);
    for (std::size_t i = 0; i < inner.size(); ++i)
    {
      outer[i / BlocksOfBlock].add(inner[i].low, inner[i].high);
    }
    levels.push_back(std::move(outer));
  }
  return levels;
}

/** Goes from large blocks to small ones. */
class LineSearch
{
public:
  LineSearch(std::span<const Vector3> positions, std::span<double> squares)
    : Positions(positions)
    , Squares(squares)
    , Boxes(boxesOf(positions))
    , Places(this->Boxes.size())
  {
  }

  void search(std::span<const Vector3> places)
  {
    if (!this->Positions.empty())
    {
      this->search(this->Boxes.size() - 1, 0, places);
    }
  }

private:
  /** @param places  those that may be the nearest one of a vertex of the block */
  void search(std::size_t level, std::size_t block, std::span<const Vector3> places)
  {
    const BoundingBox& box = this->Boxes[level][block];
    double most = std::numeric_limits<double>::infinity();
    for (const Vector3& place : places)
    {
      most = std::min(most, largestSquare(box, place));
    }
    std::vector<Vector3>& left = this->Places[level];
    left.clear();
    std::copy_if(places.begin(), places.end(), std::back_inserter(left),
      [&](const Vector3& place) { return leastSquare(box, place) <= most; });
    if (level == 0)
    {
      this->measure(block, left);
      return;
    }
    const std::size_t first = block * BlocksOfBlock;
    const std::size_t last = std::min(first + BlocksOfBlock, this->Boxes[level - 1].size());
    for (std::size_t inner = first; inner < last; ++inner)
    {
      this->search(level - 1, inner, left);
    }
  }

  void measure(std::size_t block, std::span<const Vector3> places)
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
    std::copy_n(least.begin(), count, this->Squares.begin() + first);
  }

  std::span<const Vector3> Positions;
  std::span<double> Squares;
  std::vector<std::vector<BoundingBox>> Boxes;
  /** What is left of the places in the present block of each level. */
  std::vector<std::vector<Vector3>> Places;
};

}

void squareLeastLines(
  const TriangleMesh& mesh, std::span<const Vector3> places, std::span<double> squares)
{
  LineSearch(mesh.positions(), squares).search(places);
}

}
