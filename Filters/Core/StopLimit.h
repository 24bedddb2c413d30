#ifndef geodesic_StopLimit_h
#define geodesic_StopLimit_h

#include "DistanceField.h"
#include "SolveOptions.h"

#include <algorithm>

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
  {
  }

  double value() const { return this->Limit; }

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

  StopReason reason() const
  {
    if (!this->Options.targets.empty() && this->distanceOfTargets() <= this->Limit &&
      this->distanceOfTargets() < DistanceField::Unreached)
    {
      return StopReason::Targets;
    }
    return this->Limit < DistanceField::Unreached ? StopReason::MaximumDistance
                                                  : StopReason::Exhausted;
  }

private:
  double distanceOf(const Triangle& target) const
  {
    return std::max({ this->Field.distance(target[0]), this->Field.distance(target[1]),
      this->Field.distance(target[2]) });
  }

  double distanceOfTargets() const
  {
    const bool isAny = this->Options.targetMode == TargetMode::Any;
    double decisive = isAny ? DistanceField::Unreached : 0.0;
    for (const Triangle& target : this->Options.targets)
    {
      const double distance = this->distanceOf(target);
      decisive = isAny ? std::min(decisive, distance) : std::max(decisive, distance);
    }
    return decisive;
  }

  const SolveOptions& Options;
  const DistanceField& Field;
  double Limit;
};

}

#endif
