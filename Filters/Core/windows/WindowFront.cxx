// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/WindowFront.h"

#include "base/Interruption.h"
#include "base/MachineMemory.h"
#include "solve/ClosedTriangles.h"
#include "windows/LaidTriangle.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{
namespace
{

/** The mean area of a triangle; of many triangles, of a few thousand of them. */
double meanArea(const TriangleMesh& mesh)
{
  constexpr Index most = 4096;
  const Index step = mesh.numberOfTriangles() / most + 1;
  double sum = 0.0;
  Index count = 0;
  for (Index t = 0; t < mesh.numberOfTriangles(); t += step)
  {
    const Triangle& corners = mesh.triangle(t);
    const Vector3 side = mesh.position(corners[1]) - mesh.position(corners[0]);
    sum += 0.5 * norm(cross(side, mesh.position(corners[2]) - mesh.position(corners[0])));
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

/**
 * The width of the queue's buckets: half an edge. Where several seeds share a triangle's length,
 * as round a point of very many triangles, it follows the size of what each seed has for itself, or
 * fronts would run through each other within a bucket.
 */
double bucketWidth(const TriangleMesh& mesh, std::size_t seeds)
{
  constexpr double ofEdge = 0.5;
  constexpr double ofSeed = 0.05;
  const double edge = mesh.meanLongestEdge();
  double width = ofEdge * edge;
  if (seeds > 1)
  {
    const double triangles =
      static_cast<double>(mesh.numberOfTriangles()) / static_cast<double>(seeds);
    const double sizeOfSeed = std::sqrt(triangles * meanArea(mesh));
    width = sizeOfSeed < ofEdge * edge ? ofSeed * sizeOfSeed : width;
  }
  return width > 0.0 ? width : 1.0;
}

}

WindowWorkspace::WindowWorkspace(const TriangleMesh& mesh)
  : isToSend(mesh.numberOfVertices(), 0)
{
  this->places.reserve(3 * static_cast<std::size_t>(mesh.numberOfTriangles()));
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    Interruption::checkAt(t);
    this->places.insert(this->places.end(), 3, NoIndex);
  }
}

std::size_t WindowWorkspace::allBytes() const
{
  return this->bytes + this->junctions.bytes() + this->queue.bytes() +
    this->waiting.capacity() * sizeof(Waiting) + this->arrivals.size() * sizeof(Arrival) +
    (this->places.capacity() + this->free.capacity()) * sizeof(Index) +
    this->excesses.capacity() * sizeof(float) + this->isToSend.capacity();
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
  const ClosedTriangles& closed, const PassableTriangles& passable, const SolveOptions& options,
  std::size_t seeds, double first, StopLimit& limit, DistanceField& field,
  WindowWorkspace& workspace, const WindowMerging* merging)
  : Mesh(mesh)
  , Edges(edges)
  , Closed(closed)
  , Options(options)
  , Limit(limit)
  , Field(field)
  , Work(workspace)
  , First(first)
  , Passable(passable)
  , BucketWidth(bucketWidth(mesh, seeds))
  , Merging(merging)
  , MostBytes(options.memoryLimit > 0 ? options.memoryLimit : machineMemory() / 4 * 3)
  , NextReport(options.progressInterval)
{
  this->Work.arrivals.resize(merging && options.pathStarts.empty() ? 0 : mesh.numberOfVertices());
  this->Work.excesses.resize(merging ? mesh.numberOfVertices() : 0);
  this->findTurnsAtBarriers();
  this->begin();
}

void WindowFront::begin()
{
  this->Work.queue.start(this->BucketWidth, 4.0 * this->Mesh.longestEdgeLength());
  this->Work.junctions.clear();
  this->Work.starts.set(this->Mesh, this->Edges, this->Options.pathStarts);
  this->Work.bytes -= this->Work.kept.bytes();
  this->Work.kept.start(
    this->Mesh.numberOfTriangles(), this->Merging && !this->Options.pathStarts.empty());
  this->Takes = 0;
}

bool WindowFront::beginsAgain()
{
  if (!this->DoCircle)
  {
    return false;
  }
  this->DoCircle = false;
  this->DoesRemember = true;
  this->Turning.assign(this->Mesh.numberOfVertices(), true);
  this->Work.empty(this->Field.reached());
  this->Field.reset();
  this->begin();
  return true;
}

void WindowFront::findTurnsAtBarriers()
{
  if (this->Passable.areAll())
  {
    return;
  }
  this->Turning.assign(this->Mesh.numberOfVertices(), false);
  for (Index t = 0; t < this->Mesh.numberOfTriangles(); ++t)
  {
    if (!this->Passable.contains(t))
    {
      for (const Index corner : this->Mesh.triangle(t))
      {
        this->Turning[corner] = true;
      }
    }
  }
}

WindowFront::Target WindowFront::targetOf(Index halfEdge, Index from, Index to, double length) const
{
  const Index lower = std::min(from, to);
  const Index higher = std::max(from, to);
  Target target{ halfEdge, length, this->Field.distance(lower), this->Field.distance(higher), {} };
  if (this->Limit.goal().isKnown())
  {
    target.goal = placeBeside(this->Mesh, lower, higher, length, this->Limit.goal().middle());
  }
  return target;
}

bool WindowFront::leadsOn(Index halfEdge) const
{
  for (Index other = this->Edges.next(halfEdge); other != halfEdge; other = this->Edges.next(other))
  {
    if (this->Passable.contains(EdgeTable::triangleOf(other)))
    {
      return true;
    }
  }
  return false;
}

void WindowFront::sendFrom(Index vertex)
{
  const double distance = this->Field.distance(vertex);
  const Index seed = this->Field.nearestSeed(vertex);
  const float excess = this->excessAt(vertex);
  const Vector3& position = this->Mesh.position(vertex);
  const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    if (this->Closed.isOpenEdge(vertex, i))
    {
      const Index neighbour = ring[i].neighbour();
      this->reach(neighbour, distance + edgeLength(this->Mesh, vertex, neighbour), seed,
        Arrival::fromVertex(vertex), excess);
    }
  }
  const bool isSectorKnown = this->findSector(vertex);
  const auto send = [&](const TurnSector::Part& part)
  {
    const Triangle& corners = this->Mesh.triangle(part.triangle);
    const Index k = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
    this->sendThrough(3 * part.triangle + k, position, distance, seed, excess, part);
  };
  for (const Index t : this->Edges.trianglesAt(vertex))
  {
    if (!this->Passable.isClosed(t))
    {
      this->Work.starts.visitIn(t,
        [&](PathStarts::Start& start)
        {
          PathStarts::reach(start, distance + excess + norm(start.position - position), seed,
            Arrival::fromVertex(vertex));
        });
    }
    if (!isSectorKnown && this->Passable.contains(t) && !this->Edges.isRepeated(t))
    {
      send({ t });
    }
  }
  if (isSectorKnown)
  {
    std::ranges::for_each(this->Sector.parts(), send);
  }
  this->Crossed += ring.size();
}

