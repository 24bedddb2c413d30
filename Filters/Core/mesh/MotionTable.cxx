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

/** The numbers of one triangle, side by side, as each ring entry reads all of them. */
struct OfTriangle
{
  float longestSide = 0.0f;
  float ofVertex = 0.0f;
  EntryNumber ofEntry = 0;
};

void measureAll(const RingMeasurer* measurer, std::span<const Triangle> triangles,
  std::span<const Vector3> positions, std::span<OfTriangle> measured)
{
  TriangleNumbers numbers;
  for (std::size_t first = 0; first < triangles.size(); first += TriangleNumbers::Most)
  {
    Interruption::check();
    const std::size_t count = std::min(TriangleNumbers::Most, triangles.size() - first);
    measureTriangles(measurer, triangles.subspan(first, count), positions, numbers);
    for (std::size_t i = 0; i < count; ++i)
    {
      measured[first + i] = { numbers.longestSides[i], numbers.ofVertices[i],
        numbers.ofEntries[i] };
    }
  }
}

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
  BulkVector<OfTriangle> ofTriangles(triangles + 1);
  ofTriangles.back() = { 0.0f, 0.0f, measurer ? measurer->ofNoTriangle() : EntryNumber{} };
  team.run(triangles,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      measureAll(measurer, mesh.triangles().subspan(first, last - first), positions,
        std::span(ofTriangles).subspan(first, last - first));
    });
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
      const OfTriangle* const from = ofTriangles.data();
      const Index* const triangleOf = this->TriangleOfEntry.data();
      EntryNumber* const ofEntries = numbers ? numbers->ofEntries.data() : nullptr;
      for (std::size_t v = first; v < last; ++v)
      {
        const std::size_t begin = mesh.rings().firstEntry(static_cast<Index>(v));
        const std::size_t end = begin + mesh.ring(static_cast<Index>(v)).size();
        OfTriangle largest;
        for (std::size_t i = begin; i < end; ++i)
        {
          const OfTriangle& own = from[triangleOf[i]];
          largest.longestSide = std::max(largest.longestSide, own.longestSide);
          largest.ofVertex = std::max(largest.ofVertex, own.ofVertex);
          if (ofEntries)
          {
            ofEntries[i] = own.ofEntry;
          }
        }
        measured.longestSides[v] = largest.longestSide;
        if (numbers)
        {
          numbers->ofVertices[v] = largest.ofVertex;
        }
      }
    });
  measured.numbers = numbers;
  return measured;
}

}
