// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/PathStraightener.h"

#include "path/VertexLink.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace geodesic
{
namespace
{

/** A path counts as shorter if it is so by more than this part of its length; less is rounding. */
constexpr double LeastGain = 1e-14;

}

SurfacePath PathStraightener::straightened(const SurfacePath& path) const
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

  SurfacePath straight{ path.front() };
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

PathStraightener::Pieces PathStraightener::tautPieces(const SurfacePath& path) const
{
  Pieces pieces;
  Strip strip;
  std::size_t first = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    this->Surface.countSteps(1);
    appendFace(strip, faceOf(this->Surface.mesh(), path[i - 1], path[i]));
    if (i + 1 == path.size() || isVertex(path[i]))
    {
      for (StraightPiece& piece : shortestInStrip(this->Surface, path[first], path[i], strip))
      {
        pieces.push_back({ std::move(piece) });
      }
      strip.clear();
      first = i;
    }
  }
  return pieces;
}

PathStraightener::Places PathStraightener::ledRound(Pieces& pieces, const Places& joints) const
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
    std::vector<StraightPiece> shorter = this->shortestRound(first, last);
    double newLength = 0.0;
    for (const StraightPiece& piece : shorter)
    {
      newLength += piece.length;
    }
    if (!(newLength < length * (1.0 - LeastGain)))
    {
      continue;
    }
    if (first != pieces.begin())
    {
      open.push_back(std::prev(first));
    }
    for (StraightPiece& piece : shorter)
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

bool PathStraightener::turns(Pieces& pieces, const Place place) const
{
  if (place->joint == Joint::Unknown)
  {
    place->joint = Joint::Stays;
    const Place next = std::next(place);
    if (next != pieces.end())
    {
      auto turn = VertexLink(this->Surface, place->piece.end.carriers()[0])
                    .shorterSide(place->piece.lastButOne(), next->piece.second());
      if (turn)
      {
        place->joint = Joint::Turns;
        place->turn = std::move(*turn);
      }
    }
  }
  return place->joint == Joint::Turns;
}

std::vector<StraightPiece> PathStraightener::shortestRound(Place first, Place last) const
{
  Strip strip;
  for (Place place = first; place != last; ++place)
  {
    appendStrip(strip, place->piece.strip);
    for (const Triangle& face : place->turn)
    {
      appendFace(strip, face);
    }
  }
  appendStrip(strip, last->piece.strip);
  const PathPoint& start = first->piece.start;
  const PathPoint& end = last->piece.end;
  if (strip.empty())
  {
    appendFace(strip, faceOf(this->Surface.mesh(), start, end));
  }
  return shortestInStrip(this->Surface, start, end, strip);
}

}