bool WindowFront::findSector(Index vertex)
{
  // Windows that were merged do not tell from where the shortest path comes.
  return !this->Merging && !this->isTurning(vertex) &&
    this->Sector.find(
      this->Mesh, this->Edges, vertex, this->Work.arrivals[vertex], this->Field.distance(vertex));
}

void WindowFront::reach(
  Index vertex, double distance, Index seed, const Arrival& arrival, float excess)
{
  // Two paths of one length, on which distances differ by rounding.
  constexpr double rounding = 1e-12;
  const double known = this->Field.distance(vertex);
  if (distance > known * (1.0 + rounding) || this->Options.isExcluded(vertex) ||
    distance > this->Limit.exactly(vertex))
  {
    return;
  }
  const bool isTie = distance >= known * (1.0 - rounding);
  const double bound = this->Merging ? known + this->Work.excesses[vertex] : known;
  const bool isShorterWay =
    this->Merging ? distance + excess < bound : !isTie || seed < this->Field.nearestSeed(vertex);
  if (!this->Work.arrivals.empty() && isShorterWay)
  {
    this->Work.arrivals[vertex] = arrival;
  }
  const Index nearest = isTie ? std::min(seed, this->Field.nearestSeed(vertex)) : seed;
  if (this->Merging)
  {
    this->Work.excesses[vertex] =
      excessOf(std::min(distance + excess, bound) - std::min(distance, known));
  }
  this->Field.setDistance(vertex, std::min(distance, known));
  this->Field.setNearestSeed(vertex, nearest);
  if (!isTie && this->canTurn(vertex))
  {
    this->queueVertex(vertex);
  }
}

double WindowFront::keyOf(Index vertex) const
{
  const double left = PartOfOrder * this->Limit.leftFrom(vertex);
  return this->Field.distance(vertex) + left - this->First;
}

void WindowFront::queueVertex(Index vertex)
{
  this->Work.isToSend[vertex] = 1;
  this->Work.queue.push(3 * this->Mesh.numberOfTriangles() + vertex, this->keyOf(vertex));
}

}
