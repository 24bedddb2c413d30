// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/RingNumbers.h"

#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace geodesic
{
namespace
{

/** The length of a triangle's longest side, rounded up. */
float longestSideOf(const Triangle& t, const Vector3* positions)
{
  const auto squaredSide = [&](int a, int b)
  {
    const Vector3 side = positions[t[a]] - positions[t[b]];
    return dot(side, side);
  };
  const double longest =
    std::sqrt(largest(squaredSide(0, 1), largest(squaredSide(1, 2), squaredSide(2, 0))));
  // Adds more than rounding to a float may take away.
  constexpr double relative = std::numeric_limits<float>::epsilon();
  constexpr double absolute = std::numeric_limits<float>::denorm_min();
  return static_cast<float>(longest * (1.0 + relative) + absolute);
}

/** Measures the triangles round vertices, TriangleNumbers::Most at a time. */
class RingPass
{
public:
  RingPass(const TriangleMesh& mesh, RingNumbers& numbers)
    : Mesh(mesh)
    , Numbers(numbers)
  {
    for (Index i = 0; i < this->Triangles.size(); ++i)
    {
      this->Triangles[i] = { 3 * i, 3 * i + 1, 3 * i + 2 };
    }
  }

  /** Adds the triangles round a vertex. */
  void add(Index vertex)
  {
    this->Numbers.ofVertices[vertex] = 0.0f;
    const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
    const std::uint32_t first = this->Mesh.rings().firstEntry(vertex);
    const Vector3 origin = this->Mesh.isIntrinsic() ? Vector3{} : this->Mesh.position(vertex);
    for (std::uint32_t i = 0; i < ring.size(); ++i)
    {
      if (!ring[i].opensTriangle())
      {
        this->Numbers.ofEntries[first + i] = this->Numbers.measurer->ofNoTriangle();
        continue;
      }
      this->Vertices[this->Count] = vertex;
      this->Entries[this->Count] = first + i;
      Vector3* const corners = &this->Corners[3 * this->Count];
      corners[0] = origin;
      for (std::size_t k = 0; k < 2; ++k)
      {
        corners[k + 1] = this->Mesh.isIntrinsic() ? this->Mesh.toNeighbour(vertex, i + k)
                                                  : this->Mesh.position(ring[i + k].neighbour());
      }
      if (++this->Count == TriangleNumbers::Most)
      {
        this->finish();
      }
    }
  }

  /** Measures what was added and not yet measured; to be called after the last vertex. */
  void finish()
  {
    measureTriangles(this->Numbers.measurer, { this->Triangles.data(), this->Count }, this->Corners,
      this->Measured);
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      this->Numbers.ofEntries[this->Entries[i]] = this->Measured.ofEntries[i];
      float& ofVertex = this->Numbers.ofVertices[this->Vertices[i]];
      ofVertex = std::max(ofVertex, this->Measured.ofVertices[i]);
    }
    this->Count = 0;
  }

private:
  const TriangleMesh& Mesh;
  RingNumbers& Numbers;
  TriangleNumbers Measured;
  std::size_t Count = 0;
  /** The triangles, each by the numbers of three corners. */
  std::array<Triangle, TriangleNumbers::Most> Triangles;
  std::array<Vector3, 3 * TriangleNumbers::Most> Corners;
  /** The vertices round which they were added. */
  std::array<Index, TriangleNumbers::Most> Vertices;
  /** The numbers of the ring entries that open the triangles. */
  std::array<std::uint32_t, TriangleNumbers::Most> Entries;
};

}

void measureTriangles(const RingMeasurer* measurer, std::span<const Triangle> triangles,
  std::span<const Vector3> positions, TriangleNumbers& numbers)
{
  if (measurer)
  {
    measurer->measure(triangles, positions, numbers);
    return;
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    numbers.longestSides[i] = longestSideOf(triangles[i], positions.data());
  }
}

std::shared_ptr<const RingNumbers> ringNumbers(
  const TriangleMesh& mesh, const RingMeasurer& measurer, const ThreadTeam& team)
{
  if (mesh.measurer() == &measurer)
  {
    return mesh.numbers();
  }
  const auto numbers = std::make_shared<RingNumbers>();
  numbers->measurer = &measurer;
  numbers->ofEntries.resize(mesh.rings().numberOfEntries() + VertexRings::Overrun);
  numbers->ofVertices.resize(mesh.numberOfVertices());
  team.run(mesh.numberOfVertices(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      RingPass pass(mesh, *numbers);
      for (std::size_t v = first; v < last; ++v)
      {
        pass.add(static_cast<Index>(v));
      }
      pass.finish();
    });
  std::fill(numbers->ofEntries.end() - VertexRings::Overrun, numbers->ofEntries.end(),
    measurer.ofNoTriangle());
  return numbers;
}

}
