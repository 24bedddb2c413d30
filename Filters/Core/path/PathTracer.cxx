// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/PathTracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>

namespace geodesic
{
namespace
{

/** A point of an edge counts as the edge's end if it is nearer to it than this fraction. */
constexpr double VertexFraction = 1e-9;
/** The part of what is left that a step across a face gains at least. Round a vertex where fields
 * of varying cost bend, steps that gain ever less went round for millions of points; then the path
 * goes on along an edge. A path of ten million edges gains more at each edge. */
constexpr double LeastGain = 1e-7;
/** The part that a step which gains less, as it only cuts off a corner, gains together with the one
 * before. A path of a million edges gains more. */
constexpr double LeastGainOfTwo = 1e-6;

/** Whether a step leaves less of a path. @param left, leftBefore  what was left after the last
 * step, and after the one before */
bool gains(double stepLeft, double left, double leftBefore)
{
  return stepLeft < (1.0 - LeastGain) * left ||
    (stepLeft < left && stepLeft < (1.0 - LeastGainOfTwo) * leftBefore);
}

double costAt(const WeightedMesh& surface, const PathPoint& point)
{
  double cost = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    cost += point.weights[i] * surface.costOf(point.corners[i]);
  }
  return cost;
}

/** The point q of an edge at which phi(q) + |p q| is least; see PathTracer. */
struct EdgeMinimum
{
  /** Distance of q from the edge's first end. */
  double x;
  /** phi at q. */
  double left;
  /** phi at q, and |p q|. */
  double total;
};

/**
 * Finds that point.
 * @param a, b    phi at the ends, less than @p c apart
 * @param c       the edge's length
 * @param xp, hp  p's foot on the edge's line, from its first end, and its height
 */
EdgeMinimum leastOverEdge(double a, double b, double c, double xp, double hp)
{
  // The flat source of phi is at (sourceX, -root) if s > 0, otherwise on the edge's line.
  const double sourceX = 0.5 * (c + (a - b) * (a + b) / c);
  const double s = a + b - c;
  const double quarterSquare = (a + b + c) * std::abs(s) * (c + a - b) * (c - a + b);
  const double root = std::sqrt(quarterSquare) / (2.0 * c);
  double x = 0.0;
  double left = 0.0;
  if (s > 0.0)
  {
    x = std::clamp((sourceX * hp + xp * root) / (hp + root), 0.0, c);
    left = std::sqrt((x - sourceX) * (x - sourceX) + root * root);
  }
  else
  {
    x = std::clamp(std::clamp(xp, sourceX - root, sourceX + root), 0.0, c);
    left = std::sqrt(std::max(0.0, (x - sourceX - root) * (x - sourceX + root)));
  }
  return { x, left, left + std::sqrt((xp - x) * (xp - x) + hp * hp) };
}

}

std::vector<Index> PathTracer::seedsNear(const PathPoint& point) const
{
  const TriangleMesh& mesh = this->Surface.mesh();
  const Vector3 position = point.position(mesh);
  std::map<Index, double> totals;
  const auto propose = [&](Index seed, double total)
  {
    const auto [known, isNew] = totals.emplace(seed, total);
    known->second = std::min(known->second, total);
  };
  visitFaces(this->Surface, point,
    [&](const Triangle& face)
    {
      const double cost = this->Surface.costOf(face);
      const auto proposeAt = [&](Index vertex)
      {
        if (this->Field.isReached(vertex))
        {
          propose(this->Field.nearestSeed(vertex),
            this->Field.distance(vertex) + cost * norm(mesh.position(vertex) - position));
        }
      };
      std::for_each(face.begin(), face.end(), proposeAt);
      this->Seeds.visitIn(face,
        [&](Index seed)
        { propose(seed, cost * norm(this->Seeds[seed].position(mesh) - position)); });
    });
  std::vector<Index> seeds;
  seeds.reserve(totals.size());
  for (const auto& [seed, total] : totals)
  {
    seeds.push_back(seed);
  }
  std::stable_sort(
    seeds.begin(), seeds.end(), [&](Index a, Index b) { return totals[a] < totals[b]; });
  return seeds;
}

