// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/WindowFront.h"

#include "base/MachineMemory.h"
#include "base/NumberText.h"
#include "mesh/Carriers.h"
#include "solve/ClosedTriangles.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace geodesic
{
namespace
{

/** By which fraction of the distance another path must be shorter to take the place of a window.
 * It lies above all rounding: a window that is as short as the other path must stay, as nobody else
 * may follow that path further. */
constexpr double Margin = 1e-11;

/**
 * How far from one end of an edge paths by that end are shorter than the straight lines of a
 * window. The excess of the lines over these paths falls from the end on.
 * @param x, y   the source; the end lies at x = 0 and the edge along the positive axis
 * @param known  the distance at the end less that of the source
 */
double reachOfEnd(double x, double y, double known)
{
  return (x * x + y * y - known * known) / (2.0 * (x + known));
}

double gigabytes(std::size_t bytes)
{
  return static_cast<double>(bytes) * 1e-9;
}

}

WindowWorkspace::WindowWorkspace(const TriangleMesh& mesh)
  : places(3 * static_cast<std::size_t>(mesh.numberOfTriangles()), NoIndex)
  , isToSend(mesh.numberOfVertices(), 0)
{
}

void WindowWorkspace::empty(std::span<const Index> reached)
{
  this->free.clear();
  for (Index i = 0; i < this->waiting.size(); ++i)
  {
    this->waiting[i].list.clear();
    this->places[this->waiting[i].halfEdge] = NoIndex;
    this->free.push_back(i);
  }
  for (const Index vertex : reached)
  {
    this->isToSend[vertex] = 0;
  }
}

WindowFront::WindowFront(const TriangleMesh& mesh, const EdgeTable& edges,
  const ClosedTriangles& closed, const SolveOptions& options, double first, StopLimit& limit,
  DistanceField& field, WindowWorkspace& workspace)
  : Mesh(mesh)
  , Edges(edges)
  , Closed(closed)
  , Options(options)
  , Limit(limit)
  , Field(field)
  , Work(workspace)
  , First(first)
  , MostBytes(options.memoryLimit > 0 ? options.memoryLimit : machineMemory() / 4 * 3)
  , NextReport(options.progressInterval)
{
  constexpr double bucket = 0.5;
  const double width = bucket * mesh.meanLongestEdge();
  this->Work.queue.start(width > 0.0 ? width : 1.0, 2.0 * mesh.longestEdgeLength());
  this->findBarriers();
}

void WindowFront::findBarriers()
{
  if (this->Options.excluded.empty() && this->Options.closedTriangles.empty())
  {
    return;
  }
  this->Passable.assign(this->Mesh.numberOfTriangles(), true);
  this->Turning.assign(this->Mesh.numberOfVertices(), false);
  for (Index t = 0; t < this->Mesh.numberOfTriangles(); ++t)
  {
    const Triangle& corners = this->Mesh.triangle(t);
    if (this->Options.isClosed(t) ||
      std::any_of(corners.begin(), corners.end(),
        [&](Index corner) { return this->Options.isExcluded(corner); }))
    {
      this->Passable[t] = false;
      for (const Index corner : corners)
      {
        this->Turning[corner] = true;
      }
    }
  }
}

double WindowFront::lengthOf(Index a, Index b) const
{
  return norm(this->Mesh.position(std::max(a, b)) - this->Mesh.position(std::min(a, b)));
}

WindowFront::LaidTriangle WindowFront::laid(Index halfEdge) const
{
  LaidTriangle laid;
  laid.triangle = halfEdge / 3;
  const Triangle& corners = this->Mesh.triangle(laid.triangle);
  const Index k = halfEdge % 3;
  laid.apex = corners[k];
  const Index a = corners[(k + 1) % 3];
  const Index b = corners[(k + 2) % 3];
  laid.lower = std::min(a, b);
  laid.higher = std::max(a, b);
  const Vector3& origin = this->Mesh.position(laid.lower);
  const Vector3 edge = this->Mesh.position(laid.higher) - origin;
  const Vector3 side = this->Mesh.position(laid.apex) - origin;
  laid.length = norm(edge);
  laid.x = laid.length > 0.0 ? dot(side, edge) / laid.length : 0.0;
  laid.y = laid.length > 0.0 ? norm(cross(edge, side)) / laid.length : norm(side);
  return laid;
}

WindowFront::Target WindowFront::targetOf(Index halfEdge, Index from, Index to, double length) const
{
  return { halfEdge, length, this->Field.distance(std::min(from, to)),
    this->Field.distance(std::max(from, to)) };
}

bool WindowFront::leadsOn(Index halfEdge) const
{
  for (Index other = this->Edges.next(halfEdge); other != halfEdge; other = this->Edges.next(other))
  {
    if (this->isPassable(other / 3))
    {
      return true;
    }
  }
  return false;
}

void WindowFront::startAt(const SurfacePoint& point, double value, Index number)
{
  const Carriers carriers = carriersOf(this->Mesh, point);
  if (carriers.size() == 1)
  {
    this->reach(carriers[0], value, number);
    if (this->Field.distance(carriers[0]) == value && !this->Work.isToSend[carriers[0]])
    {
      this->queueVertex(carriers[0], value);
    }
    return;
  }
  const Vector3 position = this->Mesh.positionOf(point);
  for (const Index t : this->Mesh.trianglesWith({ carriers.begin(), carriers.end() }))
  {
    if (this->Options.isClosed(t))
    {
      continue;
    }
    const Triangle& corners = this->Mesh.triangle(t);
    for (const Index corner : corners)
    {
      this->reach(corner, value + norm(this->Mesh.position(corner) - position), number);
    }
    for (Index k = 0; k < 3 && this->isPassable(t) && !this->Edges.isRepeated(t); ++k)
    {
      // Only the edge that has the point is no way out of the triangle.
      if (carriers.contains(corners[k]))
      {
        this->sendThrough(3 * t + k, position, value, number);
      }
    }
  }
}

void WindowFront::sendThrough(Index halfEdge, const Vector3& from, double distance, Index seed)
{
  if (!this->leadsOn(halfEdge))
  {
    return;
  }
  const LaidTriangle laid = this->laid(halfEdge);
  if (!(laid.length > 0.0))
  {
    return;
  }
  const Vector3& origin = this->Mesh.position(laid.lower);
  const Vector3 edge = this->Mesh.position(laid.higher) - origin;
  const Vector3 side = from - origin;
  const Target target = this->targetOf(halfEdge, laid.lower, laid.higher, laid.length);
  this->offer(target,
    { 0.0, laid.length, dot(side, edge) / laid.length, norm(cross(edge, side)) / laid.length,
      distance, seed });
}

void WindowFront::sendFrom(Index vertex)
{
  const double distance = this->Field.distance(vertex);
  const Index seed = this->Field.nearestSeed(vertex);
  const Vector3& position = this->Mesh.position(vertex);
  const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    if (this->Closed.isOpenEdge(vertex, i))
    {
      const Index neighbour = ring[i].neighbour();
      this->reach(neighbour, distance + this->lengthOf(vertex, neighbour), seed);
    }
  }
  for (const Index t : this->Edges.trianglesAt(vertex))
  {
    if (!this->isPassable(t) || this->Edges.isRepeated(t))
    {
      continue;
    }
    const Triangle& corners = this->Mesh.triangle(t);
    const Index k = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
    this->sendThrough(3 * t + k, position, distance, seed);
  }
  this->Crossed += ring.size();
}

