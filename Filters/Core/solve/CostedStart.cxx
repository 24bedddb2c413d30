// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/CostedStart.h"

#include "base/SortUnique.h"
#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/DistanceField.h"
#include "solve/FrontSolver.h"
#include "solve/Partition.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <tuple>

namespace geodesic
{
namespace
{

/** So much more that rounding does not decide about vertices just at the end of a disc, as round
 * the pole of a sphere. */
constexpr double Beyond = 1.0 + 1e-6;
constexpr double DiscInMeanEdges = 3.0 * Beyond;

/**
 * Returns the vectors from a vertex to its neighbours, three numbers each. Pieces of a surface have
 * some of these neighbours in common; equal vectors show which.
 */
std::vector<double> offsetsAround(const TriangleMesh& mesh, Index vertex)
{
  std::vector<double> offsets;
  for (const RingEntry& entry : mesh.ring(vertex))
  {
    const Vector3 offset = mesh.position(entry.neighbour()) - mesh.position(vertex);
    offsets.insert(offsets.end(), { offset.x, offset.y, offset.z });
  }
  return offsets;
}

/** Returns the mean length of the edges at a vertex.
 * @param coordinates  offsetsAround() the vertex, from all pieces in any order: offsets are sorted,
 *                     so that the mean is the same to the last bit on each piece
 */
double meanOfOffsets(std::span<const double> coordinates)
{
  std::vector<std::array<double, 3>> offsets;
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
  {
    offsets.push_back({ coordinates[i], coordinates[i + 1], coordinates[i + 2] });
  }
  sortUnique(offsets);
  double sum = 0.0;
  for (const auto& [x, y, z] : offsets)
  {
    sum += norm(Vector3{ x, y, z });
  }
  return sum / static_cast<double>(offsets.size());
}

/**
 * Returns the radius of the disc round a label's origin: three times the mean edge at a vertex that
 * carries the origin, the largest of up to three. Edges are those of all pieces; sorted by
 * position, the carriers have the same order on each. Collective.
 */
double discRadius(const TriangleMesh& mesh, const SurfacePoint& origin, Partition& partition)
{
  std::vector<Index> carriers;
  if (origin.triangle != NoIndex)
  {
    const Carriers ofOrigin = carriersOf(mesh, origin);
    carriers.assign(ofOrigin.begin(), ofOrigin.end());
  }
  const auto coordinates = [&](Index vertex)
  {
    const Vector3& p = mesh.position(vertex);
    return std::array{ p.x, p.y, p.z };
  };
  std::sort(carriers.begin(), carriers.end(),
    [&](Index a, Index b) { return coordinates(a) < coordinates(b); });
  std::vector<StartValue> numbered;
  for (Index i = 0; i < carriers.size(); ++i)
  {
    numbered.push_back({ carriers[i], i, 0.0, false });
  }
  // A piece may have a carrier, but no triangle with the origin: it learns its carriers from
  // others.
  constexpr std::size_t mostCarriers = 3;
  carriers.resize(mostCarriers, NoIndex);
  for (const StartValue& other : partition.exchange(numbered))
  {
    carriers[other.label] = other.vertex;
  }
  double radius = 0.0;
  for (const Index carrier : carriers)
  {
    const auto own = carrier != NoIndex ? offsetsAround(mesh, carrier) : std::vector<double>{};
    const std::vector<double> offsets = partition.gather(own);
    if (!offsets.empty())
    {
      radius = std::max(radius, DiscInMeanEdges * meanOfOffsets(offsets));
    }
  }
  return radius;
}

/** Whether the cost is the same at all these vertices on all pieces. */
bool isConstant(
  std::span<const double> cost, std::span<const StartValue> values, Partition& partition)
{
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  const auto include = [&](double value)
  {
    least = std::min(least, value);
    most = std::max(most, value);
  };
  for (const StartValue& value : values)
  {
    include(cost[value.vertex]);
  }
  const std::array own{ least, most };
  for (double bound : partition.gather(values.empty() ? std::span<const double>{} : own))
  {
    include(bound);
  }
  return most <= least * (1.0 + 1e-12);
}

/** Whether the cost at a vertex is more than twice that at a neighbour to which an edge leads, or
 * less than half. */
bool jumpsAt(const TriangleMesh& mesh, const ClosedTriangles& closed, const SolveOptions& options,
  Index vertex)
{
  constexpr double mostOfSmooth = 2.0;
  const std::span<const RingEntry> ring = mesh.ring(vertex);
  const double here = options.cost[vertex];
  bool jumps = false;
  for (std::size_t i = 0; i < ring.size() && !jumps; ++i)
  {
    const double there = options.cost[ring[i].neighbour()];
    jumps = std::max(here, there) > mostOfSmooth * std::min(here, there) &&
      closed.isOpenEdge(vertex, i) && !options.isExcluded(ring[i].neighbour());
  }
  return jumps;
}

/** Returns the length to the nearest vertex of a disc where the cost jumps; infinity if there is
 * none. Collective. */
double lengthToJump(const TriangleMesh& mesh, const ClosedTriangles& closed,
  const SolveOptions& options, std::span<const StartValue> disc, Partition& partition)
{
  double least = std::numeric_limits<double>::infinity();
  for (const StartValue& value : disc)
  {
    if (value.value < least && jumpsAt(mesh, closed, options, value.vertex))
    {
      least = value.value;
    }
  }
  const std::vector<double> all = partition.gather({ &least, 1 });
  return *std::min_element(all.begin(), all.end());
}

/** Returns the label's starts and the vertices of its disc, with lengths as values. Collective. */
std::vector<StartValue> discRound(const TriangleMesh& mesh, Index label, const Label& source,
  std::span<const FrontStart> starts, const SolveOptions& options, Partition& partition,
  FrontSolver& unitSolver)
{
  SolveOptions near;
  near.excluded = options.excluded;
  near.closedTriangles = options.closedTriangles;
  near.maximumDistance = discRadius(mesh, source.origin, partition);
  near.partition = options.partition;
  std::vector<SurfacePoint> origin;
  if (source.origin.triangle != NoIndex)
  {
    origin.push_back(source.origin);
  }
  const Seed seed = Seed::atPosition(source.position, origin);
  const DistanceField& lengths = unitSolver.solve({ &seed, 1 }, near);
  std::vector<StartValue> disc;
  for (Index vertex : lengths.reached())
  {
    disc.push_back({ vertex, label, lengths.distance(vertex), true });
  }
  for (const FrontStart& start : starts)
  {
    if (!lengths.isReached(start.vertex))
    {
      disc.push_back({ start.vertex, label, start.length, true });
    }
  }
  return disc;
}

/**
 * Adds the starts of other pieces at shared vertices, and keeps the least value for each label and
 * vertex. Collective.
 */
void addStartsOfOthers(std::vector<StartValue>& starts, Partition& partition)
{
  const std::vector<StartValue> others = partition.exchange(starts);
  if (others.empty())
  {
    return;
  }
  starts.insert(starts.end(), others.begin(), others.end());
  const auto key = [](const StartValue& start)
  { return std::tuple(start.label, start.vertex, start.value, !start.isFinal); };
  std::sort(starts.begin(), starts.end(),
    [&](const StartValue& a, const StartValue& b) { return key(a) < key(b); });
  const auto isSame = [](const StartValue& a, const StartValue& b)
  { return a.label == b.label && a.vertex == b.vertex; };
  starts.erase(std::unique(starts.begin(), starts.end(), isSame), starts.end());
}

}

std::vector<StartValue> unitStarts(const SeedFront& front, Partition& partition)
{
  std::vector<StartValue> values;
  values.reserve(front.starts.size());
  for (const FrontStart& start : front.starts)
  {
    values.push_back({ start.vertex, start.label, start.length, true });
  }
  addStartsOfOthers(values, partition);
  return values;
}

std::vector<StartValue> costedStarts(const TriangleMesh& mesh, const SeedFront& front,
  const ClosedTriangles& closed, const SolveOptions& options, Partition& partition,
  FrontSolver& unitSolver, std::vector<Index>& atJumps)
{
  std::vector<StartValue> values;
  // The starts of a label follow each other.
  auto last = front.starts.begin();
  for (Index label = 0; label < front.labels.size(); ++label)
  {
    auto first = last;
    last = std::find_if(
      first, front.starts.end(), [&](const FrontStart& start) { return start.label != label; });
    const Label& source = front.labels[label];
    if (source.shape == FrontShape::Straight)
    {
      for (; first != last; ++first)
      {
        const bool isFinal = first->length == 0.0;
        values.push_back(
          { first->vertex, label, first->length * options.cost[first->vertex], isFinal });
      }
      continue;
    }
    auto disc = discRound(mesh, label, source, { first, last }, options, partition, unitSolver);
    const double atOrigin = costAtOrigin(mesh, options.cost, source, partition);
    double end = 0.0;
    if (!isConstant(options.cost, disc, partition))
    {
      end = lengthToJump(mesh, closed, options, disc, partition) * Beyond;
      if (end < DistanceField::Unreached)
      {
        std::transform(disc.begin(), disc.end(), std::back_inserter(atJumps),
          [](const StartValue& value) { return value.vertex; });
      }
    }
    std::erase_if(disc,
      [&](const StartValue& value)
      {
        return value.value > end &&
          std::none_of(
            first, last, [&](const FrontStart& start) { return start.vertex == value.vertex; });
      });
    for (StartValue& value : disc)
    {
      value.value *= 0.5 * (atOrigin + options.cost[value.vertex]);
    }
    values.insert(values.end(), disc.begin(), disc.end());
  }
  addStartsOfOthers(values, partition);
  return values;
}

double costAtOrigin(
  const TriangleMesh& mesh, std::span<const double> cost, const Label& label, Partition& partition)
{
  std::vector<double> own;
  const SurfacePoint& point = label.origin;
  if (point.triangle != NoIndex)
  {
    const Triangle& corners = mesh.triangle(point.triangle);
    own.push_back(point.weights[0] * cost[corners[0]] + point.weights[1] * cost[corners[1]] +
      point.weights[2] * cost[corners[2]]);
  }
  return partition.gather(own).front();
}

}
