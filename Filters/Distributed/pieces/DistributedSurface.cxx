// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pieces/DistributedSurface.h"

#include "filter/VtkVersions.h"
#include "input/BlockNumbering.h"
#include "mesh/TriangleMesh.h"
#include "pieces/PointKeys.h"
#include "ranks/RankCache.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace geodesic::distributed
{
namespace
{

/**
 * Refuses a negative global id, with which it would not be known on which other ranks the point is.
 * Only points that VTK made inside curved faces may have -1: no other rank has them.
 */
void checkGlobalId(
  const bridge::BlockNumbering& numbering, const bridge::InputBlocks& blocks, Index point)
{
  const vtkIdType id = numbering.idOfPoint(point);
  if (id < -1 || !blocks[numbering.blockOfPoint(point)].outerSurface)
  {
    throw std::invalid_argument("A point of the surface has the global id " + std::to_string(id) +
      ", but on several ranks ids must be 0 or more. Make the ids again for all ranks together, " +
      bridge::MakeGlobalIds + ", or remove the array.");
  }
}

std::vector<Key> keysOf(const bridge::InputSurface& surface, const bridge::InputBlocks& blocks,
  const bridge::PointIdentity& identity)
{
  const TriangleMesh& mesh = *surface.mesh();
  const PointKeys pointKeys(blocks, identity);
  std::vector<Key> keys;
  keys.reserve(mesh.numberOfVertices());
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    const Index point = mesh.pointOfVertex(v);
    keys.push_back(pointKeys.of(point, mesh.position(v), surface.numbering().blockNumberOf(point)));
    if (keys.back() == NoKey)
    {
      checkGlobalId(surface.numbering(), blocks, point);
    }
  }
  return keys;
}

/** A surface that was built before, and the piece that it was built for. */
struct Known
{
  bool isExpired() const { return this->surface.expired(); }

  std::weak_ptr<const bridge::InputSurface> piece;
  std::weak_ptr<const DistributedSurface> surface;
};

}

std::shared_ptr<const DistributedSurface> DistributedSurface::of(RankGroup& ranks,
  const bridge::InputBlocks& blocks, const bridge::PointIdentity& identity, const ThreadTeam& team)
{
  static RankCache<Known> cache;
  std::shared_ptr<const bridge::InputSurface> piece;
  ranks.together([&] { piece = bridge::InputSurface::of(blocks, identity, team); });
  const auto found = cache.find(ranks, [&](const Known& k) { return k.piece.lock() == piece; });
  // Meanwhile another filter may have let go of it.
  auto surface = found ? found->surface.lock() : nullptr;
  if (!ranks.isAny(!surface))
  {
    return surface;
  }
  auto built = std::make_shared<const DistributedSurface>(ranks, piece, blocks, identity);
  cache.add(ranks, { piece, built });
  return built;
}

DistributedSurface::DistributedSurface(RankGroup& ranks,
  std::shared_ptr<const bridge::InputSurface> piece, const bridge::InputBlocks& blocks,
  const bridge::PointIdentity& identity)
  : Piece(std::move(piece))
{
  const TriangleMesh& mesh = this->mesh();
  std::array largest{ -static_cast<double>(mesh.numberOfTriangles()),
    -static_cast<double>(mesh.numberOfPoints()) };
  ranks.takeLeast(largest);
  this->MostPoints = static_cast<vtkIdType>(-largest[1]);
  if (largest[0] == 0.0)
  {
    throw std::invalid_argument(
      "The input has no surface: no triangle, polygon or strip with an "
      "area on any rank. Give a surface, for example by Extract Surface.");
  }
  std::vector<Key> keys;
  if (ranks.size() > 1)
  {
    ranks.together([&] { keys = keysOf(*this->Piece, blocks, identity); });
  }
  this->Divided = std::make_shared<const DividedMesh>(ranks, this->Piece->mesh(), keys);
}

}
