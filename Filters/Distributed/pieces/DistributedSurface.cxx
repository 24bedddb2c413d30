// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pieces/DistributedSurface.h"

#include "mesh/TriangleMesh.h"
#include "pieces/PointKeys.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace geodesic::distributed
{
namespace
{

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
  }
  return keys;
}

struct Known
{
  std::weak_ptr<const bridge::InputSurface> piece;
  /** See RankGroup::newNumber. */
  double number;
  std::weak_ptr<const DistributedSurface> surface;
};

}

std::shared_ptr<const DistributedSurface> DistributedSurface::of(
  RankGroup& ranks, const bridge::InputBlocks& blocks, const bridge::PointIdentity& identity)
{
  static std::vector<Known> known;
  std::shared_ptr<const bridge::InputSurface> piece;
  const ThreadTeam team(ranks.threadsOfThisRank());
  ranks.together([&] { piece = bridge::InputSurface::of(blocks, identity, team); });
  std::erase_if(known, [](const Known& k) { return k.surface.expired(); });
  const auto found = std::find_if(
    known.begin(), known.end(), [&](const Known& k) { return k.piece.lock() == piece; });
  if (ranks.haveSame(found == known.end() ? 0.0 : found->number))
  {
    return found->surface.lock();
  }
  auto built = std::make_shared<const DistributedSurface>(ranks, piece, blocks, identity);
  known.push_back({ piece, ranks.newNumber(), built });
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
  this->Divided = std::make_unique<const DividedMesh>(ranks, this->Piece->mesh(), keys);
}

}
