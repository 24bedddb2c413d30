// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/PathStraightener.h"

#include "path/VertexLink.h"

#include <iterator>

namespace geodesic
{
namespace
{

/** A path counts as shorter if it is so by more than this part of its length; less is rounding. */
constexpr double LeastGain = 1e-14;

double lengthOf(const std::vector<StraightPiece>& pieces)
{
  double length = 0.0;
  for (const StraightPiece& piece : pieces)
  {
    length += piece.length;
  }
  return length;
}

/** Whether the piece runs along one edge, or a part of it, and crosses no face. */
bool isAlongEdge(const StraightPiece& piece)
{
  return piece.faces.size() == 1 && unionOf(piece.start, piece.end).size() <= 2;
}

}

SurfacePath PathStraightener::straightened(const SurfacePath& path) const
{
  if (path.size() < 2)
  {
    return path;
  }
  std::vector<StraightPiece> todo = this->tautPieces(path);
  std::reverse(todo.begin(), todo.end());
  // Where the pieces in `done` join, leading the path round the vertex does not shorten it.
  std::vector<StraightPiece> done;
  while (!todo.empty())
  {
    if (!done.empty())
    {
      if (auto shorter = this->ledRound(done.back(), todo.back()))
      {
        done.pop_back();
        todo.pop_back();
        todo.insert(todo.end(), std::make_move_iterator(shorter->rbegin()),
          std::make_move_iterator(shorter->rend()));
        continue;
      }
    }
    done.push_back(std::move(todo.back()));
    todo.pop_back();
  }

  SurfacePath straight{ path.front() };
  const auto append = [&](const PathPoint& point)
  {
    if (!isSameVertex(straight.back(), point))
    {
      straight.push_back(point);
    }
  };
  for (const StraightPiece& piece : done)
  {
    std::for_each(piece.crossings.begin(), piece.crossings.end(), append);
    append(piece.end);
  }
  return straight;
}

std::vector<StraightPiece> PathStraightener::tautPieces(const SurfacePath& path) const
{
  std::vector<StraightPiece> pieces;
  std::vector<Triangle> faces;
  std::size_t first = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    appendFace(faces, faceOf(this->Surface.mesh(), path[i - 1], path[i]));
    if (i + 1 == path.size() || isVertex(path[i]))
    {
      auto taut = shortestInStrip(this->Surface.mesh(), path[first], path[i], faces);
      std::move(taut.begin(), taut.end(), std::back_inserter(pieces));
      faces.clear();
      first = i;
    }
  }
  return pieces;
}

std::optional<std::vector<StraightPiece>> PathStraightener::ledRound(
  const StraightPiece& piece, const StraightPiece& next) const
{
  const VertexLink link(this->Surface, piece.end.carriers()[0]);
  const auto turn = link.shorterSide(piece.lastButOne(), next.second());
  if (!turn)
  {
    return std::nullopt;
  }
  std::vector<Triangle> faces;
  if (!isAlongEdge(piece))
  {
    faces = piece.faces;
  }
  for (const Triangle& face : *turn)
  {
    appendFace(faces, face);
  }
  if (!isAlongEdge(next))
  {
    for (const Triangle& face : next.faces)
    {
      appendFace(faces, face);
    }
  }
  if (faces.empty())
  {
    faces.push_back(faceOf(this->Surface.mesh(), piece.start, next.end));
  }
  auto shorter = shortestInStrip(this->Surface.mesh(), piece.start, next.end, faces);
  if (!(lengthOf(shorter) < (piece.length + next.length) * (1.0 - LeastGain)))
  {
    return std::nullopt;
  }
  return shorter;
}

}
