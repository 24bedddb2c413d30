#ifndef geodesic_StopLimit_h
#define geodesic_StopLimit_h

#include "DistanceField.h"
#include "SolveOptions.h"
#include "TriangleMesh.h"

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
   * The largest value that may still matter at a vertex: one above the limit can lower its
   * neighbours' a little below it, but not beyond an edge's length.
   */
  double reach(const TriangleMesh& mesh, Index vertex) const
  {
    return this->Limit < DistanceField::Unreached ? this->Limit + mesh.longestEdgeAround(vertex)
                                                  : DistanceField::Unreached;
  }

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
  double distanceOfTargets() const
  {
    const auto nearer = [this](Index a, Index b)
    { return this->Field.distance(a) < this->Field.distance(b); };
    const auto& targets = this->Options.targets;
    const auto decisive = this->Options.targetMode == TargetMode::Any
      ? std::min_element(targets.begin(), targets.end(), nearer)
      : std::max_element(targets.begin(), targets.end(), nearer);
    return this->Field.distance(*decisive);
  }

  const SolveOptions& Options;
  const DistanceField& Field;
  double Limit;
};

}

#endif
