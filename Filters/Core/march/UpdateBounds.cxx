// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/UpdateBounds.h"

#include "march/TriangleMeasure.h"
#include "solve/Partition.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace geodesic
{
namespace
{

/** Measures the triangles round vertices, and stores the slacks of ring entries and the margins of
 * vertices. */
class RingMeasurer
{
public:
  RingMeasurer(const TriangleMesh& mesh, std::span<TriangleSlack> slacks, std::span<float> margins)
    : Mesh(mesh)
    , Slacks(slacks)
    , Margins(margins)
  {
  }

  /** Adds the triangles round a vertex. */
  void add(Index vertex)
  {
    this->Margins[vertex] = 0.0f;
    const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
    const std::uint32_t first = this->Mesh.rings().firstEntry(vertex);
    for (std::uint32_t i = 0; i < ring.size(); ++i)
    {
      if (!ring[i].opensTriangle())
      {
        this->Slacks[first + i] = TriangleSlack();
        continue;
      }
      this->Triangles[this->Count] = { vertex, ring[i].neighbour(), ring[i + 1].neighbour() };
      this->Entries[this->Count] = first + i;
      if (++this->Count == TriangleMeasurer::Most)
      {
        this->finish();
      }
    }
  }

  /** Measures what was added and not yet measured; to be called after the last vertex. */
  void finish()
  {
    this->Measurer.measure({ this->Triangles.data(), this->Count }, this->Mesh.positions());
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const TriangleMeasure measure = this->Measurer[i];
      this->Slacks[this->Entries[i]] = TriangleSlack(measure.slack, measure.isThin());
      float& margin = this->Margins[this->Triangles[i][0]];
      margin = std::max(margin, measure.margin);
    }
    this->Count = 0;
  }

private:
  const TriangleMesh& Mesh;
  std::span<TriangleSlack> Slacks;
  std::span<float> Margins;
  TriangleMeasurer Measurer;
  std::size_t Count = 0;
  std::array<Triangle, TriangleMeasurer::Most> Triangles;
  /** The numbers of the ring entries that open the triangles. */
  std::array<std::uint32_t, TriangleMeasurer::Most> Entries;
};

}

UpdateBounds::UpdateBounds(const TriangleMesh& mesh, const ThreadTeam& team)
  : Slacks(mesh.rings().numberOfEntries() + VertexRings::Overrun)
  , Margins(mesh.numberOfVertices())
{
  team.run(mesh.numberOfVertices(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      RingMeasurer measurer(mesh, this->Slacks, this->Margins);
      for (std::size_t v = first; v < last; ++v)
      {
        measurer.add(static_cast<Index>(v));
      }
      measurer.finish();
    });
  std::fill(this->Slacks.end() - VertexRings::Overrun, this->Slacks.end(), TriangleSlack());
  const double count = std::max(1.0, static_cast<double>(this->Margins.size()));
  this->MeanMargin = std::accumulate(this->Margins.begin(), this->Margins.end(), 0.0) / count;
}

AgreedMargins::AgreedMargins(const UpdateBounds& bounds, std::size_t labels, Partition& partition)
  : Own(bounds.margins())
{
  if (!partition.isDivided() || labels == 1)
  {
    return;
  }
  this->Agreed.assign(this->Own.begin(), this->Own.end());
  std::vector<StartValue> own;
  for (const Index vertex : partition.sharedVertices())
  {
    own.push_back({ vertex, 0, this->Own[vertex], false });
  }
  for (const StartValue& other : partition.exchange(own))
  {
    float& margin = this->Agreed[other.vertex];
    margin = std::max(margin, static_cast<float>(other.value));
  }
}

}
