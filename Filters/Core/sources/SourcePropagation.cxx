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
/** Width of a bucket, in mean shortest sides of triangles: on a box with fillets a round of long
 * edges holds thousands of points at its corners, each of which would be lowered five times. A
 * round number would put borders of buckets at distances that are frequent on grids, where rounding
 * would tell which bucket comes first. */
constexpr double BucketWidth = 0.2937;
/** The least shortest side that counts, in mean longest edges, so that empty buckets are few. */
constexpr double LeastShare = 1e-3;

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
  , store(mesh)
  , vertices(mesh.numberOfVertices())
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
  , BesideBarrier(this->Passable.verticesBesideOthers(mesh))
  , Control(options, limit)
{
  const auto [least, most] = std::minmax_element(front.labels.begin(), front.labels.end(),
    [](const Label& a, const Label& b) { return a.value < b.value; });
  this->First = least->value;
  const double width = BucketWidth *
    std::max(this->Work.store.meanShortestSide(), LeastShare * mesh.meanLongestEdge());
  this->Queue.start(
    width > 0.0 ? width : 1.0, 2.0 * mesh.longestEdgeLength() + most->value - least->value);
  for (const Index vertex : this->Work.reached)
  {
    this->Work.vertices[vertex] = VertexDistance();
  }
  this->Work.reached.clear();
  this->Work.store.clear();
  this->Work.sidesWithNews.clear();
  this->Work.loweredVertices.clear();
}

bool SourcePropagation::run()
{
  for (const FrontStart& start : this->Front.starts)
  {
    const double offset = this->Front.labels[start.label].value;
    if (!this->Options.isExcluded(start.vertex))
      this->proposeDistance(start.vertex, { offset, start.label }, offset + start.length);
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
  // A side is queued by the distance to its third corner, and what lies behind it may be nearer
  // than that by an edge.
  const double behind = this->Mesh.longestEdgeLength();
  while (!this->Queue.isEmpty() &&
    this->First + this->Queue.keyOf(this->Queue.nextBucket()) <= this->Limit.value() + behind)
  {
    this->takeRound();
    if (!this->Control.mayGoOn(this->Field.reached().size(), this->Work.round.size()))
    {
      return false;
    }
    this->propagateRound();
    this->takeOver();
  }
  this->Field.noteRaisedGain(this->Control.raisedGain());
  for (const Index vertex : this->Field.reached())
  {
    this->Field.setNearestSeed(
      vertex, this->Front.labels[this->Work.vertices[vertex].origin.label].seed);
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
      const SourceStore::Side& at = this->Work.store.side(side);
      if (carriers.contains(at.third))
      {
        const SideFrame seen(
          this->Mesh.position(at.first), this->Mesh.position(at.second), label.position);
        if (seen.length > 0.0)
        {
          const VirtualSource source{ seen.x, -seen.height, label.value, 0.0, seen.length, 0.0,
            number };
          this->crossEdge(side, at.first, seen.length,
            { source, source.onSide(0.0), source.onSide(seen.length) });
        }
      }
    }
  }
}

/** Takes all items of the first bucket. */
void SourcePropagation::takeRound()
{
  this->Queue.hasBefore(this->Queue.nextBucket() + 1);
  this->Work.round.resize(this->Queue.sizeOfBucket());
  this->Queue.take(this->Work.round);
}

/** Asks the processor to fetch what lies behind the triangle of a side. */
GEODESIC_INLINED void SourcePropagation::prefetchBehind(Index side) const
{
  const Index second = EdgeTable::following(side);
  this->Work.store.prefetch(this->Work.edges.next(second));
  this->Work.store.prefetch(this->Work.edges.next(EdgeTable::following(second)));
  this->Work.store.prefetchNews(side);
}

/** Propagates all items of a round. What they read is fetched some items before. */
void SourcePropagation::propagateRound()
{
  constexpr std::size_t ahead = 3;
  const Index sides = 3 * this->Mesh.numberOfTriangles();
  const std::span<const Index> round = this->Work.round;
  for (std::size_t i = 0; i < round.size(); ++i)
  {
    if (i + 2 * ahead < round.size() && round[i + 2 * ahead] < sides)
    {
      this->Work.store.prefetch(round[i + 2 * ahead]);
    }
    if (i + ahead < round.size() && round[i + ahead] < sides)
    {
      this->prefetchBehind(round[i + ahead]);
    }
    round[i] < sides ? this->propagateSide(round[i]) : this->propagateVertex(round[i] - sides);
  }
}

