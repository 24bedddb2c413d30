// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/PathTracer.h"

#include <algorithm>
#include <array>
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

/** By so much of its length a step ahead may be farther than the last step has said. */
constexpr double MostBeyond = 0.01;

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

/** The flat source of phi on an edge, of the length c: at (x, -depth) from the edge's first end if
 * it is beside the edge's line, otherwise on that line, at x - depth or x + depth. */
struct FlatSource
{
  /** @param a, b  phi at the ends, less than @p c apart
   * @param inverse  1 / c */
  FlatSource(double a, double b, double c, double inverse)
    : x(0.5 * (c + (a - b) * (a + b) * inverse))
    , depth(
        0.5 * inverse * std::sqrt((a + b + c) * std::abs(a + b - c) * (c + a - b) * (c - a + b)))
    , isBeside(a + b - c > 0.0)
  {
  }

  /** The place q on the edge's line at which phi(q) + |p q| is least, without regard to the ends.
   * @param foot, height  of p: its place and its distance on the edge's line */
  double leastAt(double foot, double height) const
  {
    return this->isBeside ? (this->x * height + foot * this->depth) / (height + this->depth)
                          : std::clamp(foot, this->x - this->depth, this->x + this->depth);
  }
  /** phi at a place of the edge's line. */
  double phi(double place) const
  {
    const double away = place - this->x;
    return this->isBeside ? std::sqrt(away * away + this->depth * this->depth)
                          : std::sqrt(std::max(0.0, (away - this->depth) * (away + this->depth)));
  }

  double x;
  double depth;
  bool isBeside;
};

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

std::optional<SurfacePath> PathTracer::trace(
  const PathPoint& start, Index seed, PathOrder order, const MayEnd& mayEnd)
{
  // A shortest path stays among vertices whose nearest seed is its own.
  this->aimAt(seed);
  auto path = this->traceToAim(start, order, mayEnd);
  if (!path)
  {
    this->aimAt(NoIndex);
    path = this->traceToAim(start, order, mayEnd);
  }
  return path;
}

void PathTracer::aimAt(Index seed)
{
  this->Aim = seed;
  this->AimCarriers = seed == NoIndex ? Carriers{} : this->Seeds[seed].carriers();
}

bool PathTracer::leadsToAim(Index vertex) const
{
  return this->Field.isReached(vertex) &&
    (this->Aim == NoIndex || this->Field.nearestSeed(vertex) == this->Aim);
}

