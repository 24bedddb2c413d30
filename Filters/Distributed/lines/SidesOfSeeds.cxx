// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lines/SidesOfSeeds.h"

#include "lines/GlobalSides.h"
#include "split/SplitMesh.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace geodesic::distributed
{

void SidesOfSeeds::update(
  RankGroup& ranks, const LinedSurface& surface, const std::vector<Seed>& seeds)
{
  const auto noLine = std::find_if(
    seeds.begin(), seeds.end(), [](const Seed& seed) { return seed.kind != Seed::Kind::Curve; });
  if (noLine != seeds.end())
  {
    throw std::invalid_argument("Signed needs lines as seeds, but seed " +
      std::to_string(noLine - seeds.begin()) +
      " is not a line. Use only lines of SeedSource as seeds, or turn Signed off.");
  }
  const auto& mesh = surface.mesh();
  if (!this->Mesh || &this->Mesh->mesh() != mesh.get())
  {
    this->Mesh = std::make_shared<const RegionMesh>(mesh);
    this->Signs.clear();
  }
  const bool isNew = this->Signs.empty() && mesh->numberOfVertices() > 0;
  const bool isChanged = this->Lines != surface.seedPaths() ||
    this->BarrierLines != surface.barrierPaths() || this->Barriers != surface.barriers();
  if (ranks.isAny(isNew || isChanged))
  {
    this->Signs = globalSides(ranks, surface, this->Mesh, "SeedSource");
    this->Lines = surface.seedPaths();
    this->BarrierLines = surface.barrierPaths();
    this->Barriers = surface.barriers();
  }
}

void SidesOfSeeds::clear()
{
  this->Signs.clear();
  this->Mesh.reset();
}

void SidesOfSeeds::check(const LinedSurface& surface, const DistanceField& field) const
{
  const SplitMesh* split = surface.split();
  for (Index vertex = 0; vertex < this->Signs.size(); ++vertex)
  {
    if (this->Signs[vertex] == 0 && field.isReached(split ? split->vertexOf(vertex) : vertex))
    {
      throw std::invalid_argument(
        "A part of the surface touches the lines of SeedSource only at single points, so it is on "
        "neither side of them. Remove that part, or turn Signed off.");
    }
  }
}

}