void SourcePropagation::propagateVertex(Index vertex)
{
  VertexDistance& own = this->Work.vertices[vertex];
  own.isQueued = false;
  const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Index neighbour = ring[i].neighbour();
    const double most = this->Work.vertices[neighbour].value * (1.0 + EqualDistances) - own.value;
    const Vector3 edge = this->Mesh.position(neighbour) - this->Mesh.position(vertex);
    // Most neighbours are nearer by far, which is seen without a root.
    if (most >= 0.0 && dot(edge, edge) <= most * most && this->Closed.isOpenEdge(vertex, i) &&
      !this->Options.isExcluded(neighbour))
    {
      this->proposeDistance(neighbour, { own.value, own.origin.label }, own.value + norm(edge));
    }
  }
}

SourcePropagation::Exit::Exit(
  Index side, Index corner, const SideFrame& frame, double at, double turn)
  : side(side)
  , corner(corner)
  , at(at)
  , turn(turn)
  , length(lengthOf(frame.x - at, frame.height))
{
  const double perLength = 1.0 / this->length;
  this->upX = (frame.x - at) * perLength;
  this->upY = frame.height * perLength;
}

void SourcePropagation::propagateSide(Index side)
{
  const SourceStore::Side& at = this->Work.store.side(side);
  const Index second = EdgeTable::following(side);
  const Exit atFirst(EdgeTable::following(second), at.first, at.frame, 0.0, -1.0);
  const Exit atSecond(second, at.second, at.frame, at.frame.length, 1.0);
  this->Work.store.visitNews(side,
    [&](const VirtualSource& source) { this->propagate(at.frame, atFirst, atSecond, source); });
}

/** Hands a source on through the two other sides of the triangle behind a side: the source itself
 * where its straight lines reach them, and where they miss the third corner, a source at the corner
 * of the side that they pass if paths can turn there. */
inline void SourcePropagation::propagate(
  const SideFrame& frame, const Exit& atFirst, const Exit& atSecond, const VirtualSource& source)
{
  const double meets = source.crossing(frame.x, frame.height);
  // Where the line to the third corner grazes an end of the lit part, rounding would tell on which
  // side of that end it passes: it counts as lit then.
  const double grazing = Rounding * frame.length;
  const bool isBeforeLast = meets <= source.last + grazing;
  const bool isBehindFirst = meets >= source.first - grazing;
  const bool fromFirst = source.first == 0.0;
  const bool toSecond = source.last == frame.length;
  const double atCorner = source.onSide(source.first);
  const double atOther = source.onSide(source.last);
  if (meets > source.first)
  {
    this->shineThrough(atFirst, source,
      { fromFirst ? 0.0 : meeting(source, source.first, atFirst.at, frame),
        isBeforeLast ? 1.0 : meeting(source, source.last, atFirst.at, frame),
        fromFirst ? atCorner : -1.0, isBeforeLast ? source.toThird : -1.0 });
  }
  if (meets < source.last)
  {
    this->shineThrough(atSecond, source,
      { toSecond ? 0.0 : meeting(source, source.last, atSecond.at, frame),
        isBehindFirst ? 1.0 : meeting(source, source.first, atSecond.at, frame),
        toSecond ? atOther : -1.0, isBehindFirst ? source.toThird : -1.0 });
  }
  if (fromFirst && meets <= grazing && this->canTurn(atFirst.corner))
  {
    this->bendAt(frame, atFirst, atSecond, source, atCorner);
  }
  if (toSecond && meets >= frame.length - grazing && this->canTurn(atSecond.corner))
  {
    this->bendAt(frame, atSecond, atFirst, source, atOther);
  }
}

/** Hands on the source of lines that are bent at the corner of an exit. @param atCorner the
 * source's distance there */
void SourcePropagation::bendAt(const SideFrame& frame, const Exit& nearest, const Exit& other,
  const VirtualSource& source, double atCorner)
{
  const VertexDistance& corner = this->Work.vertices[nearest.corner];
  VirtualSource bent{ nearest.at, 0.0, atCorner, 0.0, 0.0, 0.0, source.label };
  if (corner.value < bent.offset)
  {
    bent.offset = corner.value;
    bent.label = corner.origin.label;
  }
  const double toThird = bent.offset + nearest.length;
  this->shineThrough(nearest, bent, { 0.0, 1.0, bent.offset, toThird });
  this->shineThrough(other, bent, { 0.0, 1.0, bent.offset + frame.length, toThird });
}

