// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/VertexLink.h"

#include "base/SortUnique.h"
#include "mesh/SimpleFan.h"
#include "path/AngleSum.h"
#include "path/VertexFan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

namespace geodesic
{

void VertexLink::lookAt(Index vertex)
{
  this->Vertex = vertex;
  const std::span<const RingEntry> ring = this->Surface.ring(vertex);
  this->Nodes.clear();
  for (const RingEntry& entry : ring)
  {
    this->Nodes.push_back(entry.neighbour());
  }
  sortUnique(this->Nodes);
  this->Arcs.clear();
  const TriangleMesh& mesh = this->Surface.mesh();
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
  {
    if (this->Surface.isCrossable(vertex, i))
    {
      this->Arcs.push_back(
        { this->nodeOf(ring[i].neighbour()), this->nodeOf(ring[i + 1].neighbour()),
          this->angleBetween(
            mesh.position(ring[i].neighbour()), mesh.position(ring[i + 1].neighbour())) });
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

void VertexLink::sweepFrom(const Direction& source)
{
  this->Angles.assign(this->Nodes.size(), std::numeric_limits<double>::infinity());
  this->Previous.assign(this->Nodes.size(), None);
  for (int i = 0; i < 2; ++i)
  {
    this->Angles[source.nodes[i]] = source.angles[i];
  }
  const auto relax = [&](const Arc& arc)
  {
    bool changes = false;
    for (const auto& [a, b] :
      { std::pair{ arc.first, arc.second }, std::pair{ arc.second, arc.first } })
    {
      if (this->Angles[a] + arc.angle < this->Angles[b])
      {
        this->Angles[b] = this->Angles[a] + arc.angle;
        this->Previous[b] = a;
        changes = true;
      }
    }
    return changes;
  };
  // Arcs of a fan follow each other round the vertex, so a few passes forwards and back settle most
  // links.
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
    this->settle();
  }
}

void VertexLink::settle()
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
    queue.emplace(this->Angles[node], node);
  }
  while (!queue.empty())
  {
    const auto [angle, node] = queue.top();
    queue.pop();
    if (angle > this->Angles[node])
    {
      continue;
    }
    this->Surface.countSteps(arcsOf[node].size());
    for (const std::size_t number : arcsOf[node])
    {
      const Arc& arc = this->Arcs[number];
      const std::size_t next = arc.first == node ? arc.second : arc.first;
      if (angle + arc.angle < this->Angles[next])
      {
        this->Angles[next] = angle + arc.angle;
        this->Previous[next] = node;
        queue.emplace(this->Angles[next], next);
      }
    }
  }
}

std::optional<double> VertexLink::appendShorterSide(
  Index vertex, const PathPoint& from, const PathPoint& to, std::vector<Triangle>& faces)
{
  const std::span<const RingEntry> ring = this->Surface.ring(vertex);
  this->Surface.countSteps(ring.size());
  if (isSimpleFan(ring))
  {
    return VertexFan(this->Surface, vertex).appendShorterSide(from, to, faces);
  }
  this->lookAt(vertex);
  const std::optional<Direction> source = this->directionTo(from);
  const std::optional<Direction> target = this->directionTo(to);
  if (!source || !target)
  {
    return std::nullopt;
  }
  const auto face = [&](std::size_t a, std::size_t b) -> Triangle {
    return { vertex, this->Nodes[a], this->Nodes[b] };
  };
  // Where both points lie in one face, that face is the shorter side.
  if (source->nodes[0] != source->nodes[1] &&
    std::is_permutation(source->nodes.begin(), source->nodes.end(), target->nodes.begin()))
  {
    faces.push_back(face(source->nodes[0], source->nodes[1]));
    const bool isSwapped = source->nodes[0] != target->nodes[0];
    return std::abs(source->angles[0] - target->angles[isSwapped ? 1 : 0]);
  }

  this->sweepFrom(*source);
  const double first = this->Angles[target->nodes[0]] + target->angles[0];
  const double second = this->Angles[target->nodes[1]] + target->angles[1];
  const double angle = std::min(first, second);
  if (!(angle < std::numbers::pi + RoundingOfAngles))
  {
    return std::nullopt;
  }
  const auto known = static_cast<std::ptrdiff_t>(faces.size());
  if (target->nodes[0] != target->nodes[1])
  {
    faces.push_back(face(target->nodes[0], target->nodes[1]));
  }
  std::size_t node = target->nodes[first <= second ? 0 : 1];
  for (; this->Previous[node] != None; node = this->Previous[node])
  {
    faces.push_back(face(this->Previous[node], node));
  }
  if (source->nodes[0] != source->nodes[1])
  {
    faces.push_back(face(source->nodes[0], source->nodes[1]));
  }
  std::reverse(faces.begin() + known, faces.end());
  return angle;
}

}
