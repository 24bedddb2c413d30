// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/WindowRequest.h"

#include "solve/DistanceField.h"
#include "solve/Partition.h"
#include "solve/StopLimit.h"
#include "windows/WindowFront.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace geodesic
{

void checkWindowRequest(
  const char* distances, std::span<const Label> labels, bool hasCost, const Partition& partition)
{
  if (hasCost || partition.isDivided())
  {
    throw std::invalid_argument(std::string(distances) + " can't be measured " +
      (hasCost ? "with costs" : "on a surface in several pieces") +
      "; use the method FastMarching.");
  }
  for (const Label& label : labels)
  {
    if (label.shape == FrontShape::Straight)
    {
      throw std::invalid_argument("Seed " + std::to_string(label.seed) +
        " is a curve or a region, but exact distances are measured from points; use the method "
        "FastMarching, or give points along it as seeds.");
    }
  }
}

double leastKeyOf(std::span<const Label> labels, const StopLimit& limit)
{
  double least = DistanceField::Unreached;
  for (const Label& label : labels)
  {
    least = std::min(
      least, label.value + WindowFront::PartOfOrder * limit.goal().leftFrom(label.position));
  }
  return least;
}

bool marchFrom(std::span<const Label> labels, WindowFront& front)
{
  for (const Label& label : labels)
  {
    front.startAt(label.origin, label.value, label.seed);
    if (!front.mayGoOn())
    {
      return false;
    }
  }
  return front.march();
}

}
