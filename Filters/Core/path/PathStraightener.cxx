// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/PathStraightener.h"

#include <iterator>

namespace geodesic
{
namespace
{

/** How many faces are laid flat before a path is led round all its vertices at once: what takes
 * about a tenth of a second. */
constexpr std::size_t MostFacesOneByOne = 1'000'000;

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

std::size_t facesOf(const StraightPiece& piece)
{
  return piece.faces.size();
}

/** Appends the faces that a piece crosses: none if it runs along one edge, or a part of it. */
void appendFaces(std::vector<Triangle>& faces, const StraightPiece& piece)
{
  if (piece.faces.size() == 1 && unionOf(piece.start, piece.end).size() <= 2)
  {
    return;
  }
  for (const Triangle& face : piece.faces)
  {
    appendFace(faces, face);
  }
}

void append(std::vector<StraightPiece>& pieces, std::vector<StraightPiece> others)
{
  std::move(others.begin(), others.end(), std::back_inserter(pieces));
}

}

SurfacePath PathStraightener::straightened(const SurfacePath& path) const
{
  if (path.size() < 2)
  {
    return path;
  }
  auto [pieces, isStraight] = this->ledRoundOneByOne(this->tautPieces(path));
  if (!isStraight)
  {
    pieces = this->ledRoundTogether(std::move(pieces));
  }

  SurfacePath straight{ path.front() };
  const auto append = [&](const PathPoint& point)
  {
    this->Surface.countSteps(1);
    if (!isSameVertex(straight.back(), point))
    {
      straight.push_back(point);
    }
  };
  for (const StraightPiece& piece : pieces)
  {
    std::for_each(piece.crossings.begin(), piece.crossings.end(), append);
    append(piece.end);
  }
  return straight;
}

PathStraightener::Pieces PathStraightener::tautPieces(const SurfacePath& path) const
{
  Pieces pieces;
  std::vector<Triangle> faces;
  std::size_t first = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    this->Surface.countSteps(1);
    appendFace(faces, faceOf(this->Surface.mesh(), path[i - 1], path[i]));
    if (i + 1 == path.size() || isVertex(path[i]))
    {
      append(pieces, shortestInStrip(this->Surface, path[first], path[i], faces));
      faces.clear();
      first = i;
    }
  }
  return pieces;
}

std::pair<PathStraightener::Pieces, bool> PathStraightener::ledRoundOneByOne(Pieces pieces) const
{
  std::size_t work = 0;
  Pieces todo = std::move(pieces);
  std::reverse(todo.begin(), todo.end());
  // Where the pieces in `done` join, leading the path round the vertex does not shorten it.
  Pieces done;
  while (!todo.empty() && work < MostFacesOneByOne)
  {
    if (!done.empty())
    {
      if (auto shorter = this->ledRound(done.back(), todo.back()))
      {
        work += facesOf(done.back()) + facesOf(todo.back());
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
  const bool isStraight = todo.empty();
  std::reverse(todo.begin(), todo.end());
  append(done, std::move(todo));
  return { std::move(done), isStraight };
}

PathStraightener::Pieces PathStraightener::ledRoundTogether(Pieces pieces) const
{
  while (true)
  {
    Pieces shorter;
    std::vector<Triangle> faces;
    std::size_t first = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      appendFaces(faces, pieces[i]);
      const auto turn = i + 1 < pieces.size()
        ? this->turnBetween(pieces[i], pieces[i + 1], VertexLink::Bend::OrStraight)
        : std::nullopt;
      if (turn)
      {
        std::for_each(
          turn->begin(), turn->end(), [&](const Triangle& face) { appendFace(faces, face); });
        continue;
      }
      if (i == first)
      {
        shorter.push_back(std::move(pieces[i]));
      }
      else
      {
        append(shorter, this->shortestOf(pieces[first].start, pieces[i].end, std::move(faces)));
      }
      faces.clear();
      first = i + 1;
    }
    const bool isShorter = lengthOf(shorter) < lengthOf(pieces) * (1.0 - LeastGain);
    pieces = std::move(shorter);
    if (!isShorter)
    {
      return pieces;
    }
  }
}

PathStraightener::Pieces PathStraightener::shortestOf(
  const PathPoint& start, const PathPoint& end, std::vector<Triangle> faces) const
{
  if (faces.empty())
  {
    faces.push_back(faceOf(this->Surface.mesh(), start, end));
  }
  return shortestInStrip(this->Surface, start, end, faces);
}

std::optional<std::vector<Triangle>> PathStraightener::turnBetween(
  const StraightPiece& piece, const StraightPiece& next, VertexLink::Bend bend) const
{
  return VertexLink(this->Surface, piece.end.carriers()[0])
    .shorterSide(piece.lastButOne(), next.second(), bend);
}

std::optional<PathStraightener::Pieces> PathStraightener::ledRound(
  const StraightPiece& piece, const StraightPiece& next) const
{
  const auto turn = this->turnBetween(piece, next, VertexLink::Bend::Real);
  if (!turn)
  {
    return std::nullopt;
  }
  std::vector<Triangle> faces;
  appendFaces(faces, piece);
  for (const Triangle& face : *turn)
  {
    appendFace(faces, face);
  }
  appendFaces(faces, next);
  auto shorter = this->shortestOf(piece.start, next.end, std::move(faces));
  if (!(lengthOf(shorter) < (piece.length + next.length) * (1.0 - LeastGain)))
  {
    return std::nullopt;
  }
  return shorter;
}

}
