// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/PathStraightener.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace geodesic
{
namespace
{

/** A path counts as shorter if it is so by more than this part of its length; less is rounding. */
constexpr double LeastShortening = 1e-14;

/** Most paths are straight before this round. On curved surfaces without saddles others come past
 * one vertex after the other, all along, where the faces along a chord are the right ones at once.
 */
constexpr int FirstRoundOfChords = 3;

/** A row of so many faces gets room for the rest of the path at once: what grows by doubling is
 * copied, and fresh memory is slow. */
constexpr std::size_t LongRow = 4096;

bool isShorter(double newLength, double length)
{
  return newLength < length * (1.0 - LeastShortening);
}

/** Whether two points are the ends of an edge. */
bool isEdge(const PathPoint& a, const PathPoint& b)
{
  return isVertex(a) && isVertex(b) && !isSameVertex(a, b);
}

/** Whether a path passes a vertex at its point @p i. */
bool passesVertex(const SurfacePath& path, std::size_t i)
{
  return isVertex(path[i]) && !isSameVertex(path[i - 1], path[i]) &&
    !isSameVertex(path[i], path[i + 1]);
}

}

SurfacePath PathStraightener::straightened(SurfacePath path)
{
  if (path.size() < 2)
  {
    return path;
  }
  Pieces pieces = this->tautPieces(path);
  Places joints;
  for (Place place = pieces.begin(); place != pieces.end(); ++place)
  {
    joints.push_back(place);
  }
  for (this->Round = 1; !joints.empty(); ++this->Round)
  {
    joints = this->ledRound(pieces, joints);
  }

  const PathPoint start = path.front();
  // Fresh memory is slow where a path is long.
  SurfacePath straight = std::move(path);
  straight.clear();
  straight.reserve(std::accumulate(pieces.begin(), pieces.end(), std::size_t{ 1 },
    [](std::size_t size, const JoinedPiece& joined)
    { return size + std::max<std::size_t>(joined.piece.strip.size(), 1); }));
  straight.push_back(start);
  const auto append = [&](const PathPoint& point)
  {
    if (!isSameVertex(straight.back(), point))
    {
      straight.push_back(point);
    }
  };
  for (const auto& [piece, joint, turn] : pieces)
  {
    this->Surface.countSteps(piece.strip.size() + 1);
    for (const Index vertex : piece.through)
    {
      append(PathPoint::atVertex(vertex));
    }
    for (std::size_t i = 1; i < piece.strip.size() && piece.through.empty(); ++i)
    {
      append(piece.crossing(piece.strip[i]));
    }
    append(piece.end);
  }
  return straight;
}

PathStraightener::Pieces PathStraightener::tautPieces(const SurfacePath& path)
{
  Pieces pieces;
  Row row{ path.front() };
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    this->Surface.countSteps(1);
    const bool alongEdge = isEdge(path[i - 1], path[i]);
    if (alongEdge)
    {
      row.length +=
        norm(path[i].position(this->Surface.mesh()) - path[i - 1].position(this->Surface.mesh()));
    }
    else
    {
      appendFace(
        this->Surface.mesh(), row.strip, faceOf(this->Surface.mesh(), path[i - 1], path[i]));
      if (row.strip.size() == LongRow)
      {
        row.strip.reserve(LongRow + path.size() - i);
      }
    }
    row.isOfEdges = row.isOfEdges && alongEdge;
    const bool isLast = i + 1 == path.size();
    if (!isLast && !isVertex(path[i]))
    {
      continue;
    }
    const bool isTold = !isLast && passesVertex(path, i);
    if (isTold && this->leadRound(row, path[i - 1], path[i], path[i + 1]))
    {
      continue;
    }
    // Between edges that stay as they are, the same will be told again.
    const bool stays = isTold && row.isStraight() && isEdge(path[i], path[i + 1]);
    this->addRow(pieces, row, path[i]);
    if (!pieces.empty())
    {
      pieces.back().joint = stays ? Joint::Stays : Joint::Unknown;
    }
    row = Row{ path[i] };
  }
  return pieces;
}

bool PathStraightener::Row::isStraight() const
{
  // What bends by so much is longer by an eighth of the square: less than LeastShortening.
  constexpr double leastBend = 1e-7;
  return this->isOfEdges && this->bend <= leastBend;
}

bool PathStraightener::leadRound(
  Row& row, const PathPoint& from, const PathPoint& through, const PathPoint& to)
{
  const Index vertex = vertexOf(through);
  this->Turn.clear();
  const std::optional<double> angle = this->Link.appendShorterSide(vertex, from, to, this->Turn);
  if (!angle)
  {
    return false;
  }
  row.bend += std::abs(*angle - std::numbers::pi);
  row.through.push_back(vertex);
  for (const Triangle& face : this->Turn)
  {
    appendFace(this->Surface.mesh(), row.strip, face);
  }
  return true;
}

