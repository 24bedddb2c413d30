// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_StopLimit_h
#define geodesic_StopLimit_h

#include "solve/DistanceField.h"
#include "solve/SolveOptions.h"

#include <algorithm>
#include <span>
#include <vector>

namespace geodesic
{

/**
 * The distance beyond which nothing is asked for: the maximum distance or that of the targets,
 * whichever is less. It falls while the front comes nearer to the targets. As it never rises, what
 * was passed over once is never missed, whatever the order of the march.
 */
class StopLimit
{
public:
  StopLimit(const SolveOptions& options, const DistanceField& field)
    : Options(options)
    , Field(field)
    , Limit(options.maximumDistance)
    , Elsewhere(options.targets.size(), DistanceField::Unreached)
  {
  }

  double value() const { return this->Limit; }
  /** Whether there is one now. */
  bool isKnown() const { return this->Limit < DistanceField::Unreached; }
  /** Whether there is one now, or may be later. */
  bool isPossible() const { return this->isKnown() || !this->Options.targets.empty(); }

  /**
   * The largest value that may still matter where neighbours differ by up to @p reach: one above
   * the limit can lower its neighbours' a little below it, but not beyond that.
   */
  double with(double reach) const { return this->Limit + reach; }

  /** To be called now and then; lowers the limit to what the targets' distances allow. */
  void update()
  {
    if (!this->Options.targets.empty())
    {
      this->Limit = std::min(this->Options.maximumDistance, this->distanceOfTargets());
    }
  }

  /** Of each target as far as it is known; infinity for one that is on another piece. */
  std::vector<double> targetDistances() const
  {
    std::vector<double> distances(this->Elsewhere.size());
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
      distances[i] = this->distanceOf(i);
    }
    return distances;
  }

  /** Takes over the distances of the targets that other pieces of the surface know. */
  void learn(std::span<const double> targetDistances)
  {
    this->Elsewhere.assign(targetDistances.begin(), targetDistances.end());
    this->update();
  }

  StopReason reason() const
  {
    if (!this->Options.targets.empty() && this->distanceOfTargets() <= this->Limit &&
      this->distanceOfTargets() < DistanceField::Unreached)
    {
      return StopReason::Targets;
    }
    return this->isKnown() ? StopReason::MaximumDistance : StopReason::Exhausted;
  }

private:
  double distanceOf(std::size_t number) const
  {
    const Triangle& target = this->Options.targets[number];
    const double known = this->Elsewhere[number];
    return target[0] == NoIndex
      ? known
      : std::min(known,
          std::max({ this->Field.distance(target[0]), this->Field.distance(target[1]),
            this->Field.distance(target[2]) }));
  }

  double distanceOfTargets() const
  {
    const bool isAny = this->Options.targetMode == TargetMode::Any;
    double decisive = isAny ? DistanceField::Unreached : 0.0;
    for (std::size_t i = 0; i < this->Elsewhere.size(); ++i)
    {
      const double distance = this->distanceOf(i);
      decisive = isAny ? std::min(decisive, distance) : std::max(decisive, distance);
    }
    return decisive;
  }

  const SolveOptions& Options;
  const DistanceField& Field;
  double Limit;
  /** Of each target, the distance that other pieces know. */
  std::vector<double> Elsewhere;
};

}

#endif
