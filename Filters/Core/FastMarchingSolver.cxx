#include "FastMarchingSolver.h"

#include "MarchControl.h"
#include "RingSweep.h"
#include "StopLimit.h"
#include "TriangleMesh.h"

#include <algorithm>

namespace geodesic
{
namespace
{

constexpr std::uint8_t Queued = 1;
/** A value that is final from the start, because the straight line from the seed is known. */
constexpr std::uint8_t Pinned = 2;

/** Width of the queue's buckets; 0.25 to 1 serve about equally well. */
constexpr double BucketWidthInMeanEdges = 0.5;

double smallestValue(std::span<const Seed> seeds)
{
  return std::min_element(
    seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) { return a.value < b.value; })
    ->value;
}

}

FastMarchingSolver::FastMarchingSolver(std::shared_ptr<const TriangleMesh> mesh)
  : DistanceSolver(std::move(mesh))
{
  this->State.resize(this->mesh().numberOfVertices(), 0);
}

bool FastMarchingSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  this->Queue.start(
    BucketWidthInMeanEdges * this->mesh().meanEdgeLength(), 2.0 * this->mesh().longestEdgeLength());
  return request.seeds.size() == 1 ? this->marchOneSeed(request, limit, field)
                                   : this->marchManySeeds(request, limit, field);
}

bool FastMarchingSolver::marchOneSeed(
  const Request& request, StopLimit& limit, DistanceField& field)
{
  const TriangleMesh& mesh = this->mesh();
  const double offset = request.seeds[0].value;
  const auto isExcluded = [&](Index vertex)
  { return !request.options.excluded.empty() && request.options.excluded[vertex]; };
  const auto valueOf = [&](Index vertex) { return field.distance(vertex) - offset; };
  const auto ceilingOf = [&](Index vertex, double value)
  { return std::min(value * KeptFraction, limit.reach(mesh, vertex) - offset); };
  const auto propose = [&](Index vertex, double value)
  {
    const double old = valueOf(vertex);
    std::uint8_t& state = this->State[vertex];
    if (!(value < ceilingOf(vertex, old)) || (state & Pinned) || isExcluded(vertex))
    {
      return old;
    }
    field.setDistance(vertex, value + offset);
    if (!(state & Queued))
    {
      state |= Queued;
      this->Queue.push(vertex, value);
    }
    return value;
  };

  for (const SeedCorner& corner : request.corners)
  {
    field.setDistance(corner.vertex, corner.distance + offset);
    this->State[corner.vertex] = Pinned | Queued;
    this->Queue.push(corner.vertex, corner.distance);
  }
  MarchControl control(request.options, limit);
  while (!this->Queue.isEmpty() && control.mayGoOn())
  {
    const Index vertex = this->Queue.pop();
    this->State[vertex] &= ~Queued;
    sweepRing(mesh, vertex, valueOf(vertex), valueOf, ceilingOf, propose);
  }
  for (Index vertex : field.reached())
  {
    this->State[vertex] = 0;
    field.setNearestSeed(vertex, 0);
  }
  return !control.isCancelled();
}

bool FastMarchingSolver::marchManySeeds(
  const Request& request, StopLimit& limit, DistanceField& field)
{
  const TriangleMesh& mesh = this->mesh();
  LabelSets& labels = this->Labels;
  labels.start(mesh.numberOfVertices());
  const double start = smallestValue(request.seeds);
  const auto isExcluded = [&](Index vertex)
  { return !request.options.excluded.empty() && request.options.excluded[vertex]; };
  const auto lower = [&](Index entry, double value)
  {
    const Index vertex = labels[entry].vertex;
    labels[entry].value = value;
    const double distance = value + request.seeds[labels[entry].label].value;
    if (distance < field.distance(vertex))
    {
      field.setDistance(vertex, distance);
    }
    if (!labels[entry].isQueued)
    {
      labels[entry].isQueued = true;
      this->Queue.push(entry, distance - start);
    }
  };
  const auto keptUpTo = [&](Index vertex)
  { return field.distance(vertex) + LabelSets::MarginInEdges * mesh.longestEdgeAround(vertex); };

  for (const SeedCorner& corner : request.corners)
  {
    const Index entry = labels.add(corner.vertex, corner.seed);
    labels[entry].isPinned = true;
    lower(entry, corner.distance);
  }
  MarchControl control(request.options, limit);
  while (!this->Queue.isEmpty() && control.mayGoOn())
  {
    const Index popped = this->Queue.pop();
    labels[popped].isQueued = false;
    const LabelSets::Entry current = labels[popped];
    const double offset = request.seeds[current.label].value;
    if (current.value + offset > keptUpTo(current.vertex))
    {
      continue;
    }
    const auto valueOf = [&](Index vertex) { return labels.value(vertex, current.label); };
    const auto ceilingOf = [&](Index vertex, double value)
    {
      return std::min(
        value * KeptFraction, std::min(keptUpTo(vertex), limit.reach(mesh, vertex)) - offset);
    };
    const auto propose = [&](Index vertex, double value)
    {
      const Index known = labels.find(vertex, current.label);
      const double old = known == NoIndex ? DistanceField::Unreached : labels[known].value;
      if (!(value < ceilingOf(vertex, old)) || isExcluded(vertex) ||
        (known != NoIndex && labels[known].isPinned))
      {
        return old;
      }
      lower(known == NoIndex ? labels.add(vertex, current.label) : known, value);
      return value;
    };
    sweepRing(mesh, current.vertex, current.value, valueOf, ceilingOf, propose);
  }
  for (Index vertex : field.reached())
  {
    field.setNearestSeed(vertex,
      labels.nearest(
        vertex, field.distance(vertex), [&](Index label) { return request.seeds[label].value; }));
  }
  labels.clear(field.reached());
  return !control.isCancelled();
}

}
