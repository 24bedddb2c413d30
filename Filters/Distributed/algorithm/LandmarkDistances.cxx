// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/LandmarkDistances.h"

#include "gather/CorridorMesh.h"
#include "solve/DistanceSolver.h"
#include "survey/LandmarkOrder.h"

#include <algorithm>
#include <limits>
#include <utility>

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

/** Writes the lengths from one landmark to some others; stops where the search is aborted.
 * @param write  takes the number of each of the others and the length of the path to it */
template <class Write>
void findLengths(const PathRequest& request, const GlobalPoint& landmark,
  std::span<const GlobalPoint> others, const PathSearches::IsAborted& isAborted, const Write& write)
{
  DistributedPathFinder finder(request, { landmark });
  finder.march(others);
  for (std::size_t i = 0; i < others.size() && !isAborted(); ++i)
  {
    write(i, lengthOf(request, finder.pathFrom(others[i])));
  }
}

bool areAll(const std::vector<bool>& areMade)
{
  return std::find(areMade.begin(), areMade.end(), false) == areMade.end();
}

}

std::optional<std::vector<double>> distancesAmong(
  PathSearches& searches, std::span<const GlobalPoint> landmarks)
{
  const std::size_t count = landmarks.size();
  std::vector<Vector3> positions;
  for (const GlobalPoint& landmark : landmarks)
  {
    positions.push_back(landmark.position);
  }
  const std::vector<std::size_t> order = landmarkOrder(positions);
  std::vector<GlobalPoint> ordered;
  for (const std::size_t number : order)
  {
    ordered.push_back(landmarks[number]);
  }
  std::vector<double> matrix(count * count, 0.0);
  const auto areMade = searches.run(count - 1,
    [&](std::size_t place, const PathRequest& request, const PathSearches::IsAborted& isAborted)
    {
      const std::span<const GlobalPoint> others = std::span(ordered).subspan(place + 1);
      findLengths(request, ordered[place], others, isAborted,
        [&](std::size_t later, double length)
        {
          const std::size_t i = order[place];
          const std::size_t j = order[place + 1 + later];
          matrix[i * count + j] = matrix[j * count + i] = length;
        });
    });
  return areAll(areMade) ? std::optional(std::move(matrix)) : std::nullopt;
}

std::optional<std::vector<double>> distancesBetween(
  PathSearches& searches, std::span<const GlobalPoint> from, std::span<const GlobalPoint> to)
{
  const bool marchesFromRows = from.size() <= to.size();
  const auto seeds = marchesFromRows ? from : to;
  const auto others = marchesFromRows ? to : from;
  std::vector<double> matrix(from.size() * to.size());
  const auto areMade = searches.run(seeds.size(),
    [&](std::size_t i, const PathRequest& request, const PathSearches::IsAborted& isAborted)
    {
      findLengths(request, seeds[i], others, isAborted,
        [&](std::size_t j, double length)
        { matrix[marchesFromRows ? i * to.size() + j : j * to.size() + i] = length; });
    });
  return areAll(areMade) ? std::optional(std::move(matrix)) : std::nullopt;
}

}
