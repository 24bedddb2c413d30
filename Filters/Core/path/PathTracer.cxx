// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/PathTracer.h"

#include <algorithm>
#include <array>
#include <map>
#include <queue>

namespace geodesic
{
namespace
{

/** The part of what is left that a step across a face gains at least. Round a vertex where fields
 * of varying cost bend, steps that gain ever less went round for millions of points; then the path
 * goes on along an edge. A path of ten million edges gains more at each edge. */
constexpr double LeastGain = 1e-7;
/** The part that a step which gains less, as it only cuts off a corner, gains together with the one
 * before. A path of a million edges gains more. */
constexpr double LeastGainOfTwo = 1e-6;

/** A path of so many points gets room for four times as many when it is full: what grows is copied,
 * and fresh memory is slow. */
constexpr std::size_t LongPath = 4096;

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

/** The vertex that carries a point and is no end of an edge. @return NoIndex if there is none.
 * @pre the point shares a face with the edge */
Index carrierBeside(const PathPoint& point, Index a, Index b)
{
  Index beside = NoIndex;
  for (int i = 0; i < 3; ++i)
  {
    const Index corner = point.corners[i];
    beside = point.weights[i] > 0.0 && corner != a && corner != b ? corner : beside;
  }
  return beside;
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
  this->AimCarriers = this->Seeds.has(seed) ? this->Seeds[seed].carriers() : Carriers{};
}

std::optional<SurfacePath> PathTracer::traceToAim(
  const PathPoint& start, PathOrder order, const MayEnd& mayEnd) const
{
  SurfacePath path{ start };
  double left = DistanceField::Unreached;
  double leftBefore = DistanceField::Unreached;
  while (true)
  {
    const Place here = this->placeAt(path.back());
    const auto last = this->stepToSeed(here, order);
    std::optional<PathStep> step;
    if (!last && order == PathOrder::Edges)
    {
      step = this->stepAhead(here, path, left);
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
      if (path.size() >= LongPath && path.size() == path.capacity()) [[unlikely]]
      {
        path.reserve(4 * path.size());
      }
      path.push_back(step->point);
      if (mayEnd && mayEnd(path))
      {
        return path;
      }
      continue;
    }
    const std::vector<Index> descent =
      here.carriers.size() == 1 ? this->descentAlongEdges(here.carriers[0]) : std::vector<Index>{};
    if (descent.empty())
    {
      return std::nullopt;
    }
    for (Index vertex : descent)
    {
      path.push_back(PathPoint::atVertex(vertex));
    }
    const bool isLower =
      this->Field.distance(descent.back()) < this->Field.distance(here.carriers[0]);
    if (const auto end =
          isLower ? std::nullopt : this->stepToSeed(this->placeAt(path.back()), order))
    {
      // Other steps from there could lead back.
      path.push_back(end->point);
      return path;
    }
  }
}

std::optional<PathStep> PathTracer::stepToSeed(const Place& from, PathOrder order) const
{
  if (this->Aim != NoIndex && !this->mayReachAim(from.carriers))
  {
    return std::nullopt;
  }
  const TriangleMesh& mesh = this->Surface.mesh();
  std::optional<PathStep> best;
  const auto tryEnd = [&](Index seed, const Triangle& face)
  {
    if (this->Seeds.has(seed) && liesIn(this->Seeds[seed], face))
    {
      const PathPoint& end = this->Seeds[seed];
      const double cost = order == PathOrder::Edges
        ? this->Surface.costOf(face)
        : 0.5 * (costAt(this->Surface, from.point) + costAt(this->Surface, end));
      const double total = cost * norm(end.position(mesh) - from.position);
      if (!best || total < best->total)
      {
        best = PathStep{ end, 0.0, total };
      }
    }
  };
  visitFaces(this->Surface, from.point,
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

bool PathTracer::mayReachAim(const Carriers& from) const
{
  const Carriers& aim = this->AimCarriers;
  if (!mayShareFace(from, aim) || from.size() > 1 || aim.contains(from[0]))
  {
    return mayShareFace(from, aim);
  }
  const std::span<const RingEntry> ring = this->Surface.ring(from[0]);
  this->Surface.countSteps(ring.size());
  return std::any_of(ring.begin(), ring.end(),
    [&](const RingEntry& entry) { return aim.contains(entry.neighbour()); });
}

std::optional<PathStep> PathTracer::stepAhead(
  const Place& from, const SurfacePath& path, double left) const
{
  BestStep best(from.position);
  switch (from.carriers.size())
  {
    case 1:
      this->tryRoundVertex(from.carriers[0], best);
      break;
    case 2:
      this->tryBesideEdge(from.carriers, path, left, best);
      break;
    default:
      visitFaces(
        this->Surface, from.point, [&](const Triangle& face) { this->tryFace(face, best); });
  }
  return best.step();
}

void PathTracer::tryRoundVertex(Index vertex, BestStep& best) const
{
  const std::span<const RingEntry> ring = this->Surface.ring(vertex);
  this->Surface.countSteps(ring.size());
  if (ring.empty())
  {
    return;
  }
  StepCorner next = this->cornerAt(ring.front().neighbour());
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
  {
    const StepCorner corner = next;
    next = this->cornerAt(ring[i + 1].neighbour());
    if (!this->Surface.isOpen(vertex, i))
    {
      continue;
    }
    const StepFace face = this->faceOf({ vertex, corner.vertex, next.vertex });
    if (!best.tryEdge(corner, next, face))
    {
      best.tryVertex(corner, face.cost);
      best.tryVertex(next, face.cost);
    }
  }
}

void PathTracer::tryBesideEdge(
  const Carriers& ends, const SurfacePath& path, double left, BestStep& best) const
{
  const Index centre = centreOf(this->Surface, ends);
  const StepCorner a = this->cornerAt(centre);
  const StepCorner b = this->cornerAt(ends[ends[0] == centre ? 1 : 0]);
  const auto tryBeyond = [&](Index apex)
  {
    // The next step looks through the ring of one of the three: those of a and b were fetched when
    // they were the apex.
    this->Surface.mesh().prefetchRingStart(apex);
    const StepFace face = this->faceOf({ a.vertex, apex, b.vertex });
    const StepCorner c = this->cornerAt(apex);
    const bool isOnA = best.tryEdge(a, c, face);
    const bool isOnB = best.tryEdge(b, c, face);
    this->Surface.mesh().rings().prefetch(apex);
    if (!isOnA)
    {
      best.tryVertex(a, face.cost);
    }
    if (!isOnB)
    {
      best.tryVertex(b, face.cost);
    }
    if (!isOnA && !isOnB)
    {
      best.tryVertex(c, face.cost);
    }
  };
  if (path.size() == 1)
  {
    visitApexes(this->Surface, a.vertex, b.vertex, tryBeyond);
    return;
  }
  // The last step was the best one across its face, so that two steps across it, there and back,
  // leave no less.
  const Index last = carrierBeside(path[path.size() - 2], a.vertex, b.vertex);
  const auto isBehind = [&](Index apex) { return last == NoIndex || last == apex; };
  visitApexes(this->Surface, a.vertex, b.vertex,
    [&](Index apex)
    {
      if (!isBehind(apex))
      {
        tryBeyond(apex);
      }
    });
  if (best.hasStep() && best.total() - left <= MostBeyond * (best.total() - best.left()))
  {
    return;
  }
  // Where it comes back across a face, a third step there would be one of very many, to and fro
  // between the sides of a needle.
  const auto isCrossedTwice = [&](Index apex) {
    return path.size() > 2 && liesIn(path[path.size() - 3], { a.vertex, apex, b.vertex });
  };
  visitApexes(this->Surface, a.vertex, b.vertex,
    [&](Index apex)
    {
      if (isBehind(apex) && !isCrossedTwice(apex))
      {
        tryBeyond(apex);
      }
    });
}

StepFace PathTracer::faceOf(const Triangle& corners) const
{
  const double cost = this->Surface.costOf(corners);
  return { cost, this->Surface.isBypassed(cost, corners) };
}

void PathTracer::tryFace(const Triangle& face, BestStep& best) const
{
  const StepFace stepFace = this->faceOf(face);
  const std::array<StepCorner, 3> corners{ this->cornerAt(face[0]), this->cornerAt(face[1]),
    this->cornerAt(face[2]) };
  std::array<bool, 3> isBelow{};
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    if (best.tryEdge(corners[i], corners[next], stepFace))
    {
      isBelow[i] = true;
      isBelow[next] = true;
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    if (!isBelow[i])
    {
      best.tryVertex(corners[i], stepFace.cost);
    }
  }
}

std::optional<PathStep> PathTracer::stepAlongEdges(const Place& from) const
{
  BestStep best(from.position);
  const Carriers& carriers = from.carriers;
  const auto tryEnd = [&](Index vertex)
  {
    const bool isLower =
      carriers.size() > 1 || this->Field.distance(vertex) < this->Field.distance(carriers[0]);
    if (isLower)
    {
      const double cost = 0.5 * (costAt(this->Surface, from.point) + this->Surface.costOf(vertex));
      best.tryVertex(this->cornerAt(vertex), cost);
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
    visitFaces(this->Surface, from.point,
      [&](const Triangle& face) { std::for_each(face.begin(), face.end(), tryEnd); });
  }
  return best.step();
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
      (isLower || this->stepToSeed(this->placeAt(PathPoint::atVertex(here)), PathOrder::Vertices)))
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

}
