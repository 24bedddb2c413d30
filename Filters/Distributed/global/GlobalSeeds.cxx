// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "global/GlobalSeeds.h"

#include "mesh/TriangleMesh.h"
#include "request/PointResolver.h"

#include <array>
#include <set>
#include <stdexcept>
#include <utility>

namespace geodesic::distributed
{
namespace
{

/** x y z of the source's points that no line uses. */
std::vector<double> loosePoints(const bridge::PointSource& source)
{
  std::vector<bool> isOnLine(source.coordinates.size() / 3, false);
  for (const auto& line : source.lines)
  {
    for (const std::size_t number : line)
    {
      isOnLine[number] = true;
    }
  }
  std::vector<double> loose;
  for (std::size_t i = 0; i < isOnLine.size(); ++i)
  {
    if (!isOnLine[i])
    {
      const double* point = source.coordinates.data() + 3 * i;
      loose.insert(loose.end(), point, point + 3);
    }
  }
  return loose;
}

}

BoundingBox boxOf(RankGroup& ranks, const TriangleMesh& mesh, std::span<const Seed> seeds)
{
  BoundingBox own;
  for (const Seed& seed : seeds)
  {
    for (const SurfacePoint& point : seed.points)
    {
      own.add(mesh.positionOf(point));
    }
    for (const Index vertex : seed.vertices)
    {
      own.add(mesh.position(vertex));
    }
  }
  std::array least{ own.low.x, own.low.y, own.low.z, -own.high.x, -own.high.y, -own.high.z };
  ranks.takeLeast(least);
  BoundingBox all;
  all.add({ least[0], least[1], least[2] }, { -least[3], -least[4], -least[5] });
  return all;
}

std::vector<Seed> seedsAt(std::vector<GlobalPoint> points)
{
  std::vector<Seed> seeds;
  for (GlobalPoint& point : points)
  {
    seeds.push_back(Seed::atPosition(point.position, std::move(point.local)));
  }
  return seeds;
}

std::vector<GlobalPoint> loosePointsOf(
  RankGroup& ranks, const DistributedSurface& surface, vtkDataObject* source)
{
  std::vector<double> loose;
  ranks.together(
    [&]
    {
      if (source)
      {
        loose = loosePoints(bridge::PointSource(source));
      }
    });
  return globalPointsAt(ranks, surface, pointsOfAll(ranks, loose), "SeedSource", Precision::Single);
}

std::vector<Seed> seedsOfRegions(RankGroup& ranks, bridge::RegionsByValue regions)
{
  std::vector<double> own;
  for (const auto& [value, vertices] : regions)
  {
    own.push_back(value);
  }
  const std::vector<double> all = ranks.gather(own);
  std::vector<Seed> seeds;
  for (const double value : std::set<double>(all.begin(), all.end()))
  {
    seeds.push_back(Seed::onRegion(std::move(regions[value])));
  }
  return seeds;
}

std::vector<Seed> seedsOfArray(RankGroup& ranks, const DistributedSurface& surface,
  const std::string& name, const std::function<bridge::ChosenArray()>& choose)
{
  bridge::RegionsByValue regions;
  bool isChosen = false;
  ranks.together(
    [&]
    {
      if (const auto array = choose())
      {
        isChosen = true;
        regions = bridge::regionsOfArray(surface.piece(), array);
      }
    });
  auto seeds = seedsOfRegions(ranks, std::move(regions));
  if (ranks.isAny(isChosen) && seeds.empty())
  {
    throw std::invalid_argument("SeedArray \"" + name +
      "\" is 0 on the whole surface, so it gives no seed. Choose another array, or None.");
  }
  return seeds;
}

std::vector<Seed> seedsOfSelection(RankGroup& ranks, const DistributedSurface& surface,
  vtkSelection* selection, vtkDataObject* input, const bridge::InputBlocks& blocks)
{
  bridge::RegionsByValue regions;
  bool isEmpty = true;
  ranks.together(
    [&]
    {
      if (selection)
      {
        const bridge::SelectedElements selected(selection, input, blocks);
        isEmpty = selected.isEmpty;
        regions = bridge::regionsOfSelection(surface.piece(), selected);
      }
    });
  auto seeds = seedsOfRegions(ranks, std::move(regions));
  if (ranks.isAny(!isEmpty) && seeds.empty())
  {
    throw std::invalid_argument(
      "SeedSelection has no point or cell of the surface. Select others.");
  }
  return seeds;
}

}
