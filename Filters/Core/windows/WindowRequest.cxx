// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/WindowRequest.h"

#include "solve/DistanceField.h"
#include "solve/Partition.h"
#include "solve/StopLimit.h"
#include "windows/SeedWindows.h"
#include "windows/WindowFront.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace geodesic
{

void checkWindowRequest(const char* distances, bool hasCost, const Partition& partition)
{
  if (hasCost || partition.isDivided())
  {
    throw std::invalid_argument(std::string(distances) + " can't be measured " +
      (hasCost ? "with costs" : "on a surface in several pieces") +
      "; use the method FastMarching.");
  }
}

double leastKeyOf(std::span<const Label> labels, const StopLimit& limit)
{
  double least = DistanceField::Unreached;
  for (const Label& label : labels)
  {
    // A straight front has no position.
    const double left =
      label.shape == FrontShape::Round ? limit.goal().leftFrom(label.position) : 0.0;
    least = std::min(least, label.value + WindowFront::PartOfOrder * left);
  }
  return least;
}

bool marchFrom(std::span<const Seed> seeds, const TriangleMesh& mesh, WindowFront& front)
{
  SeedWindows windows(mesh, front);
  bool goesOn = true;
  do
  {
    for (Index i = 0; i < seeds.size() && goesOn; ++i)
    {
      goesOn = windows.start(seeds[i], i);
    }
    goesOn = goesOn && front.march();
  } while (goesOn && front.beginsAgain());
  return goesOn;
}

}
