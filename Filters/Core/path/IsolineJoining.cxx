// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/IsolineJoining.h"

#include <algorithm>

namespace geodesic
{
namespace
{

/** An end of a piece. */
struct End
{
  LevelPiece::Node node;
  Index piece;
  int side;

  auto operator<=>(const End&) const = default;
};

/** A piece, NoIndex for none, and one of its ends. */
using EndOfPiece = std::pair<Index, int>;

/** For each end of each piece the end that follows on it, if there is just one. */
std::vector<std::array<EndOfPiece, 2>> followersOf(std::span<const LevelPiece> pieces)
{
  std::vector<End> ends;
  for (Index piece = 0; piece < pieces.size(); ++piece)
  {
    ends.push_back({ pieces[piece].ends[0], piece, 0 });
    ends.push_back({ pieces[piece].ends[1], piece, 1 });
  }
  std::sort(ends.begin(), ends.end());
  std::vector<std::array<EndOfPiece, 2>> next(
    pieces.size(), { EndOfPiece{ NoIndex, 0 }, EndOfPiece{ NoIndex, 0 } });
  for (std::size_t i = 0; i < ends.size();)
  {
    std::size_t last = i;
    while (last < ends.size() && ends[last].node == ends[i].node)
    {
      ++last;
    }
    if (last - i == 2)
    {
      next[ends[i].piece][ends[i].side] = { ends[i + 1].piece, ends[i + 1].side };
      next[ends[i + 1].piece][ends[i + 1].side] = { ends[i].piece, ends[i].side };
    }
    i = last;
  }
  return next;
}

void append(const LevelPiece& piece, bool isReversed, Isoline& line)
{
  line.length += piece.length;
  const auto add = [&](const Vector3& point)
  {
    // By rounding the faces of an edge have a crossing at places that differ in the last digits.
    const bool isRepeated = !line.points.empty() &&
      norm(point - line.points.back()) <= 1e-12 * (norm(point) + piece.length);
    if (!isRepeated)
    {
      line.points.push_back(point);
    }
  };
  if (isReversed)
  {
    std::for_each(piece.points.rbegin(), piece.points.rend(), add);
  }
  else
  {
    std::for_each(piece.points.begin(), piece.points.end(), add);
  }
}

}

void joinPieces(double level, std::span<const LevelPiece> pieces, std::span<const double> areas,
  std::vector<Isoline>& isolines)
{
  const std::vector<std::array<EndOfPiece, 2>> next = followersOf(pieces);
  std::vector<bool> isDone(pieces.size(), false);
  // Open curves first, each from an end.
  for (const bool mustBeOpen : { true, false })
  {
    for (Index piece = 0; piece < pieces.size(); ++piece)
    {
      for (int side = 0; side < 2 && !isDone[piece]; ++side)
      {
        if (mustBeOpen && next[piece][side].first != NoIndex)
        {
          continue;
        }
        Isoline line{ level, {}, 0.0, areas[piece] };
        EndOfPiece at{ piece, side };
        while (at.first != NoIndex && !isDone[at.first])
        {
          isDone[at.first] = true;
          append(pieces[at.first], at.second == 1, line);
          at = next[at.first][1 - at.second];
        }
        if (line.length > 0.0)
        {
          if (!mustBeOpen)
          {
            line.points.back() = line.points.front();
          }
          isolines.push_back(std::move(line));
        }
      }
    }
  }
}

}