std::optional<SurfacePath> PathTracer::traceToAim(
  const PathPoint& start, PathOrder order, const MayEnd& mayEnd) const
{
  SurfacePath path{ start };
  double left = DistanceField::Unreached;
  double leftBefore = DistanceField::Unreached;
  while (true)
  {
    const PathPoint here = path.back();
    const auto last = this->stepToSeed(here, order);
    std::optional<Step> step;
    if (!last && order == PathOrder::Edges)
    {
      step = this->stepAhead(path, left);
    }
    // Along edges of different costs the straight line to a seed beside may be a detour.
    const bool mayBeDetour = order == PathOrder::Vertices && this->Surface.hasCosts();
    if ((!last || mayBeDetour) && (!step || !gains(step->left, left, leftBefore)))
    {
      step = this->stepAlongEdges(here);
    }
    constexpr double rounding = 1e-12;
    if (last && (!step || last->total <= step->total * (1.0 + rounding)))
    {
      path.push_back(last->point);
      return path;
    }
    if (step)
    {
      leftBefore = left;
      left = std::min(left, step->left);
      path.push_back(step->point);
      if (mayEnd && mayEnd(path))
      {
        return path;
      }
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
    const bool isLower =
      this->Field.distance(descent.back()) < this->Field.distance(here.carriers()[0]);
    if (const auto end = isLower ? std::nullopt : this->stepToSeed(path.back(), order))
    {
      // Other steps from there could lead back.
      path.push_back(end->point);
      return path;
    }
  }
}

std::optional<PathTracer::Step> PathTracer::stepToSeed(
  const PathPoint& point, PathOrder order) const
{
  if (this->Aim != NoIndex && !mayShareFace(point.carriers(), this->AimCarriers))
  {
    // No face has room for both, which is told sooner than the faces are found.
    return std::nullopt;
  }
  const TriangleMesh& mesh = this->Surface.mesh();
  std::optional<Step> best;
  const auto tryEnd = [&](Index seed, const Triangle& face)
  {
    if (seed != NoIndex && liesIn(this->Seeds[seed], face))
    {
      const PathPoint& end = this->Seeds[seed];
      const double cost = order == PathOrder::Edges
        ? this->Surface.costOf(face)
        : 0.5 * (costAt(this->Surface, point) + costAt(this->Surface, end));
      const double total = cost * norm(end.position(mesh) - point.position(mesh));
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
  const Place from{ here.carriers(), here.position(this->Surface.mesh()) };
  std::optional<Step> best;
  if (path.size() == 1 || from.carriers.size() != 2)
  {
    visitFaces(this->Surface, here, [&](const Triangle& face) { this->tryFace(from, face, best); });
    return best;
  }
  // The last step was the best one across its face, so that two steps across it, there and back,
  // leave no less.
  const auto isBehind = [&last = path[path.size() - 2]](const Triangle& face)
  { return liesIn(last, face); };
  visitFaces(this->Surface, here,
    [&](const Triangle& face)
    {
      if (!isBehind(face))
      {
        this->tryFace(from, face, best);
      }
    });
  if (best && best->total - left <= MostBeyond * (best->total - best->left))
  {
    return best;
  }
  // Where it comes back across a face, a third step there would be one of very many, to and fro
  // between the sides of a needle.
  const auto isCrossedTwice = [&](const Triangle& face)
  { return path.size() > 2 && liesIn(path[path.size() - 3], face); };
  visitFaces(this->Surface, here,
    [&](const Triangle& face)
    {
      if (isBehind(face) && !isCrossedTwice(face))
      {
        this->tryFace(from, face, best);
      }
    });
  return best;
}

void PathTracer::tryFace(const Place& from, const Triangle& face, std::optional<Step>& best) const
{
  const double cost = this->Surface.costOf(face);
  const std::array<Corner, 3> corners{ this->cornerAt(face[0]), this->cornerAt(face[1]),
    this->cornerAt(face[2]) };
  std::array<bool, 3> isBelow{};
  const auto tryOpposite = [&](int c, int a, int b)
  {
    if (from.carriers.contains(face[c]) &&
      this->tryEdge(from.position, corners[a], corners[b], cost, best))
    {
      isBelow[a] = true;
      isBelow[b] = true;
    }
  };
  tryOpposite(0, 1, 2);
  tryOpposite(1, 2, 0);
  tryOpposite(2, 0, 1);
  for (int c = 0; c < 3; ++c)
  {
    if (!isBelow[c] && (from.carriers.size() > 1 || from.carriers[0] != face[c]))
    {
      tryVertex(from.position, corners[c], cost, best);
    }
  }
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
      tryVertex(position, this->cornerAt(vertex), cost, best);
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
    if (here != vertex &&
      (isLower || this->stepToSeed(PathPoint::atVertex(here), PathOrder::Vertices)))
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

bool PathTracer::tryEdge(const Vector3& position, const Corner& a, const Corner& b, double cost,
  std::optional<Step>& best) const
{
  if (!a.leadsToAim || !b.leadsToAim ||
    (this->Aim == NoIndex &&
      this->Field.nearestSeed(a.vertex) != this->Field.nearestSeed(b.vertex)))
  {
    return false;
  }
  const double fromA = a.left / cost;
  const double fromB = b.left / cost;
  const Vector3 edge = b.position - a.position;
  const double square = dot(edge, edge);
  if (!((fromA - fromB) * (fromA - fromB) < square))
  {
    return false;
  }
  const double length = std::sqrt(square);
  const double inverse = 1.0 / length;
  const Vector3 toPoint = position - a.position;
  const double foot = dot(toPoint, edge) * inverse;
  const double height = norm(cross(toPoint, edge)) * inverse;
  const FlatSource source(fromA, fromB, length, inverse);
  const double place = source.leastAt(foot, height);
  const double fraction = place * inverse;
  if (!(fraction > VertexFraction && fraction < 1.0 - VertexFraction))
  {
    return false;
  }
  const double left = source.phi(place);
  const double total = left + std::sqrt((foot - place) * (foot - place) + height * height);
  if (!best || cost * total < best->total)
  {
    best = Step{ PathPoint::onEdge(a.vertex, b.vertex, fraction), cost * left, cost * total };
  }
  return true;
}

void PathTracer::tryVertex(
  const Vector3& position, const Corner& corner, double cost, std::optional<Step>& best)
{
  if (!corner.leadsToAim || (best && !(corner.left < best->total)))
  {
    return;
  }
  const double total = corner.left + cost * norm(position - corner.position);
  if (!best || total < best->total)
  {
    best = Step{ PathPoint::atVertex(corner.vertex), corner.left, total };
  }
}

}
