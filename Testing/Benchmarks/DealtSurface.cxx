// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DealtSurface.h"

#include "base/BoundingBox.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

namespace geodesic::testing
{
namespace
{

/** Cuts triangles into patches with numbers from @p first on. */
void cut(std::span<Index> triangles, const std::vector<Vector3>& middles, int first, int count,
  std::vector<int>& patches)
{
  if (count == 1)
  {
    for (const Index triangle : triangles)
    {
      patches[triangle] = first;
    }
    return;
  }
  BoundingBox box;
  for (const Index triangle : triangles)
  {
    box.add(middles[triangle]);
  }
  const Vector3 size = box.high - box.low;
  constexpr std::array axes{ &Vector3::x, &Vector3::y, &Vector3::z };
  const auto axis = *std::max_element(axes.begin(), axes.end(),
    [&](double Vector3::*a, double Vector3::*b) { return size.*a < size.*b; });
  const int half = count / 2;
  const auto middle = triangles.begin() +
    static_cast<std::ptrdiff_t>(triangles.size() * static_cast<std::size_t>(half) / count);
  std::nth_element(triangles.begin(), middle, triangles.end(),
    [&](Index a, Index b) { return middles[a].*axis < middles[b].*axis; });
  cut({ triangles.begin(), middle }, middles, first, half, patches);
  cut({ middle, triangles.end() }, middles, first + half, count - half, patches);
}

}

std::vector<int> dealt(const Surface& surface, int ranks, int patches)
{
  std::vector<Vector3> middles;
  for (const auto& [a, b, c] : surface.triangles)
  {
    const Vector3 sum = surface.points[a] + surface.points[b] + surface.points[c];
    middles.push_back((1.0 / 3.0) * sum);
  }
  std::vector<Index> triangles(surface.triangles.size());
  std::iota(triangles.begin(), triangles.end(), Index{ 0 });
  std::vector<int> owners(triangles.size());
  cut(triangles, middles, 0, ranks * patches, owners);
  for (int& owner : owners)
  {
    owner %= ranks;
  }
  return owners;
}

std::vector<Piece> piecesOf(const Surface& surface, const std::vector<int>& owners, int ranks)
{
  std::vector<Piece> pieces(ranks);
  for (std::size_t t = 0; t < owners.size(); ++t)
  {
    Piece& piece = pieces[owners[t]];
    piece.surface.triangles.push_back(surface.triangles[t]);
    const Triangle& corners = surface.triangles[t];
    piece.points.insert(piece.points.end(), corners.begin(), corners.end());
  }
  std::vector<Index> numbers(surface.points.size());
  for (Piece& piece : pieces)
  {
    std::sort(piece.points.begin(), piece.points.end());
    piece.points.erase(std::unique(piece.points.begin(), piece.points.end()), piece.points.end());
    for (const Index point : piece.points)
    {
      numbers[point] = static_cast<Index>(piece.surface.points.size());
      piece.surface.points.push_back(surface.points[point]);
    }
    for (Triangle& triangle : piece.surface.triangles)
    {
      for (Index& corner : triangle)
      {
        corner = numbers[corner];
      }
    }
  }
  return pieces;
}

std::vector<Index> pointsOnCuts(const Surface& surface, const std::vector<int>& owners)
{
  constexpr int nobody = -1;
  constexpr int several = -2;
  std::vector<int> ownerOfPoint(surface.points.size(), nobody);
  for (std::size_t t = 0; t < owners.size(); ++t)
  {
    for (const Index corner : surface.triangles[t])
    {
      int& owner = ownerOfPoint[corner];
      owner = owner == nobody || owner == owners[t] ? owners[t] : several;
    }
  }
  std::vector<Index> points;
  for (Index point = 0; point < ownerOfPoint.size(); ++point)
  {
    if (ownerOfPoint[point] == several)
    {
      points.push_back(point);
    }
  }
  return points;
}

}