void WindowFront::reach(Index vertex, double distance, Index seed)
{
  // Two ways of one length, on which distances differ by rounding.
  constexpr double rounding = 1e-12;
  const double known = this->Field.distance(vertex);
  if (distance > known * (1.0 + rounding) || this->Options.isExcluded(vertex) ||
    distance > this->Limit.value())
  {
    return;
  }
  const bool isTie = distance >= known * (1.0 - rounding);
  const Index nearest = isTie ? std::min(seed, this->Field.nearestSeed(vertex)) : seed;
  this->Field.setDistance(vertex, std::min(distance, known));
  this->Field.setNearestSeed(vertex, nearest);
  if (!isTie && this->canTurn(vertex))
  {
    this->queueVertex(vertex, distance);
  }
}

void WindowFront::queueVertex(Index vertex, double distance)
{
  this->Work.isToSend[vertex] = 1;
  this->Work.queue.push(3 * this->Mesh.numberOfTriangles() + vertex, distance - this->First);
}

void WindowFront::offer(const Target& target, Window window)
{
  double atFirst = window.lineTo(window.first);
  double atLast = window.lineTo(window.last);
  const double margin = Margin * (window.offset + atFirst + atLast);
  const double lower = target.atLower - window.offset + margin;
  const double higher = target.atHigher - window.offset + margin;
  const double restAtFirst = target.length - window.first;
  const double restAtLast = target.length - window.last;
  if (atLast - window.last > lower || atFirst - restAtFirst > higher)
  {
    return;
  }
  if (atFirst - window.first > lower)
  {
    const double cut = reachOfEnd(window.x, window.y, lower);
    window.first = cut > window.first && cut < window.last ? cut : window.first;
  }
  if (atLast - restAtLast > higher)
  {
    const double cut = target.length - reachOfEnd(target.length - window.x, window.y, higher);
    window.last = cut > window.first && cut < window.last ? cut : window.last;
  }
  const double line = window.x < window.first ? atFirst
    : window.x > window.last                  ? atLast
                                              : window.y;
  const double least = window.offset + line;
  if (!(window.first < window.last) || least > this->Limit.value())
  {
    return;
  }
  for (Index other = this->Edges.next(target.halfEdge); other != target.halfEdge;
       other = this->Edges.next(other))
  {
    if (this->isPassable(other / 3))
    {
      this->wait(other, window, least);
    }
  }
}

