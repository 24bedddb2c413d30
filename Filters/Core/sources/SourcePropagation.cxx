// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sources/SourcePropagation.h"

#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/DistanceField.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace geodesic
{
namespace
{

/** Lengths and distances that differ by less, relatively, count as equal. It is well above rounding
 * errors, so that these decide nothing. */
constexpr double Rounding = 1e-9;
/** Distances at a vertex that differ by less, relatively, are equal. */
constexpr double EqualDistances = 1e-10;
/** See VirtualSource::fit(). More joins more sources that are not one: on surfaces flattened 100
 * times a prototype had values too small by at most 0.6, 2 and 13 % with 0.01, 0.03 and 0.1, and
 * the least mean errors on usual ones with 0.03. */
constexpr double MostMoved = 0.03;
/** Width of a bucket, in mean longest edges of vertices. A round number would put borders of
 * buckets at distances that are frequent on grids, where rounding would tell which bucket comes
 * first. */
constexpr double BucketWidth = 0.2937;

/** How far along the line from a place on the x axis to the third corner it meets the line from a
 * source through a point of the axis, as a fraction from 0 to 1. */
double meeting(const VirtualSource& source, double through, double from, const SideFrame& frame)
{
  const double turn = (through - source.x) * frame.height + source.y * (frame.x - from);
  return through == from || turn == 0.0 ? 0.0
                                        : std::clamp(source.y * (through - from) / turn, 0.0, 1.0);
}

bool isBefore(const DistanceOrigin& a, const DistanceOrigin& b)
{
  return std::tie(a.label, a.offset) < std::tie(b.label, b.offset);
}

}

SourceWorkspace::SourceWorkspace(const TriangleMesh& mesh)
  : edges(mesh)
  , store(std::size_t{ 3 } * mesh.numberOfTriangles())
  , origins(mesh.numberOfVertices())
  , isQueued(mesh.numberOfVertices())
{
}

SourcePropagation::SourcePropagation(const TriangleMesh& mesh, const SeedFront& front,
  const ClosedTriangles& closed, const SolveOptions& options, StopLimit& limit,
  DistanceField& field, SourceWorkspace& workspace)
  : Mesh(mesh)
  , Front(front)
  , Closed(closed)
  , Options(options)
  , Limit(limit)
  , Field(field)
  , Work(workspace)
  , Passable(mesh, workspace.edges, options)
  , Control(options, limit)
{
  const auto [least, most] = std::minmax_element(front.labels.begin(), front.labels.end(),
    [](const Label& a, const Label& b) { return a.value < b.value; });
  this->First = least->value;
  const double width = BucketWidth * mesh.meanLongestEdge();
  this->Queue.start(
    width > 0.0 ? width : 1.0, 2.0 * mesh.longestEdgeLength() + most->value - least->value);
  std::fill(this->Work.isQueued.begin(), this->Work.isQueued.end(), std::uint8_t{ 0 });
  this->Work.store.clear();
  this->Work.sidesWithNews.clear();
  this->Work.loweredVertices.clear();
}

bool SourcePropagation::run()
{
  for (const FrontStart& start : this->Front.starts)
  {
    const double offset = this->Front.labels[start.label].value;
    this->proposeDistance(start.vertex, { start.label, offset }, offset + start.length);
  }
  for (Index number = 0; number < this->Front.labels.size(); ++number)
  {
    this->startAt(this->Front.labels[number], number);
    if (!this->Control.reportAgain())
    {
      return false;
    }
  }
  this->takeOver();
  while (!this->Queue.isEmpty() &&
    this->First + this->Queue.keyOf(this->Queue.nextBucket()) <= this->Limit.value())
  {
    this->takeRound();
    if (!this->Control.mayGoOn(this->Field.reached().size(), this->Work.round.size()))
    {
      return false;
    }
    for (const Index item : this->Work.round)
    {
      const Index sides = 3 * this->Mesh.numberOfTriangles();
      item < sides ? this->propagateSide(item) : this->propagateVertex(item - sides);
    }
    this->takeOver();
  }
  for (const Index vertex : this->Field.reached())
  {
    this->Field.setNearestSeed(vertex, this->Front.labels[this->Work.origins[vertex].label].seed);
  }
  return true;
}

/** Lets a label's source shine through the sides opposite to it of all triangles that it is in. */
void SourcePropagation::startAt(const Label& label, Index number)
{
  const Carriers carriers = carriersOf(this->Mesh, label.origin);
  for (const Index triangle : this->Mesh.trianglesWith({ carriers.begin(), carriers.end() }))
  {
    if (!this->Passable.contains(triangle) || this->Work.edges.isRepeated(triangle))
    {
      continue;
    }
    for (Index side = 3 * triangle; side < 3 * triangle + 3; ++side)
    {
      const Corners corners = this->cornersOf(side);
      if (carriers.contains(corners.third))
      {
        const SideFrame seen(
          this->Mesh.position(corners.first), this->Mesh.position(corners.second), label.position);
        if (seen.length > 0.0)
        {
          this->crossEdge(side, corners.first, seen.length,
            { seen.x, -seen.height, label.value, 0.0, seen.length, number });
        }
      }
    }
  }
}

/** Takes all items of the first bucket. */
void SourcePropagation::takeRound()
{
  this->Queue.hasBefore(this->Queue.nextBucket() + 1);
  this->Work.round.resize(this->Queue.next(SIZE_MAX).size());
  this->Queue.take(this->Work.round);
}

void SourcePropagation::propagateVertex(Index vertex)
{
  this->Work.isQueued[vertex] = 0;
  const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    if (this->Closed.isOpenEdge(vertex, i))
    {
      const Index neighbour = ring[i].neighbour();
      const double length = norm(this->Mesh.position(neighbour) - this->Mesh.position(vertex));
      const double offset = this->Field.distance(vertex);
      this->proposeDistance(
        neighbour, { this->Work.origins[vertex].label, offset }, offset + length);
    }
  }
}

