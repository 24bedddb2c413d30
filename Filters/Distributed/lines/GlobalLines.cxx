// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lines/GlobalLines.h"

#include "algorithm/DistributedPathFinder.h"
#include "algorithm/PiecewisePaths.h"
#include "march/FastMarchingSolver.h"
#include "path/SurfaceCurve.h"
#include "request/PointSource.h"

#include <algorithm>
#include <set>

namespace geodesic::distributed
{
namespace
{

/** From so many joints on, ranks seek them piece by piece. Fewer are those of one rank also where
 * two ways are equally long. */
constexpr std::size_t LeastJoints = 64;

/** Returns the lines of a source, x y z of each point in turn. */
std::vector<std::vector<double>> coordinatesOfLines(vtkDataObject* source)
{
  std::vector<std::vector<double>> lines;
  if (source)
  {
    const bridge::PointSource points(source);
    for (const std::vector<std::size_t>& numbers : points.lines)
    {
      std::vector<double>& line = lines.emplace_back();
      for (const std::size_t number : numbers)
      {
        const double* point = points.coordinates.data() + 3 * number;
        line.insert(line.end(), point, point + 3);
      }
    }
  }
  return lines;
}

std::vector<std::vector<double>> linesOfAll(
  RankGroup& ranks, const std::vector<std::vector<double>>& own)
{
  std::vector<double> flat;
  for (const std::vector<double>& line : own)
  {
    flat.push_back(static_cast<double>(line.size()));
    flat.insert(flat.end(), line.begin(), line.end());
  }
  std::vector<std::vector<double>> lines;
  std::set<std::vector<double>> ofLowerRanks;
  for (const std::vector<double>& ofRank : ranks.gatherByRank(flat))
  {
    std::set<std::vector<double>> ofThis;
    for (auto at = ofRank.begin(); at != ofRank.end();)
    {
      const auto first = at + 1;
      at = first + static_cast<std::ptrdiff_t>(*at);
      std::vector<double> line(first, at);
      if (!ofLowerRanks.contains(line))
      {
        ofThis.insert(line);
        lines.push_back(std::move(line));
      }
    }
    ofLowerRanks.merge(ofThis);
  }
  return lines;
}

/** Whether two points lie in one triangle of this rank. */
bool shareFaceHere(const DistributedSurface& surface, const GlobalPoint& a, const GlobalPoint& b)
{
  std::set<GlobalVertex> carriers;
  for (const GlobalPoint* point : { &a, &b })
  {
    for (int c = 0; c < 3; ++c)
    {
      if (point->weights[c] > 0.0)
      {
        carriers.insert(point->corners[c]);
      }
    }
  }
  std::vector<Index> local;
  for (const GlobalVertex& carrier : carriers)
  {
    local.push_back(surface.shared().find(carrier));
  }
  const bool areAllLocal = std::find(local.begin(), local.end(), NoIndex) == local.end();
  return local.size() <= 3 && areAllLocal && surface.mesh().hasTriangleWith(local);
}

/**
 * For each two points that follow on each other, of all lines in turn, whether they lie in one
 * triangle of any rank. Collective.
 */
std::vector<bool> whichShareFaces(
  RankGroup& ranks, const DistributedSurface& surface, const GlobalLines& lines)
{
  std::vector<double> areApart;
  ranks.together(
    [&]
    {
      for (const std::vector<GlobalPoint>& line : lines)
      {
        for (std::size_t i = 1; i < line.size(); ++i)
        {
          areApart.push_back(shareFaceHere(surface, line[i - 1], line[i]) ? 0.0 : 1.0);
        }
      }
    });
  ranks.takeLeast(areApart);
  std::vector<bool> shareFaces;
  for (const double isApart : areApart)
  {
    shareFaces.push_back(isApart == 0.0);
  }
  return shareFaces;
}

/** The path from its end to its start. */
GlobalPath reversedPathOf(const TracedPath& traced)
{
  GlobalPath path;
  for (const PathPoint& point : traced.path)
  {
    GlobalPathPoint& global = path.emplace_back(GlobalPathPoint{ {}, point.weights });
    for (int c = 0; c < 3; ++c)
    {
      global.corners[c] = traced.corridor->vertex(point.corners[c]).vertex;
    }
  }
  std::reverse(path.begin(), path.end());
  return path;
}

/** Finds the paths that join points of lines. Collective. */
std::vector<FoundPath> jointsOf(RankGroup& ranks, const DistributedSurface& surface,
  const bridge::PathAttributes& input, const std::vector<PointPair>& pairs)
{
  if (pairs.empty())
  {
    return {};
  }
  FastMarchingSolver solver(surface.sharedPiece()->mesh());
  PathRequest request{ ranks, surface, nullptr, nullptr, surface.divided(), solver, {}, {}, input };
  request.options.onProgress = [](std::size_t) { return true; };
  std::vector<FoundPath> found(pairs.size());
  if (pairs.size() >= LeastJoints)
  {
    found = PiecewisePaths(request, false).find(pairs);
  }
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    if (!found[i].isKnown)
    {
      DistributedPathFinder finder(request, { pairs[i].from });
      const auto path =
        finder.march({ &pairs[i].to, 1 }) ? finder.pathFrom(pairs[i].to) : std::nullopt;
      found[i].hasPath = path.has_value();
      found[i].path = path ? reversedPathOf(*path) : GlobalPath{};
    }
  }
  return found;
}

}

