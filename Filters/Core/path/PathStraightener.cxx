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
constexpr double LeastGain = 1e-14;

/** A path that bends by less than this in all, in radians, is no longer than the straight one by
 * more than LeastGain: it is so by less than an eighth of the square. */
constexpr double LeastBend = 1e-7;

bool isShorter(double newLength, double length)
{
  return newLength < length * (1.0 - LeastGain);
}

Index vertexAt(const PathPoint& point)
{
  return point.carriers()[0];
}

/** Whether a path goes along an edge from its point @p i to the next one. */
bool isEdge(const SurfacePath& path, std::size_t i)
{
  return i + 1 < path.size() && isVertex(path[i]) && isVertex(path[i + 1]) &&
    vertexAt(path[i]) != vertexAt(path[i + 1]);
}

}

SurfacePath PathStraightener::straightened(const SurfacePath& path)
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
  while (!joints.empty())
  {
    joints = this->ledRound(pieces, joints);
  }

  SurfacePath straight;
  straight.reserve(std::accumulate(pieces.begin(), pieces.end(), std::size_t{ 1 },
    [](std::size_t size, const JoinedPiece& joined)
    { return size + std::max<std::size_t>(joined.piece.strip.size(), 1); }));
  straight.push_back(path.front());
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
    for (std::size_t i = 1; i < piece.strip.size(); ++i)
    {
      append(piece.strip[i].crossingPoint());
    }
    append(piece.end);
  }
  return straight;
}

PathStraightener::Pieces PathStraightener::tautPieces(const SurfacePath& path)
{
  Pieces pieces;
  Strip strip;
  std::size_t first = 0;
  std::size_t i = 1;
  while (i < path.size())
  {
    this->Surface.countSteps(1);
    if (first + 1 == i && isEdge(path, first))
    {
      first = this->addEdges(pieces, path, first);
      i = first + 1;
      continue;
    }
    appendFace(strip, faceOf(this->Surface.mesh(), path[i - 1], path[i]));
    if (i + 1 == path.size() || isVertex(path[i]))
    {
      for (StraightPiece& piece : StripFunnel(this->Surface, path[first], path[i], strip).pieces())
      {
        pieces.push_back({ std::move(piece) });
      }
      strip.clear();
      first = i;
    }
    ++i;
  }
  return pieces;
}

std::size_t PathStraightener::addEdges(Pieces& pieces, const SurfacePath& path, std::size_t first)
{
  const TriangleMesh& mesh = this->Surface.mesh();
  Strip strip;
  double length = 0.0;
  // Of all angles between the edges, how much less or more they are than 180 degrees.
  double bend = 0.0;
  std::size_t last = first;
  bool turns = true;
  while (turns)
  {
    const Index vertex = vertexAt(path[last + 1]);
    length += norm(mesh.position(vertex) - mesh.position(vertexAt(path[last])));
    ++last;
    this->Turn.clear();
    const std::optional<double> angle = isEdge(path, last)
      ? this->Link.appendShorterSide(vertex, path[last - 1], path[last + 1], this->Turn)
      : std::nullopt;
    turns = angle.has_value();
    bend += std::abs(angle.value_or(std::numbers::pi) - std::numbers::pi);
    for (const Triangle& face : this->Turn)
    {
      appendFace(strip, face);
      if (strip.back().left == vertex || strip.back().right == vertex)
      {
        strip.back().crossing = strip.back().left == vertex ? 0.0 : 1.0;
      }
    }
  }
  const PathPoint& start = path[first];
  const PathPoint& end = path[last];
  if (bend > LeastBend)
  {
    this->provideFace(strip, start, end);
    const StripFunnel funnel(this->Surface, start, end, strip);
    if (isShorter(funnel.length(), length))
    {
      if (!pieces.empty())
      {
        pieces.back().joint = Joint::Unknown;
      }
      for (StraightPiece& piece : funnel.pieces())
      {
        pieces.push_back({ std::move(piece) });
      }
      return last;
    }
  }
  // Through the vertices, as the path was.
  pieces.push_back({ { start, end, std::move(strip), length } });
  pieces.back().joint = isEdge(path, last) ? Joint::Stays : Joint::Unknown;
  return last;
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
    const Strip strip = this->stripRound(first, last);
    const StripFunnel shorter(this->Surface, first->piece.start, last->piece.end, strip);
    if (!isShorter(shorter.length(), length))
    {
      continue;
    }
    if (first != pieces.begin())
    {
      open.push_back(std::prev(first));
    }
    for (StraightPiece& piece : shorter.pieces())
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

bool PathStraightener::turns(Pieces& pieces, const Place place)
{
  if (place->joint == Joint::Unknown)
  {
    const Place next = std::next(place);
    const bool doesTurn = next != pieces.end() &&
      this->Link
        .appendShorterSide(
          vertexAt(place->piece.end), place->piece.lastButOne(), next->piece.second(), place->turn)
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
    appendStrip(strip, place->piece.strip);
    for (const Triangle& face : place->turn)
    {
      appendFace(strip, face);
    }
  }
  appendStrip(strip, last->piece.strip);
  this->provideFace(strip, first->piece.start, last->piece.end);
  return strip;
}

void PathStraightener::provideFace(Strip& strip, const PathPoint& start, const PathPoint& end) const
{
  if (strip.empty())
  {
    appendFace(strip, faceOf(this->Surface.mesh(), start, end));
  }
}

}
