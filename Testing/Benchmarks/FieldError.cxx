// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FieldError.h"

#include "ExactDistances.h"
#include "Solving.h"
#include "WorstSeeds.h"
#include "mesh/ThinTriangles.h"
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
  for (const Index source : randomVertices(*mesh, sources, random))
  {
    const std::vector<double> exact = exactDistances(surface, { mesh->pointOfVertex(source) });
    const Seed seed = Seed::atPoint(mesh->pointAtVertex(source));
    SolveOptions options;
    options.isIntrinsic = countThinTriangles(*mesh).needOthers();
    const DistanceField& found = solver->solve({ &seed, 1 }, options);
    for (Index vertex = 0; vertex < mesh->numberOfVertices(); ++vertex)
    {
      const double truth = exact[mesh->pointOfVertex(vertex)];
      if (truth > 0.0)
      {
        const double off = found.distance(vertex) / truth - 1.0;
        error.tooSmall = std::max(error.tooSmall, -off);
        error.mean += std::abs(off) / (sources * static_cast<double>(mesh->numberOfVertices()));
      }
    }
  }
  return error;
}

}
