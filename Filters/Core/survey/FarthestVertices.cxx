// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey/FarthestVertices.h"

#include "base/Interruption.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace geodesic
{
namespace
{

/** The floor in parts of the largest distance. */
constexpr double FloorPart = 0.9;

}

bool isBefore(const Vector3& a, const Vector3& b)
{
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

FarthestVertices::FarthestVertices(
  const TriangleMesh& mesh, std::span<const double> distances, std::span<const std::uint8_t> isOpen)
  : Mesh(mesh)
  , Distances(distances)
  , IsOpen(isOpen)
  , Floor(std::numeric_limits<double>::infinity())
  , Level(this->Floor)
{
}

double FarthestVertices::farthest()
{
  while (true)
  {
    while (!this->Heap.empty())
    {
      const Waiting first = this->Heap.front();
      if (first.distance == this->Distances[first.vertex])
      {
        return first.distance;
      }
      this->takeFarthest();
      this->wait(first.vertex);
    }
    if (!this->lowerFloor())
    {
      return 0.0;
    }
  }
}

void FarthestVertices::setLevel(double level)
{
  this->Level = level;
  this->Looks = 0;
  this->AtLevel.clear();
  if (level < this->Floor)
  {
    this->lowerFloor();
  }
  if (level == this->Floor)
  {
    for (const Waiting& waiting : this->Heap)
    {
      Interruption::checkAt(this->AtLevel.size());
      this->tie(waiting.vertex);
    }
    this->Heap.clear();
  }
  while (!this->Heap.empty() && this->farthest() >= level)
  {
    this->tie(this->takeFarthest().vertex);
  }
}

void FarthestVertices::tie(Index vertex)
{
  this->AtLevel.push_back({ this->Mesh.position(vertex), vertex });
}

Index FarthestVertices::firstAtLevel()
{
  ++this->Looks;
  if (this->Looks == 1 && !this->AtLevel.empty())
  {
    return std::max_element(this->AtLevel.begin(), this->AtLevel.end())->vertex;
  }
  if (this->Looks == 2)
  {
    this->sortTied();
  }
  while (!this->AtLevel.empty() && !this->isAtLevel(this->AtLevel.back()))
  {
    this->wait(this->AtLevel.back().vertex);
    this->AtLevel.pop_back();
  }
  return this->AtLevel.empty() ? NoIndex : this->AtLevel.back().vertex;
}

void FarthestVertices::sortTied()
{
  const auto fallen = std::partition(this->AtLevel.begin(), this->AtLevel.end(),
    [&](const Tied& tied) { return this->isAtLevel(tied); });
  std::for_each(fallen, this->AtLevel.end(), [&](const Tied& tied) { this->wait(tied.vertex); });
  this->AtLevel.erase(fallen, this->AtLevel.end());
  std::sort(this->AtLevel.begin(), this->AtLevel.end());
}

std::vector<Index> FarthestVertices::apartFrom(
  Index first, std::size_t most, std::span<const double> cost) const
{
  constexpr std::size_t candidatesOfEach = 4;
  const auto costOf = [&](Index a, Index b)
  { return cost.empty() ? 1.0 : 0.5 * (cost[a] + cost[b]); };
  std::vector<Index> apart{ first };
  for (const Index vertex : this->farthestOnes(candidatesOfEach * most))
  {
    const auto isApartFrom = [&](Index other)
    {
      const double length = norm(this->Mesh.position(vertex) - this->Mesh.position(other));
      return vertex != other && costOf(vertex, other) * length >= this->Distances[vertex];
    };
    if (apart.size() < most && std::all_of(apart.begin(), apart.end(), isApartFrom))
    {
      apart.push_back(vertex);
    }
  }
  return apart;
}

std::vector<Index> FarthestVertices::farthestOnes(std::size_t most) const
{
  std::vector<Index> ones;
  for (const Waiting& waiting : this->Heap)
  {
    // One that has fallen is no longer far.
    if (waiting.distance == this->Distances[waiting.vertex])
    {
      ones.push_back(waiting.vertex);
    }
  }
  for (const Tied& tied : this->AtLevel)
  {
    if (this->isAtLevel(tied))
    {
      ones.push_back(tied.vertex);
    }
  }
  const auto isFarther = [&](Index a, Index b) { return this->Distances[a] > this->Distances[b]; };
  if (most < ones.size())
  {
    std::nth_element(
      ones.begin(), ones.begin() + static_cast<std::ptrdiff_t>(most), ones.end(), isFarther);
    ones.resize(most);
  }
  std::sort(ones.begin(), ones.end(), isFarther);
  // Tied ones follow each other now.
  for (auto begin = ones.begin(); begin != ones.end();)
  {
    const auto end = std::find_if(begin, ones.end(),
      [&](Index one) { return this->Distances[one] < (1.0 - TiePart) * this->Distances[*begin]; });
    std::sort(begin, end,
      [&](Index a, Index b) { return isBefore(this->Mesh.position(a), this->Mesh.position(b)); });
    begin = end;
  }
  return ones;
}

bool FarthestVertices::lowerFloor()
{
  double most = 0.0;
  for (std::size_t vertex = 0; vertex < this->Distances.size(); ++vertex)
  {
    Interruption::checkAt(vertex);
    most = this->IsOpen[vertex] ? std::max(most, this->Distances[vertex]) : most;
  }
  this->Floor = FloorPart * most;
  this->Heap.clear();
  for (Index vertex = 0; most > 0.0 && vertex < this->Distances.size(); ++vertex)
  {
    Interruption::checkAt(vertex);
    if (this->IsOpen[vertex] && this->Distances[vertex] >= this->Floor)
    {
      this->Heap.push_back({ this->Distances[vertex], vertex });
    }
  }
  std::make_heap(this->Heap.begin(), this->Heap.end());
  return !this->Heap.empty();
}

void FarthestVertices::wait(Index vertex)
{
  const double distance = this->Distances[vertex];
  if (distance > 0.0 && distance >= this->Floor)
  {
    this->Heap.push_back({ distance, vertex });
    std::push_heap(this->Heap.begin(), this->Heap.end());
  }
}

FarthestVertices::Waiting FarthestVertices::takeFarthest()
{
  std::pop_heap(this->Heap.begin(), this->Heap.end());
  const Waiting first = this->Heap.back();
  this->Heap.pop_back();
  return first;
}

}