void WindowFront::wait(Index halfEdge, const Window& window, double least)
{
  Index& place = this->Work.places[halfEdge];
  bool isFirst = false;
  if (place == NoIndex)
  {
    isFirst = true;
    if (this->Work.free.empty())
    {
      this->Work.free.push_back(static_cast<Index>(this->Work.waiting.size()));
      this->Work.waiting.emplace_back();
    }
    place = this->Work.free.back();
    this->Work.free.pop_back();
  }
  WindowWorkspace::Waiting& waiting = this->Work.waiting[place];
  const std::size_t before = waiting.list.bytes();
  waiting.list.insert(window);
  this->Work.bytes += waiting.list.bytes() - before;
  if (isFirst || least < waiting.least)
  {
    waiting.least = least;
    waiting.halfEdge = halfEdge;
    this->Work.queue.push(halfEdge, least - this->First);
  }
}

void WindowFront::reachApex(const LaidTriangle& laid, std::span<const Window> windows)
{
  // A straight line that misses the apex by so little ends there with no error to speak of, as the
  // detour grows with the square. Without this, rounding could leave an apex between two windows.
  const double miss = 1e-7 * laid.length;
  for (const Window& w : windows)
  {
    const double height = w.y + laid.y;
    const double at = height > 0.0 ? w.x + (laid.x - w.x) * (w.y / height) : w.x;
    if (at >= w.first && at <= w.last)
    {
      const double along = laid.x - w.x;
      this->reach(laid.apex, w.offset + std::sqrt(along * along + height * height), w.seed);
    }
    else if (at > w.first - miss && at < w.last + miss)
    {
      const double end = at < w.first ? w.first : w.last;
      this->reach(laid.apex, w.distanceAt(end) + std::hypot(end - laid.x, laid.y), w.seed);
    }
  }
}

