// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/LabelDensity.h"

#include "base/WorkCount.h"
#include "march/PlaceGrid.h"
#include "mesh/TriangleMesh.h"
#include "solve/Partition.h"
#include "solve/SeedFront.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace geodesic
{
namespace
{

constexpr std::size_t MostSparseLabels = 24;
constexpr double VerticesOfSparseLabel = 64.0;
constexpr double EdgesBetweenSparseLabels = 14.0;
constexpr std::size_t CloseLabelsOfSparse = 4;
/** Labels so close to one another count for nearly all vertices: it is about the margin of equal
 * triangles (see labelMargin()). */
constexpr double EdgesOfCrowd = 10.0;
constexpr std::size_t MostInCrowd = 4;
/** On surfaces of fewer vertices, values of few labels take a tenth of a second at most. */
constexpr double VerticesOfCrowd = 10000.0;
constexpr double SpacingsOfSpread = 2.0;
constexpr double MostInCube = 8.0;
/** The mean of edges of one size is at most this many times their harmonic mean. */
constexpr double MostOfOneSize = 1.5;

/** The size of a surface in all its pieces. */
struct SurfaceSize
{
  double vertices;
  /** Mean of the vertices' longest edges. */
  double meanEdge;
};

/** Collective. */
SurfaceSize sizeOf(const TriangleMesh& mesh, Partition& partition)
{
  if (!partition.isDivided())
  {
    return { static_cast<double>(mesh.numberOfVertices()), mesh.meanLongestEdge() };
  }
  std::array<double, 2> own{ 0.0, 0.0 };
  for (Index vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    if (partition.owns(vertex))
    {
      own[0] += 1.0;
      own[1] += partition.longestSides()[vertex];
    }
  }
  const std::vector<double> all = partition.gather(own);
  SurfaceSize size{ 0.0, 0.0 };
  for (std::size_t i = 0; i < all.size(); i += own.size())
  {
    size.vertices += all[i];
    size.meanEdge += all[i + 1];
  }
  size.meanEdge /= std::max(size.vertices, 1.0);
  return size;
}

/** Whether the vertices' longest edges differ much, as those of CAD programs do. Collective. */
bool edgesAreSpread(const TriangleMesh& mesh, Partition& partition)
{
  if (!partition.isDivided())
  {
    return mesh.spreadOfEdges() > MostOfOneSize;
  }
  // How many edges there are, their sum, and that of their inverses.
  std::array<double, 3> sums{};
  for (Index vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    if (const double edge = partition.longestSides()[vertex]; partition.owns(vertex) && edge > 0.0)
    {
      sums[0] += 1.0;
      sums[1] += edge;
      sums[2] += 1.0 / edge;
    }
  }
  const std::vector<double> all = partition.gather(sums);
  sums = {};
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    sums[i % sums.size()] += all[i];
  }
  return sums[1] * sums[2] > MostOfOneSize * sums[0] * sums[0];
}

std::vector<Index> roundOf(const std::vector<Label>& labels)
{
  std::vector<Index> round;
  for (Index number = 0; number < labels.size(); ++number)
  {
    if (labels[number].shape == FrontShape::Round)
    {
      round.push_back(number);
    }
  }
  return round;
}

/** Whether many round labels start closer to another one than @p distance. Time O(k) for k labels,
 * also where they crowd. */
bool manyAreClose(const std::vector<Label>& labels, double distance)
{
  if (!(distance > 0.0))
  {
    return false;
  }
  const std::vector<Index> round = roundOf(labels);
  const auto placeOf = [&](Index number) { return labels[number].position; };
  const PlaceGrid grid(round, distance, placeOf);
  const auto close = static_cast<std::size_t>(std::count_if(round.begin(), round.end(),
    [&](Index number)
    {
      return grid.anyNear(placeOf(number), distance,
        [&](Index other)
        {
          WorkCount::add(1);
          return other != number && norm(placeOf(other) - placeOf(number)) < distance;
        });
    }));
  return close > MostSparseLabels && close * CloseLabelsOfSparse > labels.size();
}

/**
 * Whether round labels have, in the mean, more than MostInCrowd of them within a distance, each one
 * itself included. Time O(k) for k labels: cubes of the grid are so small that all labels in one
 * are that close, and so more of them than are looked at for nothing end the count.
 */
bool labelsCrowd(const std::vector<Label>& labels, double distance)
{
  const std::vector<Index> round = roundOf(labels);
  if (round.size() <= MostInCrowd || !(distance > 0.0))
  {
    return false;
  }
  const auto placeOf = [&](Index number) { return labels[number].position; };
  const PlaceGrid grid(round, distance / std::numbers::sqrt3, placeOf);
  const std::size_t most = MostInCrowd * round.size();
  std::size_t close = 0;
  return std::any_of(round.begin(), round.end(),
    [&](Index number)
    {
      return grid.anyNear(placeOf(number), distance,
        [&](Index other)
        {
          WorkCount::add(1);
          close += norm(placeOf(other) - placeOf(number)) <= distance ? 1 : 0;
          return close > most;
        });
    });
}

}

bool labelsAreDense(
  const TriangleMesh& mesh, const SeedFront& front, bool costsAreSpread, Partition& partition)
{
  const std::size_t count = front.labels.size();
  if (count <= MostInCrowd)
  {
    return false;
  }
  if (costsAreSpread)
  {
    return count > MostSparseLabels;
  }
  const SurfaceSize size = sizeOf(mesh, partition);
  if (count > MostSparseLabels &&
    (size.vertices < VerticesOfSparseLabel * static_cast<double>(count) ||
      manyAreClose(front.labels, EdgesBetweenSparseLabels * size.meanEdge)))
  {
    return true;
  }
  return size.vertices >= VerticesOfCrowd &&
    labelsCrowd(front.labels, EdgesOfCrowd * size.meanEdge);
}

bool labelsHaveRoom(const TriangleMesh& mesh, const SeedFront& front, Partition& partition)
{
  return sizeOf(mesh, partition).vertices >=
    VerticesOfSparseLabel * static_cast<double>(front.labels.size());
}

double labelSpacing(const TriangleMesh& mesh, const SeedFront& front, Partition& partition)
{
  const SurfaceSize size = sizeOf(mesh, partition);
  return std::sqrt(size.vertices / static_cast<double>(front.labels.size())) * size.meanEdge;
}

bool labelsAreSpread(
  const TriangleMesh& mesh, const SeedFront& front, double farthest, Partition& partition)
{
  const std::vector<Index> round = roundOf(front.labels);
  if (round.size() < front.labels.size())
  {
    return false;
  }
  const double spacing = labelSpacing(mesh, front, partition);
  return spacing > 0.0 && farthest <= SpacingsOfSpread * spacing &&
    PlaceGrid(round, spacing, [&](Index number) { return front.labels[number].position; })
      .meanInBucket() <= MostInCube;
}

bool labelsCompeteInTriangles(
  const TriangleMesh& mesh, const SeedFront& front, Partition& partition)
{
  return roundOf(front.labels).size() == front.labels.size() || edgesAreSpread(mesh, partition);
}

}
