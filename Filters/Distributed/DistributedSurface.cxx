// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedSurface.h"

#include "TriangleMesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string>

namespace geodesic::distributed
{
namespace
{

/** By how the points of all ranks are one; see bridge::identityOf. */
bridge::PointIdentity identityOf(RankGroup& ranks, const bridge::InputBlocks& blocks,
  bool mergeCoincidentPoints, bool connectBlocks)
{
  if (ranks.size() == 1)
  {
    return bridge::identityOf(blocks, mergeCoincidentPoints, connectBlocks);
  }
  double haveIds = blocks.haveGlobalPointIds() ? 1.0 : 0.0;
  ranks.takeLeast({ &haveIds, 1 });
  const bridge::PointIdentity identity{ bridge::identityBy(haveIds > 0.0, mergeCoincidentPoints),
    connectBlocks, ranks.rank() };
  if (identity.by == bridge::PointIdentity::By::Nothing)
  {
    throw std::invalid_argument("The surface is spread over " + std::to_string(ranks.size()) +
      " ranks and nothing tells which points of the pieces are one. Turn MergeCoincidentPoints on, "
      "or give the points global ids by Generate Global Ids.");
  }
  return identity;
}

std::vector<PointKey> keysOf(const bridge::InputSurface& surface, const bridge::InputBlocks& blocks,
  const bridge::PointIdentity& identity)
{
  const TriangleMesh& mesh = *surface.mesh();
  std::vector<vtkIdType> ids;
  if (identity.by == bridge::PointIdentity::By::GlobalIds)
  {
    ids = bridge::globalPointIdsOf(blocks);
  }
  // Adding 0 makes -0 one with 0.
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };
  std::vector<PointKey> keys;
  keys.reserve(mesh.numberOfVertices());
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    const Index point = mesh.pointOfVertex(v);
    const Vector3& p = mesh.position(v);
    // Blocks that are not connected have points of their own.
    const std::uint64_t block = identity.acrossBlocks ? 0 : surface.numbering().flatIndexOf(point);
    keys.push_back(ids.empty() ? PointKey{ bits(p.x), bits(p.y), bits(p.z), block }
                               : PointKey{ static_cast<std::uint64_t>(ids[point]), 0, 0, block });
  }
  return keys;
}

struct Known
{
  std::weak_ptr<const bridge::InputSurface> piece;
  /** Equal for what ranks built together. */
  double number;
  std::weak_ptr<const DistributedSurface> surface;
};

}

std::shared_ptr<const DistributedSurface> DistributedSurface::of(RankGroup& ranks,
  const bridge::InputBlocks& blocks, bool mergeCoincidentPoints, bool connectBlocks)
{
  static std::vector<Known> known;
  static double lastNumber = 0.0;
  const bridge::PointIdentity identity =
    identityOf(ranks, blocks, mergeCoincidentPoints, connectBlocks);
  std::shared_ptr<const bridge::InputSurface> piece;
  const ThreadTeam team(ranks.threadsOfThisRank());
  ranks.together([&] { piece = bridge::InputSurface::of(blocks, identity, team); });
  std::erase_if(known, [](const Known& k) { return k.surface.expired(); });
  const auto found = std::find_if(
    known.begin(), known.end(), [&](const Known& k) { return k.piece.lock() == piece; });
  const double number = found == known.end() ? 0.0 : found->number;
  const std::vector<double> numbers = ranks.gather({ &number, 1 });
  if (number > 0.0 &&
    std::all_of(numbers.begin(), numbers.end(), [&](double n) { return n == number; }))
  {
    return found->surface.lock();
  }
  auto built = std::make_shared<const DistributedSurface>(ranks, piece, blocks, identity);
  const std::vector<double> lasts = ranks.gather({ &lastNumber, 1 });
  lastNumber = *std::max_element(lasts.begin(), lasts.end()) + 1.0;
  known.push_back({ piece, lastNumber, built });
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
  std::vector<PointKey> keys;
  if (ranks.size() > 1)
  {
    ranks.together([&] { keys = keysOf(*this->Piece, blocks, identity); });
  }
  this->Shared = std::make_unique<const SharedPoints>(ranks, mesh, keys);
  if (ranks.size() > 1)
  {
    this->agreeOnLongestEdges(ranks);
  }
  this->chooseStep(ranks);
}

void DistributedSurface::agreeOnLongestEdges(RankGroup& ranks)
{
  this->LongestEdges.resize(this->mesh().numberOfVertices());
  for (Index v = 0; v < this->LongestEdges.size(); ++v)
  {
    this->LongestEdges[v] = static_cast<float>(this->mesh().longestEdgeAround(v));
  }
  this->Shared->takeLargest<float>(ranks, this->LongestEdges);
}

void DistributedSurface::chooseStep(RankGroup& ranks)
{
  const auto vertices = static_cast<double>(this->mesh().numberOfVertices());
  const auto shared = static_cast<double>(this->Shared->vertices().size());
  constexpr double atSharedVertex = 0.1;
  constexpr double least = 0.5;
  this->StepInEdges = std::max(least, atSharedVertex * ranks.sum(vertices) / ranks.sum(shared));
}

}
