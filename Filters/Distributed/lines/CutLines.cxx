// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lines/CutLines.h"

#include <algorithm>
#include <map>

namespace geodesic::distributed
{
namespace
{

/** A point of a line as it is sent. */
struct SentPoint
{
  std::uint64_t line;
  GlobalPathPoint point;
};

std::vector<SentPoint> pointsOnAll(RankGroup& ranks, std::span<const GlobalPath> lines)
{
  RankGroup::Message message;
  ranks.together(
    [&]
    {
      for (std::size_t line = 0; ranks.rank() == 0 && line < lines.size(); ++line)
      {
        for (const GlobalPathPoint& point : lines[line])
        {
          append(message, SentPoint{ line, point });
        }
      }
    });
  return valuesIn<SentPoint>(ranks.fromFirst(std::move(message)));
}

/** The vertices that carry a point, each with its weight. */
std::map<GlobalVertex, double> placeOf(const GlobalPathPoint& point)
{
  std::map<GlobalVertex, double> place;
  for (int c = 0; c < 3; ++c)
  {
    if (point.weights[c] > 0.0)
    {
      place.emplace(point.corners[c], point.weights[c]);
    }
  }
  return place;
}

/** Whether some vertices are those of a face, an edge or a point of the piece. */
bool haveFace(const TriangleMesh& mesh, const Carriers& vertices)
{
  return vertices.size() <= 3 && mesh.hasTriangleWith({ vertices.begin(), vertices.end() });
}

/** A point on this rank's piece; without corners if it is not there. */
bool findLocally(const DistributedSurface& surface, const GlobalPathPoint& point, PathPoint& local)
{
  local.weights = point.weights;
  Index known = NoIndex;
  for (int c = 0; c < 3; ++c)
  {
    local.corners[c] = NoIndex;
    if (point.weights[c] > 0.0)
    {
      local.corners[c] = known = surface.shared().find(point.corners[c]);
      if (known == NoIndex)
      {
        return false;
      }
    }
  }
  // A corner without a weight does not matter, but it must exist.
  std::replace(local.corners.begin(), local.corners.end(), NoIndex, known);
  return haveFace(surface.mesh(), local.carriers());
}

}

CutLines cutLinesOf(
  RankGroup& ranks, const DistributedSurface& surface, std::span<const GlobalPath> lines)
{
  const std::vector<SentPoint> points = pointsOnAll(ranks, lines);
  CutLines cut;
  std::map<std::map<GlobalVertex, double>, Index> numbers;
  const auto numberOf = [&](const GlobalPathPoint& point)
  { return numbers.emplace(placeOf(point), static_cast<Index>(numbers.size())).first->second; };
  bool goesOn = false;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto& [line, point] = points[i];
    const bool isFirst = i == 0 || points[i - 1].line != line;
    if (isFirst)
    {
      cut.ends.emplace_back(numberOf(point), NoIndex);
    }
    if (i + 1 == points.size() || points[i + 1].line != line)
    {
      cut.ends.back().second = numberOf(point);
    }
    PathPoint local;
    const bool isHere = findLocally(surface, point, local);
    if (isHere && goesOn && !isFirst &&
      haveFace(surface.mesh(), unionOf(cut.parts.back().back(), local)))
    {
      cut.parts.back().push_back(local);
    }
    else if (isHere)
    {
      cut.parts.push_back({ local });
      cut.lineOf.push_back(line);
    }
    goesOn = isHere;
  }
  return cut;
}

}
