#include "CostedStart.h"

#include "DistanceSolver.h"
#include "TriangleMesh.h"

#include <algorithm>

namespace geodesic
{
namespace
{

constexpr double DiscInMeanEdges = 3.0;

double meanEdgeAround(const TriangleMesh& mesh, Index vertex)
{
  // A ring may hold a neighbour twice.
  std::vector<Index> neighbours;
  for (const RingEntry& entry : mesh.ring(vertex))
  {
    neighbours.push_back(entry.neighbour());
  }
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  double sum = 0.0;
  for (Index neighbour : neighbours)
  {
    sum += norm(mesh.position(neighbour) - mesh.position(vertex));
  }
  return sum / static_cast<double>(neighbours.size());
}

bool isConstant(std::span<const double> cost, std::span<const StartValue> values)
{
  const auto [least, most] = std::minmax_element(values.begin(), values.end(),
    [&](const StartValue& a, const StartValue& b) { return cost[a.vertex] < cost[b.vertex]; });
  return cost[most->vertex] <= cost[least->vertex] * (1.0 + 1e-12);
}

/** The starts of the label, and the vertices of its disc, with lengths as values. */
std::vector<StartValue> discRound(const TriangleMesh& mesh, Index label, const Label& source,
  std::span<const FrontStart> starts, const SolveOptions& options, DistanceSolver& unitSolver)
{
  SolveOptions near;
  near.excluded = options.excluded;
  near.closedTriangles = options.closedTriangles;
  near.maximumDistance = 0.0;
  for (Index vertex : carriersOf(mesh, source.origin))
  {
    near.maximumDistance =
      std::max(near.maximumDistance, DiscInMeanEdges * meanEdgeAround(mesh, vertex));
  }
  const Seed seed = Seed::atPoint(source.origin);
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

}

std::vector<StartValue> unitStarts(const SeedFront& front)
{
  std::vector<StartValue> values;
  values.reserve(front.starts.size());
  for (const FrontStart& start : front.starts)
  {
    values.push_back({ start.vertex, start.label, start.length, true });
  }
  return values;
}

std::vector<StartValue> costedStarts(const TriangleMesh& mesh, const SeedFront& front,
  const SolveOptions& options, DistanceSolver& unitSolver)
{
  std::vector<StartValue> values;
  // The starts of a label stand together.
  for (auto first = front.starts.begin(); first != front.starts.end();)
  {
    const Index label = first->label;
    const auto last = std::find_if(
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
    auto disc = discRound(mesh, label, source, { first, last }, options, unitSolver);
    const double atOrigin = costAt(mesh, options.cost, source.origin);
    if (isConstant(options.cost, disc))
    {
      disc.erase(std::remove_if(disc.begin(), disc.end(),
                   [&](const StartValue& value)
                   {
                     return std::none_of(first, last,
                       [&](const FrontStart& start) { return start.vertex == value.vertex; });
                   }),
        disc.end());
    }
    for (StartValue& value : disc)
    {
      value.value *= 0.5 * (atOrigin + options.cost[value.vertex]);
    }
    values.insert(values.end(), disc.begin(), disc.end());
    first = last;
  }
  return values;
}

double costAt(const TriangleMesh& mesh, std::span<const double> cost, const SurfacePoint& point)
{
  const Triangle& corners = mesh.triangle(point.triangle);
  return point.weights[0] * cost[corners[0]] + point.weights[1] * cost[corners[1]] +
    point.weights[2] * cost[corners[2]];
}

}