std::optional<SurfacePath> PathTracer::trace(const PathPoint& start, Index seed, PathOrder order)
{
  // A shortest path stays among vertices whose nearest seed is its own.
  this->Aim = seed;
  auto path = this->traceToAim(start, order);
  if (!path)
  {
    this->Aim = NoIndex;
    path = this->traceToAim(start, order);
  }
  return path;
}

bool PathTracer::leadsToAim(Index vertex) const
{
  return this->Field.isReached(vertex) &&
    (this->Aim == NoIndex || this->Field.nearestSeed(vertex) == this->Aim);
}

std::optional<SurfacePath> PathTracer::traceToAim(const PathPoint& start, PathOrder order) const
{
  SurfacePath path{ start };
  double left = DistanceField::Unreached;
  double leftBefore = DistanceField::Unreached;
  while (true)
  {
    const PathPoint here = path.back();
    if (const auto last = this->stepToSeed(here))
    {
      path.push_back(last->point);
      return path;
    }
    std::optional<Step> step;
    if (order == PathOrder::Edges)
    {
      step = this->stepAhead(path, left);
    }
    if (!step || !gains(step->left, left, leftBefore))
    {
      step = this->stepAlongEdges(here);
    }
    if (step)
    {
      leftBefore = left;
      left = std::min(left, step->left);
      path.push_back(step->point);
      continue;
    }
    const std::vector<Index> descent =
      isVertex(here) ? this->descentAlongEdges(here.carriers()[0]) : std::vector<Index>{};
    if (descent.empty())
    {
      return std::nullopt;
    }
    for (Index vertex : descent)
    {
      path.push_back(PathPoint::atVertex(vertex));
    }
  }
}

std::optional<PathTracer::Step> PathTracer::stepToSeed(const PathPoint& point) const
{
  const TriangleMesh& mesh = this->Surface.mesh();
  std::optional<Step> best;
  const auto tryEnd = [&](Index seed, const Triangle& face)
  {
    if (seed != NoIndex && liesIn(this->Seeds[seed], face))
    {
      const PathPoint& end = this->Seeds[seed];
      const double total =
        this->Surface.costOf(face) * norm(end.position(mesh) - point.position(mesh));
      if (!best || total < best->total)
      {
        best = Step{ end, 0.0, total };
      }
    }
  };
  visitFaces(this->Surface, point,
    [&](const Triangle& face)
    {
      if (this->Aim != NoIndex)
      {
        tryEnd(this->Aim, face);
        return;
      }
      for (Index corner : face)
      {
        tryEnd(this->Field.nearestSeed(corner), face);
      }
    });
  return best;
}

std::optional<PathTracer::Step> PathTracer::stepAhead(const SurfacePath& path, double left) const
{
  const PathPoint& here = path.back();
  if (path.size() > 1 && here.carriers().size() == 2)
  {
    // The last step was the best one across its face, so that two steps across it, there and back,
    // leave no less.
    const auto step = this->stepAcrossFaces(here, &path[path.size() - 2]);
    if (step && step->total <= left)
    {
      return step;
    }
  }
  return this->stepAcrossFaces(here, nullptr);
}

std::optional<PathTracer::Step> PathTracer::stepAcrossFaces(
  const PathPoint& point, const PathPoint* last) const
{
  const Carriers carriers = point.carriers();
  const Vector3 position = point.position(this->Surface.mesh());
  std::optional<Step> best;
  visitFaces(this->Surface, point,
    [&](const Triangle& face)
    {
      if (last && liesIn(*last, face))
      {
        return;
      }
      for (int c = 0; c < 3; ++c)
      {
        const Index a = face[(c + 1) % 3];
        const Index b = face[(c + 2) % 3];
        if (carriers.contains(face[c]))
        {
          this->tryEdge(position, face, a, b, best);
        }
        if (carriers.size() > 1 || carriers[0] != face[c])
        {
          this->tryVertex(position, face[c], this->Surface.costOf(face), best);
        }
      }
    });
  return best;
}

