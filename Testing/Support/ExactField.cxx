// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Exact distances for tests that are not in C++.
// usage: ExactField MESH.off < SEEDS > DISTANCES
// Each line of SEEDS is one seed: x y z of its positions. Its line of DISTANCES has the distance of
// each point of the mesh, -1 for one that no triangle uses or that can't be reached.

#include "ExactDistances.h"

#include <exception>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>

using namespace geodesic::testing;

int main(int count, char** arguments)
try
{
  if (count != 2)
  {
    std::cerr << "usage: ExactField MESH.off < SEEDS > DISTANCES\n";
    return 2;
  }
  const Surface surface = readOff(arguments[1]);
  std::cout << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (std::string line; std::getline(std::cin, line);)
  {
    std::vector<geodesic::Vector3> positions;
    std::istringstream numbers(line);
    for (geodesic::Vector3 p; numbers >> p.x >> p.y >> p.z;)
    {
      positions.push_back(p);
    }
    for (double distance : exactDistancesFromPositions(surface, positions))
    {
      std::cout << distance << ' ';
    }
    std::cout << '\n';
  }
  return 0;
}
catch (const std::exception& error)
{
  std::cerr << error.what() << '\n';
  return 1;
}