void PathStraightener::addRow(Pieces& pieces, Row& row, const PathPoint& end) const
{
  if (row.isStraight())
  {
    pieces.push_back(
      { { row.start, end, std::move(row.strip), row.length, {}, {}, std::move(row.through) } });
    return;
  }
  if (!pieces.empty())
  {
    pieces.back().joint = Joint::Unknown;
  }
  this->provideFace(row.strip, row.start, end);
  const StripFunnel funnel(this->Surface, row.start, end, row.strip);
  for (StraightPiece& piece : funnel.takePieces(std::move(row.strip)))
  {
    pieces.push_back({ std::move(piece) });
  }
}

PathStraightener::Places PathStraightener::ledRound(Pieces& pieces, const Places& joints)
{
  Places open;
  // Places in both lists of joints stay valid.
  Pieces replaced;
  for (const Place joint : joints)
  {
    if (joint->joint != Joint::Unknown || !this->turns(pieces, joint))
    {
      continue;
    }
    Place first = joint;
    while (first != pieces.begin() && this->turns(pieces, std::prev(first)))
    {
      --first;
    }
    Place last = std::next(joint);
    while (this->turns(pieces, last))
    {
      ++last;
    }
    const Place end = std::next(last);
    double length = 0.0;
    std::for_each(first, end, [&](const JoinedPiece& joined) { length += joined.piece.length; });
    std::optional<std::vector<StraightPiece>> shorter = this->shorterPieces(
      this->stripRound(first, last), first->piece.start, last->piece.end, length);
    if (!shorter)
    {
      continue;
    }
    if (first != pieces.begin())
    {
      open.push_back(std::prev(first));
    }
    for (StraightPiece& piece : *shorter)
    {
      open.push_back(pieces.insert(first, { std::move(piece), Joint::Stays }));
    }
    std::for_each(first, end, [](JoinedPiece& joined) { joined.joint = Joint::Gone; });
    replaced.splice(replaced.end(), pieces, first, end);
  }
  std::erase_if(open, [](const Place place) { return place->joint == Joint::Gone; });
  for (const Place place : open)
  {
    place->joint = Joint::Unknown;
  }
  return open;
}

std::optional<std::vector<StraightPiece>> PathStraightener::shorterPieces(
  Strip strip, const PathPoint& start, const PathPoint& end, double length)
{
  std::optional<std::vector<StraightPiece>> pieces;
  std::optional<Strip> next = std::move(strip);
  while (next)
  {
    strip = std::move(*next);
    const StripFunnel funnel(this->Surface, start, end, strip);
    if (!isShorter(funnel.length(), length))
    {
      break;
    }
    length = funnel.length();
    pieces = funnel.pieces();
    next = this->Round >= FirstRoundOfChords && this->doAllTurn(*pieces) ? funnel.stripAlongChord()
                                                                         : std::nullopt;
  }
  return pieces;
}

bool PathStraightener::doAllTurn(std::span<const StraightPiece> pieces)
{
  bool doTurn = true;
  for (std::size_t i = 1; i < pieces.size() && doTurn; ++i)
  {
    this->Turn.clear();
    const StraightPiece& before = pieces[i - 1];
    doTurn = this->Link
               .appendShorterSide(
                 vertexOf(before.end), before.lastButOne(), pieces[i].second(), this->Turn)
               .has_value();
  }
  return doTurn;
}

bool PathStraightener::turns(Pieces& pieces, const Place place)
{
  if (place->joint == Joint::Unknown)
  {
    const Place next = std::next(place);
    const bool doesTurn = next != pieces.end() &&
      this->Link
        .appendShorterSide(
          vertexOf(place->piece.end), place->piece.lastButOne(), next->piece.second(), place->turn)
        .has_value();
    place->joint = doesTurn ? Joint::Turns : Joint::Stays;
  }
  return place->joint == Joint::Turns;
}

Strip PathStraightener::stripRound(Place first, Place last) const
{
  Strip strip;
  const Place end = std::next(last);
  strip.reserve(std::accumulate(first, end, std::size_t{ 0 },
    [](std::size_t size, const JoinedPiece& joined)
    { return size + joined.piece.strip.size() + joined.turn.size(); }));
  for (Place place = first; place != last; ++place)
  {
    appendStrip(this->Surface.mesh(), strip, place->piece.strip);
    for (const Triangle& face : place->turn)
    {
      appendFace(this->Surface.mesh(), strip, face);
    }
  }
  appendStrip(this->Surface.mesh(), strip, last->piece.strip);
  this->provideFace(strip, first->piece.start, last->piece.end);
  return strip;
}

void PathStraightener::provideFace(Strip& strip, const PathPoint& start, const PathPoint& end) const
{
  if (strip.empty())
  {
    appendFace(this->Surface.mesh(), strip, faceOf(this->Surface.mesh(), start, end));
  }
}

}