void SourcePropagation::propagateSide(Index side)
{
  const Corners corners = this->cornersOf(side);
  const SideFrame frame = this->frameOf(corners);
  this->Work.store.visitNews(
    side, [&](const SeenSource& seen) { this->propagate(side, corners, frame, seen.source); });
  this->Work.store.forgetNews(side);
}

/** Hands a source on through the two other sides of the triangle behind a side: the source itself
 * where its straight lines reach them, and where they miss the third corner a source at the end of
 * the lit part. */
void SourcePropagation::propagate(
  Index side, const Corners& corners, const SideFrame& frame, VirtualSource source)
{
  this->fit(source, corners, frame.length);
  const Index second = EdgeTable::following(side);
  const Exit atFirst{ EdgeTable::following(second), corners.first, 0.0, -1.0 };
  const Exit atSecond{ second, corners.second, frame.length, 1.0 };
  const double meets = source.crossing(frame.x, frame.height);
  if (meets > source.first)
  {
    const double far = meeting(source, source.last, atFirst.at, frame);
    this->shineThrough(atFirst, frame, source, meeting(source, source.first, atFirst.at, frame),
      meets <= source.last ? 1.0 : far);
  }
  if (meets < source.last)
  {
    const double far = meeting(source, source.first, atSecond.at, frame);
    this->shineThrough(atSecond, frame, source, meeting(source, source.last, atSecond.at, frame),
      meets >= source.first ? 1.0 : far);
  }
  // Where the line to the third corner grazes an end of the lit part, rounding would tell on which
  // side of that end it passes: both cases are followed then.
  const double grazing = Rounding * frame.length;
  if (meets <= source.first + grazing)
  {
    const VirtualSource bent = this->bentAt(source, source.first, atFirst);
    this->shineThrough(atFirst, frame, bent, 0.0, 1.0);
    if (source.first == atFirst.at)
    {
      this->shineThrough(atSecond, frame, bent, 0.0, 1.0);
    }
  }
  if (meets >= source.last - grazing)
  {
    const VirtualSource bent = this->bentAt(source, source.last, atSecond);
    this->shineThrough(atSecond, frame, bent, 0.0, 1.0);
    if (source.last == atSecond.at)
    {
      this->shineThrough(atFirst, frame, bent, 0.0, 1.0);
    }
  }
}

/** The source of lines that are bent at an end of the lit part. @param nearest the exit at that end
 */
