// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/MotionTable.h"

#include "base/Interruption.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace geodesic
{
namespace
{

/** A corner of a triangle, by its vertex and the ends of the opposite side. */
struct CornerOfRing
{
  /** @param number  of the triangle, or of the entry that opens it */
  CornerOfRing(Index vertex, Index a, Index b, Index number)
    : vertex(vertex)
    , lower(std::min(a, b))
    , higher(std::max(a, b))
    , number(number)
  {
  }

  /** Whether a side has these ends. */
  bool isBetween(Index a, Index b) const
  {
    return (a == this->lower && b == this->higher) || (a == this->higher && b == this->lower);
  }

  friend auto operator<=>(const CornerOfRing&, const CornerOfRing&) = default;

  Index vertex;
  Index lower;
  Index higher;
  Index number;
};

/** Numbers of one triangle of which each vertex takes the largest. */
struct VertexNumbers
{
  void takeLargest(const VertexNumbers& other)
  {
    this->longestSide = std::max(this->longestSide, other.longestSide);
    this->ofVertex = std::max(this->ofVertex, other.ofVertex);
  }

  float longestSide = 0.0f;
  float ofVertex = 0.0f;
};

/** The numbers of all triangles, and at the end those of none. */
struct NumbersOfTriangles
{
  /** Measures the triangles from @p first to before @p last. */
  void measure(const TriangleMesh& mesh, std::span<const Vector3> positions, std::size_t first,
    std::size_t last)
  {
    TriangleNumbers numbers;
    while (first < last)
    {
      Interruption::check();
      const std::size_t count = std::min(TriangleNumbers::Most, last - first);
      measureTriangles(mesh.measurer(), mesh.triangles().subspan(first, count), positions, numbers);
      for (std::size_t i = 0; i < count; ++i)
      {
        this->ofVertices[first + i] = { numbers.longestSides[i], numbers.ofVertices[i] };
        this->ofEntries[first + i] = numbers.ofEntries[i];
      }
      first += count;
    }
  }

  BulkVector<VertexNumbers> ofVertices;
  BulkVector<EntryNumber> ofEntries;
};

}

MotionTable::MotionTable(const TriangleMesh& mesh)
  : TriangleOfEntry(mesh.rings().numberOfEntries())
{
  std::fill(this->TriangleOfEntry.begin(), this->TriangleOfEntry.end(), mesh.numberOfTriangles());
  this->linkEntries(mesh);
  this->listMergedPoints(mesh);
}

void MotionTable::linkEntries(const TriangleMesh& mesh)
{
  // In a long ring entries are found by sorting: linear search would take quadratic time.
  constexpr std::size_t longRing = 32;
  std::vector<CornerOfRing> inLongRings;
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    Interruption::checkAt(t);
    const Triangle& corners = mesh.triangle(t);
    for (int c = 0; c < 3; ++c)
    {
      const Index vertex = corners[c];
      const CornerOfRing corner(vertex, corners[(c + 1) % 3], corners[(c + 2) % 3], t);
      const std::span<const RingEntry> ring = mesh.ring(vertex);
      if (ring.size() > longRing)
      {
        inLongRings.push_back(corner);
        continue;
      }
      Index* const linked = &this->TriangleOfEntry[mesh.rings().firstEntry(vertex)];
      for (std::size_t i = 0;; ++i)
      {
        if (ring[i].opensTriangle() && linked[i] == mesh.numberOfTriangles() &&
          corner.isBetween(ring[i].neighbour(), ring[i + 1].neighbour()))
        {
          linked[i] = t;
          break;
        }
      }
    }
  }
  std::sort(inLongRings.begin(), inLongRings.end());
  std::vector<CornerOfRing> entries;
  for (std::size_t first = 0; first < inLongRings.size(); first += entries.size())
  {
    const Index vertex = inLongRings[first].vertex;
    const std::span<const RingEntry> ring = mesh.ring(vertex);
    const std::uint32_t firstEntry = mesh.rings().firstEntry(vertex);
    entries.clear();
    for (Index i = 0; i < ring.size(); ++i)
    {
      if (ring[i].opensTriangle())
      {
        entries.emplace_back(vertex, ring[i].neighbour(), ring[i + 1].neighbour(), firstEntry + i);
      }
    }
    std::sort(entries.begin(), entries.end());
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
      this->TriangleOfEntry[entries[i].number] = inLongRings[first + i].number;
    }
  }
}

void MotionTable::listMergedPoints(const TriangleMesh& mesh)
{
  const auto list = [&](Index point, Index vertex)
  {
    if (mesh.pointOfVertex(vertex) != point)
    {
      this->MergedPoints.push_back({ point, vertex });
    }
  };
  for (Index point = 0; point < mesh.numberOfPoints(); ++point)
  {
    if (const Index vertex = mesh.vertexOfPoint(point); vertex != NoIndex)
    {
      list(point, vertex);
    }
  }
  for (const TriangleMesh::BarePoint& bare : mesh.BarePoints)
  {
    list(bare.point, bare.vertex);
  }
}

bool MotionTable::areMergedTogether(
  std::span<const Vector3> points, std::span<const Vector3> positions) const
{
  return std::all_of(this->MergedPoints.begin(), this->MergedPoints.end(),
    [&](const MergedPoint& merged) { return points[merged.point] == positions[merged.vertex]; });
}

MotionTable::Measured MotionTable::measure(
  const TriangleMesh& mesh, std::span<const Vector3> positions, const ThreadTeam& team) const
{
  const RingMeasurer* const measurer = mesh.measurer();
  const std::size_t triangles = mesh.numberOfTriangles();
  NumbersOfTriangles ofTriangles;
  ofTriangles.ofVertices.resize(triangles + 1);
  ofTriangles.ofVertices.back() = {};
  ofTriangles.ofEntries.resize(triangles + 1);
  ofTriangles.ofEntries.back() = measurer ? measurer->ofNoTriangle() : EntryNumber{};
  team.run(triangles,
    [&](std::size_t, std::size_t first, std::size_t last)
    { ofTriangles.measure(mesh, positions, first, last); });
  Measured measured;
  measured.longestSides.resize(positions.size());
  const auto numbers = measurer ? std::make_shared<RingNumbers>() : nullptr;
  if (numbers)
  {
    numbers->measurer = measurer;
    numbers->ofVertices.resize(positions.size());
    numbers->ofEntries.resize(this->TriangleOfEntry.size() + VertexRings::Overrun);
    std::fill(numbers->ofEntries.end() - VertexRings::Overrun, numbers->ofEntries.end(),
      measurer->ofNoTriangle());
  }
  team.run(positions.size(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      const VertexNumbers* const ofVertices = ofTriangles.ofVertices.data();
      const Index* const triangleOf = this->TriangleOfEntry.data();
      for (std::size_t v = first; v < last; ++v)
      {
        const std::size_t begin = mesh.rings().firstEntry(static_cast<Index>(v));
        const std::size_t end = begin + mesh.ring(static_cast<Index>(v)).size();
        VertexNumbers largest;
        for (std::size_t i = begin; i < end; ++i)
        {
          largest.takeLargest(ofVertices[triangleOf[i]]);
        }
        measured.longestSides[v] = largest.longestSide;
        if (numbers)
        {
          numbers->ofVertices[v] = largest.ofVertex;
          std::transform(triangleOf + begin, triangleOf + end, numbers->ofEntries.data() + begin,
            [from = ofTriangles.ofEntries.data()](Index t) { return from[t]; });
        }
      }
    });
  measured.numbers = numbers;
  return measured;
}

}
