// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/TriangleSides.h"

#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

namespace geodesic
{
namespace
{

/** A side with the higher one of its two vertices. */
struct SideEnd
{
  Index vertex;
  Index side;

  friend bool operator<(const SideEnd& a, const SideEnd& b)
  {
    return std::tie(a.vertex, a.side) < std::tie(b.vertex, b.side);
  }
};

}

TriangleSides::TriangleSides(const TriangleMesh& mesh)
  : Next(std::size_t{ 3 } * mesh.numberOfTriangles())
{
  std::iota(this->Next.begin(), this->Next.end(), Index{ 0 });
  const auto visitSides = [&](const auto& visit)
  {
    for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
    {
      const Triangle& corners = mesh.triangle(t);
      for (Index i = 0; i < 3; ++i)
      {
        const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
        visit(low, SideEnd{ high, 3 * t + i });
      }
    }
  };
  // The sides by their lower vertex, then by their higher one: those of an edge come together.
  std::vector<Index> starts(mesh.numberOfVertices() + std::size_t{ 1 }, 0);
  visitSides([&](Index low, const SideEnd&) { ++starts[low + 1]; });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<SideEnd> ends(this->Next.size());
  std::vector<Index> places(starts.begin(), starts.end() - 1);
  visitSides([&](Index low, const SideEnd& end) { ends[places[low]++] = end; });
  for (Index vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    const std::span<SideEnd> here(ends.begin() + starts[vertex], ends.begin() + starts[vertex + 1]);
    std::sort(here.begin(), here.end());
    std::size_t first = 0;
    for (std::size_t i = 0; i < here.size(); ++i)
    {
      const bool isLast = i + 1 == here.size() || here[i + 1].vertex != here[i].vertex;
      this->Next[here[i].side] = here[isLast ? first : i + 1].side;
      first = isLast ? i + 1 : first;
    }
  }
}

}
