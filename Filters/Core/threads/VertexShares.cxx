// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "threads/VertexShares.h"

#include "mesh/TriangleMesh.h"

#include <limits>
#include <numeric>

namespace geodesic
{
namespace
{

/** How many blocks each thread owns. With more of them the threads have work more evenly, but more
 * vertices lie at borders. */
constexpr std::size_t BlocksOfThread = 8;
/** How many vertices tell where a block lies. */
constexpr std::size_t Samples = 64;

/** The mean of some vertices of a block. */
Vector3 middleOf(const TriangleMesh& mesh, Index first, Index last)
{
  const std::size_t count = std::min<std::size_t>(Samples, last - first);
  Vector3 sum{};
  for (std::size_t i = 0; i < count; ++i)
  {
    sum = sum + mesh.position(first + static_cast<Index>((last - first) * i / count));
  }
  return (1.0 / static_cast<double>(std::max<std::size_t>(count, 1))) * sum;
}

}

VertexShares::VertexShares(const TriangleMesh& mesh, std::size_t threads)
  : NumberOfThreads(threads)
  , SizeOfBlock(std::max<std::size_t>(
      (mesh.numberOfVertices() + BlocksOfThread * threads - 1) / (BlocksOfThread * threads), 1))
  , Owners((mesh.numberOfVertices() + this->SizeOfBlock - 1) / this->SizeOfBlock, 0)
  , Slots(mesh.numberOfVertices(), NoSlot)
  , AreBeside(mesh.numberOfVertices(), 0)
{
  for (std::size_t block = 0; block < this->Owners.size(); ++block)
  {
    this->Middles.push_back(
      middleOf(mesh, this->firstOfBlock(block), this->firstOfBlock(block + 1)));
  }
  std::vector<std::uint32_t> blocks;
  std::size_t own = 0;
  for (Index vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    own += vertex == this->firstOfBlock(own + 1) ? 1 : 0;
    const Index first = this->firstOfBlock(own);
    const Index end = this->firstOfBlock(own + 1);
    blocks.clear();
    for (const RingEntry& entry : mesh.ring(vertex))
    {
      const Index neighbour = entry.neighbour();
      if (neighbour < first || neighbour >= end)
      {
        blocks.push_back(static_cast<std::uint32_t>(neighbour / this->SizeOfBlock));
      }
    }
    if (!blocks.empty())
    {
      blocks.push_back(static_cast<std::uint32_t>(own));
      std::sort(blocks.begin(), blocks.end());
      blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
      this->Slots[vertex] = static_cast<Slot>(this->AtBorders.size());
      this->AtBorders.push_back(vertex);
      this->StartsOfSlots.push_back(static_cast<std::uint32_t>(this->BlocksOfSlots.size()));
      this->BlocksOfSlots.insert(this->BlocksOfSlots.end(), blocks.begin(), blocks.end());
    }
  }
  this->StartsOfSlots.push_back(static_cast<std::uint32_t>(this->BlocksOfSlots.size()));
  this->ThreadsOfSlots.resize(this->AtBorders.size());
  for (const Index vertex : this->AtBorders)
  {
    this->AreBeside[vertex] = 1;
    for (const RingEntry& entry : mesh.ring(vertex))
    {
      this->AreBeside[entry.neighbour()] = 1;
    }
  }
}

void VertexShares::deal(std::span<const Vector3> origins)
{
  std::vector<double> distances(this->Owners.size(), std::numeric_limits<double>::infinity());
  for (std::size_t block = 0; block < distances.size(); ++block)
  {
    for (const Vector3& origin : origins)
    {
      distances[block] = std::min(distances[block], norm(this->Middles[block] - origin));
    }
  }
  std::vector<std::size_t> order(this->Owners.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
  // To and fro: whoever gets the farthest of some blocks gets the nearest of the next.
  const std::size_t threads = this->NumberOfThreads;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const std::size_t turn = i % (2 * threads);
    this->Owners[order[i]] = turn < threads ? turn : 2 * threads - 1 - turn;
  }
  for (std::size_t slot = 0; slot < this->ThreadsOfSlots.size(); ++slot)
  {
    Threads having = 0;
    for (std::uint32_t i = this->StartsOfSlots[slot]; i < this->StartsOfSlots[slot + 1]; ++i)
    {
      having |= Threads{ 1 } << this->Owners[this->BlocksOfSlots[i]];
    }
    this->ThreadsOfSlots[slot] = having;
  }
}

}