std::optional<PathTracer::Step> PathTracer::stepAlongEdges(const PathPoint& point) const
{
  std::optional<Step> best;
  const Carriers carriers = point.carriers();
  const Vector3 position = point.position(this->Surface.mesh());
  const auto tryEnd = [&](Index vertex)
  {
    const bool isLower =
      carriers.size() > 1 || this->Field.distance(vertex) < this->Field.distance(carriers[0]);
    if (isLower)
    {
      const double cost = 0.5 * (costAt(this->Surface, point) + this->Surface.costOf(vertex));
      this->tryVertex(position, vertex, cost, best);
    }
  };
  if (carriers.size() == 1)
  {
    const std::span<const RingEntry> ring = this->Surface.ring(carriers[0]);
    this->Surface.countSteps(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (this->Surface.isOpenEdge(carriers[0], i))
      {
        tryEnd(ring[i].neighbour());
      }
    }
  }
  else
  {
    visitFaces(this->Surface, point,
      [&](const Triangle& face) { std::for_each(face.begin(), face.end(), tryEnd); });
  }
  return best;
}

std::vector<Index> PathTracer::descentAlongEdges(Index vertex) const
{
  const TriangleMesh& mesh = this->Surface.mesh();
  struct Visit
  {
    double length;
    Index previous;
  };
  std::map<Index, Visit> visits{ { vertex, { 0.0, NoIndex } } };
  using Trial = std::pair<double, Index>;
  std::priority_queue<Trial, std::vector<Trial>, std::greater<>> queue;
  queue.emplace(0.0, vertex);
  while (!queue.empty())
  {
    const auto [length, here] = queue.top();
    queue.pop();
    const bool isLower = this->Field.distance(here) < this->Field.distance(vertex);
    if (here != vertex && (isLower || this->stepToSeed(PathPoint::atVertex(here))))
    {
      std::vector<Index> descent;
      for (Index v = here; v != vertex; v = visits[v].previous)
      {
        descent.push_back(v);
      }
      std::reverse(descent.begin(), descent.end());
      return descent;
    }
    const std::span<const RingEntry> ring = this->Surface.ring(here);
    this->Surface.countSteps(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Index next = ring[i].neighbour();
      if (!this->Surface.isOpenEdge(here, i) || !this->Field.isReached(next))
      {
        continue;
      }
      const double nextLength = length + norm(mesh.position(next) - mesh.position(here));
      const auto [known, isNew] = visits.emplace(next, Visit{ nextLength, here });
      if (isNew || nextLength < known->second.length)
      {
        known->second = { nextLength, here };
        queue.emplace(nextLength, next);
      }
    }
  }
  return {};
}

void PathTracer::tryEdge(
  const Vector3& position, const Triangle& face, Index a, Index b, std::optional<Step>& best) const
{
  if (!this->leadsToAim(a) || !this->leadsToAim(b) ||
    this->Field.nearestSeed(a) != this->Field.nearestSeed(b))
  {
    return;
  }
  const TriangleMesh& mesh = this->Surface.mesh();
  const double cost = this->Surface.costOf(face);
  const double fromA = this->Field.distance(a) / cost;
  const double fromB = this->Field.distance(b) / cost;
  const Vector3 edge = mesh.position(b) - mesh.position(a);
  const Vector3 toPoint = position - mesh.position(a);
  const double length = norm(edge);
  if (!(std::abs(fromA - fromB) < length))
  {
    return;
  }
  const EdgeMinimum least = leastOverEdge(
    fromA, fromB, length, dot(toPoint, edge) / length, norm(cross(toPoint, edge)) / length);
  const double fraction = least.x / length;
  const bool isInside = fraction > VertexFraction && fraction < 1.0 - VertexFraction;
  if (isInside && (!best || cost * least.total < best->total))
  {
    best = Step{ PathPoint::onEdge(a, b, fraction), cost * least.left, cost * least.total };
  }
}

void PathTracer::tryVertex(
  const Vector3& position, Index vertex, double cost, std::optional<Step>& best) const
{
  const double left = this->Field.distance(vertex);
  if (!this->leadsToAim(vertex) || (best && !(left < best->total)))
  {
    return;
  }
  const double total = left + cost * norm(position - this->Surface.mesh().position(vertex));
  if (!best || total < best->total)
  {
    best = Step{ PathPoint::atVertex(vertex), left, total };
  }
}

}