GlobalLines globalLinesOf(RankGroup& ranks, const DistributedSurface& surface,
  vtkDataObject* source, const std::string& property)
{
  std::vector<std::vector<double>> own;
  ranks.together([&] { own = coordinatesOfLines(source); });
  const std::vector<std::vector<double>> all = linesOfAll(ranks, own);
  std::vector<double> coordinates;
  for (const std::vector<double>& line : all)
  {
    coordinates.insert(coordinates.end(), line.begin(), line.end());
  }
  const std::vector<GlobalPoint> points =
    globalPointsAt(ranks, surface, coordinates, property, Precision::Single);
  GlobalLines lines;
  auto at = points.begin();
  for (const std::vector<double>& line : all)
  {
    const auto first = at;
    at += static_cast<std::ptrdiff_t>(line.size() / 3);
    lines.emplace_back(first, at);
  }
  return lines;
}

std::vector<GlobalPath> joinedLines(RankGroup& ranks, const DistributedSurface& surface,
  const bridge::PathAttributes& input, const GlobalLines& lines, const std::string& property)
{
  const std::vector<bool> shareFaces = whichShareFaces(ranks, surface, lines);
  std::vector<PointPair> apart;
  auto sharesFace = shareFaces.begin();
  for (const std::vector<GlobalPoint>& line : lines)
  {
    for (std::size_t i = 1; i < line.size(); ++i)
    {
      if (!*sharesFace++)
      {
        apart.push_back({ line[i - 1], line[i] });
      }
    }
  }
  const std::vector<FoundPath> joints = jointsOf(ranks, surface, input, apart);
  auto joint = joints.begin();
  sharesFace = shareFaces.begin();
  std::vector<GlobalPath> paths;
  for (const std::vector<GlobalPoint>& line : lines)
  {
    GlobalPath path{ { line[0].corners, line[0].weights } };
    for (std::size_t i = 1; i < line.size(); ++i)
    {
      if (*sharesFace++)
      {
        path.push_back({ line[i].corners, line[i].weights });
        continue;
      }
      const auto& [isKnown, hasPath, isProven, cost, points] = *joint++;
      if (!hasPath)
      {
        throwUnjoined(property + "'s line " + std::to_string(paths.size()), i);
      }
      if (!points.empty())
      {
        path.insert(path.end(), points.begin() + 1, points.end());
      }
    }
    paths.push_back(ranks.rank() == 0 ? std::move(path) : GlobalPath{});
  }
  return paths;
}

}