VirtualSource SourcePropagation::bentAt(
  const VirtualSource& source, double at, const Exit& nearest) const
{
  VirtualSource bent{ at, 0.0, source.onSide(at), 0.0, 0.0, source.label };
  const double atCorner = this->Field.distance(nearest.corner);
  if (at == nearest.at && atCorner < bent.offset)
  {
    bent.offset = atCorner;
    bent.label = this->Work.origins[nearest.corner].label;
  }
  return bent;
}

/** Proposes a source to the triangles behind an exit.
 * @param source    in the frame of the side that it came through
 * @param from, to  the lit part of the exit, from 0 at its corner to 1 at the third corner */
void SourcePropagation::shineThrough(
  const Exit& exit, const SideFrame& frame, const VirtualSource& source, double from, double to)
{
  const double upX = frame.x - exit.at;
  const double upY = frame.height;
  const double length = std::sqrt(upX * upX + upY * upY);
  if (!(length > 0.0))
  {
    return;
  }
  const double fromX = source.x - exit.at;
  const double depth = exit.turn * (source.y * upX - fromX * upY) / length;
  this->crossEdge(exit.side, exit.corner, length,
    { (fromX * upX + source.y * upY) / length, -std::max(0.0, depth), source.offset, from * length,
      to * length, source.label });
}

/** Proposes a source to the triangles on the other side of an edge. @param source in the frame
 * whose x axis goes along the edge from @p corner */
void SourcePropagation::crossEdge(
  Index side, Index corner, double length, const VirtualSource& source)
{
  VirtualSource mirrored = source;
  mirrored.x = length - source.x;
  mirrored.first = length - source.last;
  mirrored.last = length - source.first;
  for (Index other = this->Work.edges.next(side); other != side;
       other = this->Work.edges.next(other))
  {
    if (this->Passable.contains(EdgeTable::triangleOf(other)))
    {
      this->proposeSource(other, this->cornersOf(other).first == corner ? source : mirrored);
    }
  }
}

void SourcePropagation::proposeSource(Index side, VirtualSource source)
{
  const Corners corners = this->cornersOf(side);
  const SideFrame frame = this->frameOf(corners);
  const double rounding = Rounding * frame.length;
  source.first = source.first < rounding ? 0.0 : source.first;
  source.last = source.last > frame.length - rounding ? frame.length : source.last;
  source.snap(frame.length, rounding);
  this->fit(source, corners, frame.length);
  const PathFromSource toThird = source.pathTo(frame.x, frame.height);
  const PathFromSource toFirst = source.pathToFirst();
  const PathFromSource toSecond = source.pathToSecond(frame.length);
  this->proposeDistance(corners.third, { source.label, toThird.offset }, toThird.distance);
  this->proposeDistance(corners.first, { source.label, toFirst.offset }, toFirst.distance);
  this->proposeDistance(corners.second, { source.label, toSecond.offset }, toSecond.distance);
  const SeenSource seen{ source, { toThird.distance, toFirst.distance, toSecond.distance } };
  if (this->Work.store.isWorthwhile(side, seen) && this->isUseful(corners, frame, seen))
  {
    this->Work.sources.push_back({ side, seen });
  }
}

/**
 * Whether a source can give a shorter path than the present distances at the corners do, to
 * anything behind the side. S.-Q. Xin, G.-J. Wang, Improving Chen and Han's algorithm on the
 * discrete geodesic problem, ACM Trans. Graph. 28 (2009).
 */
bool SourcePropagation::isUseful(
  const Corners& corners, const SideFrame& frame, const SeenSource& seen) const
{
  constexpr double least = 1.0 - Rounding;
  const VirtualSource& source = seen.source;
  const double atFirst = this->Field.distance(corners.first);
  const double atSecond = this->Field.distance(corners.second);
  const double atThird = this->Field.distance(corners.third);
  const bool isFirst = source.x == 0.0 && source.y == 0.0;
  const bool isSecond = source.x == frame.length && source.y == 0.0;
  // A source at a corner is of use only where lines bend round that corner.
  if ((isFirst || isSecond) && seen.distances[0] > atThird * (1.0 + Rounding))
  {
    return false;
  }
  const double ofFirst = source.onSide(source.first);
  const double ofLast = source.onSide(source.last);
  const auto fromThird = [&](double at)
  { return atThird + std::sqrt((frame.x - at) * (frame.x - at) + frame.height * frame.height); };
  const bool isBehindFirst = !isFirst && ofLast > (atFirst + source.last) * least;
  const bool isBehindSecond =
    !isSecond && ofFirst > (atSecond + frame.length - source.first) * least;
  const bool isBehindThird =
    ofFirst > fromThird(source.first) * least && ofLast > fromThird(source.last) * least;
  return !(isBehindFirst || isBehindSecond || isBehindThird);
}

