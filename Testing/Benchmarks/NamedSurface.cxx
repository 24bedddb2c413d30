// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NamedSurface.h"

#include "WorstSurfaces.h"

#include <stdexcept>

namespace geodesic::testing
{

Surface namedSurface(const std::string& name)
{
  const std::size_t colon = name.find(':');
  const std::string kind = name.substr(0, colon);
  const int size = std::stoi(name.substr(colon + 1));
  if (kind == "sphere")
  {
    return icosphere(size);
  }
  if (kind == "torus")
  {
    return torus(2 * static_cast<Index>(size), static_cast<Index>(size), 3.0, 1.0);
  }
  if (kind == "terrain")
  {
    return hillyGrid(static_cast<Index>(size), static_cast<Index>(size));
  }
  if (kind == "bunny")
  {
    return subdivided(bunny(), size);
  }
  throw std::invalid_argument(name + " is none of sphere, torus, terrain and bunny with a size.");
}

}