/** Proposes a source to the triangles behind an exit. @param source in the frame of the side that
 * it came through */
void SourcePropagation::shineThrough(
  const Exit& exit, const VirtualSource& source, const Light& light)
{
  if (!(exit.length > 0.0))
  {
    return;
  }
  const double fromX = source.x - exit.at;
  const double depth = exit.turn * (source.y * exit.upX - fromX * exit.upY);
  const VirtualSource through{ fromX * exit.upX + source.y * exit.upY, -std::max(0.0, depth),
    source.offset, light.from * exit.length, light.to * exit.length, 0.0, source.label };
  this->crossEdge(exit.side, exit.corner, exit.length,
    { through, light.atFrom >= 0.0 ? light.atFrom : through.onSide(through.first),
      light.atTo >= 0.0 ? light.atTo : through.onSide(through.last) });
}

/** Proposes a source to the triangles on the other side of an edge. @param lit in the frame whose x
 * axis goes along the edge from @p corner */
GEODESIC_INLINED void SourcePropagation::crossEdge(
  Index side, Index corner, double length, const LitSource& lit)
{
  for (Index other = this->Work.edges.next(side); other != side;
       other = this->Work.edges.next(other))
  {
    if (!this->Passable.contains(EdgeTable::triangleOf(other)))
    {
      continue;
    }
    const bool isSame = this->Work.store.side(other).first == corner;
    const VirtualSource& source = lit.source;
    this->proposeSource(other,
      { { isSame ? source.x : length - source.x, source.y, source.offset,
          isSame ? source.first : length - source.last,
          isSame ? source.last : length - source.first, 0.0, source.label },
        isSame ? lit.atFirst : lit.atLast, isSame ? lit.atLast : lit.atFirst });
  }
}

GEODESIC_INLINED void SourcePropagation::proposeSource(Index side, LitSource lit)
{
  const SourceStore::Side& at = this->Work.store.side(side);
  const SideFrame& frame = at.frame;
  VirtualSource& source = lit.source;
  source.snap(frame.length, Rounding * frame.length);
  this->fit(lit, frame, this->Work.vertices[at.first], this->Work.vertices[at.second]);
  if (this->isBehindCorners(at, lit))
  {
    return;
  }
  // The path to the third corner is straight, or bent at an end of the lit part.
  const double grazing = Rounding * frame.length;
  const double meets = source.crossing(frame.x, frame.height);
  const bool isBefore = meets < source.first - grazing;
  const bool isBehind = meets > source.last + grazing;
  DistanceOrigin origin{ source.offset, source.label };
  if (isBefore || isBehind)
  {
    origin.offset = isBefore ? lit.atFirst : lit.atLast;
    source.toThird =
      origin.offset + lengthOf(frame.x - (isBefore ? source.first : source.last), frame.height);
  }
  else
  {
    source.toThird = source.offset + lengthOf(frame.x - source.x, frame.height - source.y);
  }
  this->proposeDistance(at.third, origin, source.toThird);
  // A source at a corner is of use only where lines bend round that corner.
  if (source.y == 0.0 && (source.x == 0.0 || source.x == frame.length) &&
    source.toThird > this->Work.vertices[at.third].value * (1.0 + Rounding))
  {
    return;
  }
  const SeenSource seen{ source,
    { source.toThird, lit.atFirst + source.first, lit.atLast + (frame.length - source.last) } };
  if (this->Work.store.isWorthwhile(at, seen))
  {
    this->Work.sources.push_back({ side, seen });
  }
}

/** Moves a source to the distances at its side's corners that come from the same place. */
GEODESIC_INLINED void SourcePropagation::fit(LitSource& lit, const SideFrame& frame,
  const VertexDistance& first, const VertexDistance& second) const
{
  VirtualSource& source = lit.source;
  const bool isFromFirst = this->isFrom(source, first);
  const bool isFromSecond = this->isFrom(source, second);
  if (!isFromFirst && !isFromSecond)
  {
    return;
  }
  constexpr double none = DistanceField::Unreached;
  const double length = frame.length;
  const double ownFirst =
    source.first == 0.0 ? lit.atFirst - source.offset : lengthOf(source.x, source.y);
  const double ownSecond =
    source.last == length ? lit.atLast - source.offset : lengthOf(length - source.x, source.y);
  if (source.fit(length, ownFirst, ownSecond, isFromFirst ? first.value - source.offset : none,
        isFromSecond ? second.value - source.offset : none, MostMoved))
  {
    lit.atFirst = source.onSide(source.first);
    lit.atLast = source.onSide(source.last);
  }
}

