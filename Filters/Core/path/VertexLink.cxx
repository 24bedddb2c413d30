// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/VertexLink.h"

#include "base/SortUnique.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

namespace geodesic
{
namespace
{

/** An angle counts as 180 degrees if it differs by less than this, in radians. What a path could
 * gain is proportional to the square of the difference. */
constexpr double Rounding = 1e-7;

}

VertexLink::VertexLink(const WeightedMesh& weighted, Index vertex)
  : Surface(weighted)
  , Vertex(vertex)
{
  const std::span<const RingEntry> ring = weighted.ring(vertex);
  this->Nodes.reserve(ring.size());
  for (const RingEntry& entry : ring)
  {
    this->Nodes.push_back(entry.neighbour());
  }
  sortUnique(this->Nodes);
  weighted.countSteps(ring.size());
  this->Arcs.reserve(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    if (weighted.isCrossable(vertex, i))
    {
      const Index a = ring[i].neighbour();
      const Index b = ring[i + 1].neighbour();
      this->Arcs.push_back({ this->nodeOf(a), this->nodeOf(b),
        this->angleBetween(weighted.mesh().position(a), weighted.mesh().position(b)) });
    }
  }
}

std::size_t VertexLink::nodeOf(Index neighbour) const
{
  return std::lower_bound(this->Nodes.begin(), this->Nodes.end(), neighbour) - this->Nodes.begin();
}

double VertexLink::angleBetween(const Vector3& a, const Vector3& b) const
{
  const Vector3 centre = this->Surface.mesh().position(this->Vertex);
  return std::atan2(norm(cross(a - centre, b - centre)), dot(a - centre, b - centre));
}

std::optional<VertexLink::Direction> VertexLink::directionTo(const PathPoint& point) const
{
  Carriers others;
  for (Index carrier : point.carriers())
  {
    if (carrier != this->Vertex)
    {
      others.add(carrier);
    }
  }
  if (others.size() == 1)
  {
    const std::size_t node = this->nodeOf(others[0]);
    return Direction{ { node, node }, { 0.0, 0.0 } };
  }
  const Vector3 position = point.position(this->Surface.mesh());
  const std::size_t first = this->nodeOf(others[0]);
  const std::size_t second = this->nodeOf(others[1]);
  const bool isCrossable = std::any_of(this->Arcs.begin(), this->Arcs.end(),
    [&](const Arc& arc)
    {
      return (arc.first == first && arc.second == second) ||
        (arc.first == second && arc.second == first);
    });
  if (!isCrossable)
  {
    return std::nullopt;
  }
  return Direction{ { first, second },
    { this->angleBetween(position, this->Surface.mesh().position(others[0])),
      this->angleBetween(position, this->Surface.mesh().position(others[1])) } };
}

VertexLink::Sweep VertexLink::sweepFrom(const Direction& source) const
{
  Sweep sweep{ std::vector<double>(this->Nodes.size(), std::numeric_limits<double>::infinity()),
    std::vector<std::size_t>(this->Nodes.size(), None) };
  for (int i = 0; i < 2; ++i)
  {
    sweep.angles[source.nodes[i]] = source.angles[i];
  }
  const auto relax = [&](const Arc& arc)
  {
    bool changes = false;
    for (const auto& [a, b] :
      { std::pair{ arc.first, arc.second }, std::pair{ arc.second, arc.first } })
    {
      if (sweep.angles[a] + arc.angle < sweep.angles[b])
      {
        sweep.angles[b] = sweep.angles[a] + arc.angle;
        sweep.previous[b] = a;
        changes = true;
      }
    }
    return changes;
  };
  // Arcs of a fan follow each other round the vertex, so one pass forwards and one back settle a
  // fan, and a few more passes most links of several fans.
  constexpr int mostPasses = 4;
  bool changes = true;
  for (int pass = 0; pass < mostPasses && changes; ++pass)
  {
    this->Surface.countSteps(2 * this->Arcs.size());
    changes = false;
    for (auto arc = this->Arcs.begin(); arc != this->Arcs.end(); ++arc)
    {
      changes = relax(*arc) || changes;
    }
    for (auto arc = this->Arcs.rbegin(); arc != this->Arcs.rend(); ++arc)
    {
      changes = relax(*arc) || changes;
    }
  }
  if (changes)
  {
    this->settle(sweep);
  }
  return sweep;
}

void VertexLink::settle(Sweep& sweep) const
{
  std::vector<std::vector<std::size_t>> arcsOf(this->Nodes.size());
  for (std::size_t i = 0; i < this->Arcs.size(); ++i)
  {
    arcsOf[this->Arcs[i].first].push_back(i);
    arcsOf[this->Arcs[i].second].push_back(i);
  }
  using Trial = std::pair<double, std::size_t>;
  std::priority_queue<Trial, std::vector<Trial>, std::greater<>> queue;
  for (std::size_t node = 0; node < this->Nodes.size(); ++node)
  {
    queue.emplace(sweep.angles[node], node);
  }
  while (!queue.empty())
  {
    const auto [angle, node] = queue.top();
    queue.pop();
    if (angle > sweep.angles[node])
    {
      continue;
    }
    this->Surface.countSteps(arcsOf[node].size());
    for (const std::size_t number : arcsOf[node])
    {
      const Arc& arc = this->Arcs[number];
      const std::size_t next = arc.first == node ? arc.second : arc.first;
      if (angle + arc.angle < sweep.angles[next])
      {
        sweep.angles[next] = angle + arc.angle;
        sweep.previous[next] = node;
        queue.emplace(sweep.angles[next], next);
      }
    }
  }
}

std::optional<std::vector<Triangle>> VertexLink::shorterSide(
  const PathPoint& from, const PathPoint& to) const
{
  const std::optional<Direction> source = this->directionTo(from);
  const std::optional<Direction> target = this->directionTo(to);
  if (!source || !target)
  {
    return std::nullopt;
  }
  // Where both points lie in one face, that face is the shorter side.
  const bool sharesFace = source->nodes[0] != source->nodes[1] &&
    std::is_permutation(source->nodes.begin(), source->nodes.end(), target->nodes.begin());
  const auto face = [&](std::size_t a, std::size_t b) -> Triangle {
    return { this->Vertex, this->Nodes[a], this->Nodes[b] };
  };
  if (sharesFace)
  {
    return std::vector<Triangle>{ face(source->nodes[0], source->nodes[1]) };
  }

  const auto [angles, previous] = this->sweepFrom(*source);
  const double first = angles[target->nodes[0]] + target->angles[0];
  const double second = angles[target->nodes[1]] + target->angles[1];
  if (!(std::min(first, second) < std::numbers::pi + Rounding))
  {
    return std::nullopt;
  }
  std::vector<Triangle> faces;
  if (target->nodes[0] != target->nodes[1])
  {
    faces.push_back(face(target->nodes[0], target->nodes[1]));
  }
  std::size_t node = target->nodes[first <= second ? 0 : 1];
  for (; previous[node] != None; node = previous[node])
  {
    faces.push_back(face(previous[node], node));
  }
  if (source->nodes[0] != source->nodes[1])
  {
    faces.push_back(face(source->nodes[0], source->nodes[1]));
  }
  std::reverse(faces.begin(), faces.end());
  return faces;
}

}
