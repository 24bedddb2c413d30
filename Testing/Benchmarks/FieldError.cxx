// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FieldError.h"

#include "ExactDistances.h"
#include "Solving.h"
#include "methods/SolverTable.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace geodesic::testing
{

FieldError errorOn(const Surface& surface, const std::string& method)
{
  constexpr Index sources = 3;
  const auto mesh = meshOf(surface);
  const auto solver = solverOfName(method).make(mesh);
  std::mt19937 random(1);
  FieldError error;
  for (Index i = 0; i < sources; ++i)
  {
    const Index source = random() % static_cast<Index>(surface.points.size());
    const std::vector<double> exact = exactDistances(surface, { source });
    const Seed seed = seedAt(*mesh, source);
    const DistanceField& found = solver->solve({ &seed, 1 }, {});
    for (Index point = 0; point < exact.size(); ++point)
    {
      if (exact[point] > 0.0)
      {
        const double off = found.distance(mesh->vertexOfPoint(point)) / exact[point] - 1.0;
        error.tooSmall = std::max(error.tooSmall, -off);
        error.mean += std::abs(off) / (sources * static_cast<double>(exact.size()));
      }
    }
  }
  return error;
}

}
