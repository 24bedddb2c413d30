// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The march of windows from the first in the queue to the last.
#include "windows/WindowFront.h"

#include "base/MachineMemory.h"
#include "base/NumberText.h"
#include "solve/ClosedTriangles.h"
#include "windows/LaidTriangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace geodesic
{
namespace
{

double gigabytes(std::size_t bytes)
{
  return static_cast<double>(bytes) * 1e-9;
}

}

bool WindowFront::march()
{
  // Where one hides the next, and so on, all are better turns at once.
  constexpr int mostTimes = 8;
  bool goesOn = this->takeAll();
  for (int i = 0; goesOn && !this->DoCircle && this->turnBeforeHidden(); ++i)
  {
    goesOn = this->takeAll();
    this->DoCircle = this->DoCircle || i == mostTimes;
  }
  this->checkMemory();
  return goesOn;
}

bool WindowFront::takeAll()
{
  BucketQueue& queue = this->Work.queue;
  bool goesOn = true;
  std::array<Index, 1> room;
  while (!queue.isEmpty() && goesOn && !this->DoCircle)
  {
    const std::uint64_t bucket = queue.nextBucket();
    if (this->First + queue.keyOf(bucket) > this->Limit.value())
    {
      break;
    }
    queue.hasBefore(bucket + 1);
    goesOn = this->take(queue.take(room)[0]);
  }
  return goesOn;
}

bool WindowFront::take(Index item)
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
  }
  else if (this->isJunction(item))
  {
    return !this->Work.junctions.doWaitAt(item) || this->passJunction(item);
  }
  // None waits where a half-edge was queued twice, as a nearer window came.
  else if (this->Work.places[item] != NoIndex)
  {
    this->takeWaiting(item);
    this->crossTriangle(item);
  }
  return this->mayGoOn();
}

bool WindowFront::turnBeforeHidden()
{
  // Above all rounding, and the margin of windows.
  constexpr double rounding = 1e-10;
  std::vector<Index> turns;
  for (const Index vertex : this->Field.reached())
  {
    const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
    const double known = this->Field.distance(vertex) + this->excessAt(vertex);
    const auto isHidden = [&](const RingEntry& entry)
    {
      const Index neighbour = entry.neighbour();
      const double along = known + edgeLength(this->Mesh, vertex, neighbour);
      return this->Field.distance(neighbour) > along + rounding * std::abs(along) &&
        along <= this->Limit.exactly(neighbour) && !this->Options.isExcluded(neighbour) &&
        this->Closed.isOpenEdge(vertex, static_cast<std::size_t>(&entry - ring.data()));
    };
    if (!this->isTurning(vertex) && std::ranges::any_of(ring, isHidden))
    {
      turns.push_back(vertex);
    }
  }
  this->Turning.resize(turns.empty() ? this->Turning.size() : this->Mesh.numberOfVertices());
  for (const Index vertex : turns)
  {
    this->Turning[vertex] = true;
    this->Work.queue.goBackTo(this->keyOf(vertex));
    this->queueVertex(vertex);
  }
  return !turns.empty();
}

bool WindowFront::mayGoOn()
{
  if (this->Crossed < this->NextLook)
  {
    return true;
  }
  this->NextLook = this->Crossed + LookInterval;
  this->Limit.update();
  this->checkMemory();
  this->DoCircle =
    !this->DoesRemember && this->Takes > FewTakes * (this->Field.reached().size() + LookInterval);
  if (!this->Options.onProgress || this->Options.progressInterval == 0)
  {
    return true;
  }
  const std::size_t reached = this->Field.reached().size();
  if (reached < this->NextReport)
  {
    return this->Options.onProgress(this->LastReport);
  }
  bool goesOn = true;
  for (; goesOn && reached >= this->NextReport; this->NextReport += this->Options.progressInterval)
  {
    goesOn = this->Options.onProgress(this->NextReport);
    this->LastReport = this->NextReport;
  }
  return goesOn;
}

void WindowFront::checkMemory() const
{
  const std::size_t bytes = this->bytes();
  if (bytes > this->MostBytes)
  {
    throw std::runtime_error("The method takes " + textOf(gigabytes(bytes)) +
      " GB, more than the memory limit of " + textOf(gigabytes(this->MostBytes)) + " GB, after " +
      std::to_string(this->Field.reached().size()) + " of " +
      std::to_string(this->Mesh.numberOfVertices()) +
      " vertices. Raise the limit, coarsen the surface, or use the method "
      "FastMarching.");
  }
}

}