void WindowFront::crossTo(const LaidTriangle& laid, std::span<const Window> windows, bool isLower)
{
  const Index corner = isLower ? laid.lower : laid.higher;
  const Index opposite = isLower ? laid.higher : laid.lower;
  const Triangle& corners = this->Mesh.triangle(laid.triangle);
  const Index k = corners[0] == opposite ? 0 : corners[1] == opposite ? 1 : 2;
  const Index side = 3 * laid.triangle + k;
  if (!this->leadsOn(side))
  {
    return;
  }
  const double length = this->lengthOf(corner, laid.apex);
  if (!(length > 0.0))
  {
    return;
  }
  const Target target = this->targetOf(side, corner, laid.apex, length);
  // All is measured from the corner: x along the crossed edge, and along the side to the apex.
  const double apexX = isLower ? laid.x : laid.length - laid.x;
  const double alongX = apexX / length;
  const double alongY = laid.y / length;
  const bool isTurned = laid.apex < corner;
  const auto pass = [&](const Window& w)
  {
    const double sourceX = isLower ? w.x : laid.length - w.x;
    const double first = isLower ? w.first : laid.length - w.last;
    const double last = isLower ? w.last : laid.length - w.first;
    const double height = w.y + laid.y;
    const double atApex = height > 0.0 ? sourceX + (apexX - sourceX) * (w.y / height) : sourceX;
    if (!(first < atApex))
    {
      return;
    }
    const auto onSide = [&](double at)
    {
      const double place = at * w.y / (alongX * w.y - alongY * (at - sourceX));
      return std::clamp(place, 0.0, length);
    };
    const double from = first > 0.0 ? onSide(first) : 0.0;
    const double to = last < atApex ? onSide(last) : length;
    if (!(from < to))
    {
      return;
    }
    const double x = sourceX * alongX - w.y * alongY;
    const double y = std::max(0.0, alongX * w.y + alongY * sourceX);
    if (isTurned)
    {
      this->offer(target, { length - to, length - from, length - x, y, w.offset, w.seed });
    }
    else
    {
      this->offer(target, { from, to, x, y, w.offset, w.seed });
    }
  };
  // In the order in which they lie on the side, so that each goes to the end of the list.
  if (isLower != isTurned)
  {
    std::for_each(windows.begin(), windows.end(), pass);
  }
  else
  {
    std::for_each(windows.rbegin(), windows.rend(), pass);
  }
}

void WindowFront::crossTriangle(Index halfEdge)
{
  Index& place = this->Work.places[halfEdge];
  WindowList& list = this->Work.waiting[place].list;
  this->Crossing.clear();
  this->Crossing.swap(list);
  this->Work.free.push_back(place);
  place = NoIndex;
  const std::span<const Window> windows = this->Crossing.windows();
  const LaidTriangle laid = this->laid(halfEdge);
  this->reachApex(laid, windows);
  this->crossTo(laid, windows, true);
  this->crossTo(laid, windows, false);
  this->Crossed += windows.size();
}

void WindowFront::checkMemory() const
{
  if (this->Work.bytes > this->MostBytes)
  {
    throw std::runtime_error("The windows of exact distances take " +
      textOf(gigabytes(this->Work.bytes)) + " GB, more than the memory limit of " +
      textOf(gigabytes(this->MostBytes)) + " GB, after " +
      std::to_string(this->Field.reached().size()) + " of " +
      std::to_string(this->Mesh.numberOfVertices()) +
      " vertices. Raise the limit, set a maximum distance, coarsen the surface, or use the method "
      "FastMarching.");
  }
}

bool WindowFront::mayGoOn()
{
  constexpr std::size_t interval = 1024;
  if (this->Crossed < this->NextLook)
  {
    return true;
  }
  this->NextLook = this->Crossed + interval;
  this->Limit.update();
  this->checkMemory();
  const std::size_t reached = this->Field.reached().size();
  bool goesOn = true;
  while (this->Options.onProgress && this->Options.progressInterval > 0 && goesOn &&
    reached >= this->NextReport)
  {
    goesOn = this->Options.onProgress(this->NextReport);
    this->NextReport += this->Options.progressInterval;
  }
  return goesOn;
}

bool WindowFront::march()
{
  BucketQueue& queue = this->Work.queue;
  bool goesOn = true;
  std::array<Index, 1> room;
  while (!queue.isEmpty() && goesOn)
  {
    const std::uint64_t bucket = queue.nextBucket();
    if (this->First + queue.keyOf(bucket) > this->Limit.value())
    {
      break;
    }
    queue.hasBefore(bucket + 1);
    this->take(queue.take(room)[0]);
    goesOn = this->mayGoOn();
  }
  this->Work.empty(this->Field.reached());
  return goesOn;
}

void WindowFront::take(Index item)
{
  const Index halfEdges = 3 * this->Mesh.numberOfTriangles();
  if (item >= halfEdges)
  {
    const Index vertex = item - halfEdges;
    if (this->Work.isToSend[vertex])
    {
      this->Work.isToSend[vertex] = 0;
      this->sendFrom(vertex);
    }
    return;
  }
  // None waits where a half-edge was queued twice, as a nearer window came.
  if (this->Work.places[item] != NoIndex)
  {
    this->crossTriangle(item);
  }
}

}
