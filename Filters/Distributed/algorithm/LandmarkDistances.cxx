// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/LandmarkDistances.h"

#include "gather/CorridorMesh.h"
#include "solve/DistanceSolver.h"

#include <algorithm>
#include <limits>

namespace geodesic::distributed
{
namespace
{

double lengthOf(const PathRequest& request, const std::optional<TracedPath>& path)
{
  if (!path)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return geodesic::lengthOf(
    path->corridor ? path->corridor->mesh() : request.solver.mesh(), path->path);
}

/** The lengths from one landmark, whose march is number @p march, to some others; fewer if aborted.
 */
std::vector<double> lengthsFrom(const PathRequest& request, std::size_t march,
  const GlobalPoint& landmark, std::span<const GlobalPoint> others,
  const std::function<bool()>& isAborted)
{
  PathRequest own = request;
  if (request.options.onProgress)
  {
    const std::size_t before = march * request.solver.mesh().numberOfVertices();
    own.options.onProgress = [&request, before](std::size_t taken)
    { return request.options.onProgress(before + taken); };
  }
  std::vector<double> lengths;
  DistributedPathFinder finder(own, { landmark });
  finder.march(others);
  for (auto other = others.begin(); other != others.end() && !isAborted(); ++other)
  {
    const double length = lengthOf(request, finder.pathFrom(*other));
    if (isAborted())
    {
      break;
    }
    lengths.push_back(length);
  }
  return lengths;
}

}

std::optional<std::vector<double>> distancesAmong(const PathRequest& request,
  std::span<const GlobalPoint> landmarks, const std::function<bool()>& isAborted)
{
  const std::size_t count = landmarks.size();
  std::vector<double> matrix(count * count, 0.0);
  for (std::size_t i = 0; i + 1 < count; ++i)
  {
    const auto later = landmarks.subspan(i + 1);
    const auto lengths = lengthsFrom(request, i, landmarks[i], later, isAborted);
    if (lengths.size() < later.size())
    {
      return std::nullopt;
    }
    for (std::size_t j = i + 1; j < count; ++j)
    {
      matrix[i * count + j] = matrix[j * count + i] = lengths[j - i - 1];
    }
  }
  return matrix;
}

std::optional<std::vector<double>> distancesBetween(const PathRequest& request,
  std::span<const GlobalPoint> from, std::span<const GlobalPoint> to,
  const std::function<bool()>& isAborted)
{
  const bool marchesFromRows = from.size() <= to.size();
  const auto seeds = marchesFromRows ? from : to;
  const auto others = marchesFromRows ? to : from;
  std::vector<double> matrix(from.size() * to.size());
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const auto lengths = lengthsFrom(request, i, seeds[i], others, isAborted);
    if (lengths.size() < others.size())
    {
      return std::nullopt;
    }
    for (std::size_t j = 0; j < others.size(); ++j)
    {
      matrix[marchesFromRows ? i * to.size() + j : j * to.size() + i] = lengths[j];
    }
  }
  return matrix;
}

}