/**
 * Whether paths by way of a corner, by its present distance, are no longer than those of a source
 * to anything behind the side. S.-Q. Xin, G.-J. Wang, Improving Chen and Han's algorithm on the
 * discrete geodesic problem, ACM Trans. Graph. 28 (2009).
 */
GEODESIC_INLINED bool SourcePropagation::isBehindCorners(
  const SourceStore::Side& at, const LitSource& lit) const
{
  constexpr double least = 1.0 - Rounding;
  const SideFrame& frame = at.frame;
  const VirtualSource& source = lit.source;
  const double atFirst = this->Work.vertices[at.first].value;
  const double atSecond = this->Work.vertices[at.second].value;
  const double atThird = this->Work.vertices[at.third].value;
  const bool isAtFirst = source.x == 0.0 && source.y == 0.0;
  const bool isAtSecond = source.x == frame.length && source.y == 0.0;
  if ((!isAtFirst && lit.atLast > (atFirst + source.last) * least) ||
    (!isAtSecond && lit.atFirst > (atSecond + frame.length - source.first) * least))
  {
    return true;
  }
  const auto fromThird = [&](double place)
  { return atThird + lengthOf(frame.x - place, frame.height); };
  return atThird < std::min(lit.atFirst, lit.atLast) &&
    lit.atFirst > fromThird(source.first) * least && lit.atLast > fromThird(source.last) * least;
}

void SourcePropagation::proposeDistance(Index vertex, const DistanceOrigin& origin, double value)
{
  // Most are no news, so it is worth while to look before they are stored.
  const VertexDistance& old = this->Work.vertices[vertex];
  if (value < old.value * this->Control.keptFraction() ||
    (value <= old.value * (1.0 + EqualDistances) && isBefore(origin, old.origin)))
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
  constexpr std::size_t ahead = 4;
  const std::span<const ProposedSource> sources = this->Work.sources;
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    if (i + ahead < sources.size())
    {
      this->Work.store.prefetch(sources[i + ahead].side);
    }
    if (this->Work.store.offer(sources[i].side, sources[i].seen))
    {
      this->Work.sidesWithNews.push_back(sources[i].side);
    }
  }
  this->Work.distances.clear();
  this->Work.sources.clear();
  for (const Index side : this->Work.sidesWithNews)
  {
    this->push(side, this->Work.store.side(side).distances[0]);
  }
  for (const Index vertex : this->Work.loweredVertices)
  {
    this->push(3 * this->Mesh.numberOfTriangles() + vertex, this->Work.vertices[vertex].value);
  }
  this->Work.sidesWithNews.clear();
  this->Work.loweredVertices.clear();
}

/** Of equal distances that of the smallest seed is kept, as in fast marching, and of these the one
 * whose path bends first. */
void SourcePropagation::lower(const ProposedDistance& proposed)
{
  VertexDistance& vertex = this->Work.vertices[proposed.vertex];
  const double old = vertex.value;
  const bool isEqual = proposed.value >= old * (1.0 - EqualDistances) &&
    proposed.value <= old * (1.0 + EqualDistances);
  if (!isEqual ? proposed.value < old : isBefore(proposed.origin, vertex.origin))
  {
    vertex.origin = proposed.origin;
  }
  if (proposed.value < old * this->Control.keptFraction())
  {
    if (old == DistanceField::Unreached)
    {
      this->Work.reached.push_back(proposed.vertex);
    }
    vertex.value = proposed.value;
    this->Field.setDistance(proposed.vertex, proposed.value);
    if (!vertex.isQueued)
    {
      vertex.isQueued = true;
      this->Work.loweredVertices.push_back(proposed.vertex);
    }
  }
}

void SourcePropagation::push(Index item, double distance)
{
  this->Queue.push(item, distance - this->First);
}

/** Whether a shortest path can turn at a vertex. */
bool SourcePropagation::canTurn(Index vertex) const
{
  return this->Work.edges.canTurn(vertex) ||
    (!this->BesideBarrier.empty() && this->BesideBarrier[vertex]);
}

/** Whether the distance of a vertex comes from the same place as that of a source. */
bool SourcePropagation::isFrom(const VirtualSource& source, const VertexDistance& vertex) const
{
  return vertex.origin.label == source.label &&
    std::abs(vertex.origin.offset - source.offset) <= Rounding * vertex.value;
}

}