void SourcePropagation::proposeDistance(Index vertex, const DistanceOrigin& origin, double value)
{
  // Most are no news, so it is worth while to look before they are stored.
  const double old = this->Field.distance(vertex);
  const bool isNews = value < old * this->Control.keptFraction() ||
    (value <= old * (1.0 + EqualDistances) && isBefore(origin, this->Work.origins[vertex]));
  if (isNews && !this->Options.isExcluded(vertex))
  {
    this->Work.distances.push_back({ vertex, origin, value });
  }
}

/** Takes over what the items of a round have proposed, and queues what has changed. */
void SourcePropagation::takeOver()
{
  for (const ProposedDistance& proposed : this->Work.distances)
  {
    this->lower(proposed);
  }
  for (const ProposedSource& proposed : this->Work.sources)
  {
    if (this->Work.store.offer(proposed.side, proposed.seen))
    {
      this->Work.sidesWithNews.push_back(proposed.side);
    }
  }
  this->Work.distances.clear();
  this->Work.sources.clear();
  for (const Index side : this->Work.sidesWithNews)
  {
    double least = DistanceField::Unreached;
    this->Work.store.visitNews(
      side, [&](const SeenSource& seen) { least = std::min(least, seen.source.leastDistance()); });
    this->push(side, least);
  }
  for (const Index vertex : this->Work.loweredVertices)
  {
    this->push(3 * this->Mesh.numberOfTriangles() + vertex, this->Field.distance(vertex));
  }
  this->Work.sidesWithNews.clear();
  this->Work.loweredVertices.clear();
}

/** Of equal distances that of the smallest seed is kept, as in fast marching, and of these the one
 * whose path bends first. */
void SourcePropagation::lower(const ProposedDistance& proposed)
{
  const double old = this->Field.distance(proposed.vertex);
  DistanceOrigin& origin = this->Work.origins[proposed.vertex];
  const bool isEqual = proposed.value >= old * (1.0 - EqualDistances) &&
    proposed.value <= old * (1.0 + EqualDistances);
  if (!isEqual ? proposed.value < old : isBefore(proposed.origin, origin))
  {
    origin = proposed.origin;
  }
  if (proposed.value < old * this->Control.keptFraction())
  {
    this->Field.setDistance(proposed.vertex, proposed.value);
    if (!this->Work.isQueued[proposed.vertex])
    {
      this->Work.isQueued[proposed.vertex] = 1;
      this->Work.loweredVertices.push_back(proposed.vertex);
    }
  }
}

void SourcePropagation::push(Index item, double distance)
{
  this->Queue.push(item, distance - this->First);
}

SourcePropagation::Corners SourcePropagation::cornersOf(Index side) const
{
  const Triangle& triangle = this->Mesh.triangle(EdgeTable::triangleOf(side));
  const Index third = side % 3;
  const Index first = third == 2 ? 0 : third + 1;
  return { triangle[first], triangle[3 - first - third], triangle[third] };
}

SideFrame SourcePropagation::frameOf(const Corners& corners) const
{
  return { this->Mesh.position(corners.first), this->Mesh.position(corners.second),
    this->Mesh.position(corners.third) };
}

void SourcePropagation::fit(VirtualSource& source, const Corners& corners, double length) const
{
  source.fit(length, this->distanceFrom(source, corners.first),
    this->distanceFrom(source, corners.second), MostMoved);
}

double SourcePropagation::distanceFrom(const VirtualSource& source, Index vertex) const
{
  const double distance = this->Field.distance(vertex);
  if (distance < DistanceField::Unreached)
  {
    const DistanceOrigin& origin = this->Work.origins[vertex];
    const bool isSame = origin.label == source.label &&
      std::abs(origin.offset - source.offset) <= Rounding * distance;
    return isSame ? distance : DistanceField::Unreached;
  }
  return distance;
}

}
