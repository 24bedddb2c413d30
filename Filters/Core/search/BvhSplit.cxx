// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/BvhSplit.h"

#include "base/BoundingBox.h"
#include "mesh/MortonCurve.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <numeric>

namespace geodesic
{

BvhSplit::BvhSplit(const TriangleMesh& mesh)
  : Jumps(mesh.numberOfTriangles())
{
  BoundingBox box;
  for (const Vector3& p : mesh.positions())
  {
    box.add(p);
  }
  const MortonCurve curve(box);
  Index vertex = NoIndex;
  std::uint64_t code = 0;
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    // Triangles follow the order of their lowest vertex, and vertices the curve.
    const Triangle& corners = mesh.triangle(t);
    const Index lowest = std::min({ corners[0], corners[1], corners[2] });
    if (lowest != vertex)
    {
      vertex = lowest;
      const std::uint64_t before = code;
      code = curve.codeOf(mesh.position(vertex));
      this->Jumps[t] = static_cast<std::uint8_t>(std::bit_width(before ^ code));
    }
  }
}

Index BvhSplit::cut(Index first, Index last) const
{
  const Index margin = std::max<Index>((last - first) / 8, 1);
  const auto low = this->Jumps.begin() + first + margin;
  const auto high = this->Jumps.begin() + last - margin + 1;
  const auto farther = [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); };
  const std::uint8_t farthest = std::reduce(low, high, std::uint8_t{ 0 }, farther);
  const auto middle = low + (high - low) / 2;
  const auto behind = std::find(middle, high, farthest);
  const auto before =
    std::find(std::reverse_iterator(middle), std::reverse_iterator(low), farthest);
  const bool isBefore = behind == high || before - std::reverse_iterator(middle) < behind - middle;
  return static_cast<Index>((isBefore ? before.base() - 1 : behind) - this->Jumps.begin());
}

}
