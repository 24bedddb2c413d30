// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_StopLimit_h
#define geodesic_StopLimit_h

#include "solve/DistanceField.h"
#include "solve/Goal.h"
#include "solve/SolveOptions.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace geodesic
{

/**
 * The distance beyond which no vertex needs a value: the maximum distance or that of the targets,
 * whichever is less. At single vertices SolveOptions::usefulBelow can be less still. The limit
 * falls when the targets' distances fall, and never rises. So a value once ignored as too large is
 * never needed later, in whatever order the march goes.
 */
class StopLimit
{
public:
  StopLimit(const TriangleMesh& mesh, const SolveOptions& options, const DistanceField& field)
    : Mesh(mesh)
    , Options(options)
    , Field(field)
    , Limit(options.maximumDistance)
    , UsefulBelow(options.usefulBelow)
    , Elsewhere(options.targets.size(), DistanceField::Unreached)
    , BeyondCorners(std::max(options.beyondTargets, beyondCorners(mesh, options.pathStarts)))
  {
    const bool hasGoal = options.onlyTowardsTargets && !options.partition &&
      !options.targets.empty() && options.targetMode == TargetMode::All;
    if (hasGoal)
    {
      this->Towards = Goal(mesh, options);
    }
  }

  /** The limit; infinity where there is none yet. */
  double value() const { return this->Limit; }
  /** Whether there is a limit now. */
  bool isKnown() const { return this->Limit < DistanceField::Unreached; }
  /** Whether there is a limit now or may be one later. */
  bool isPossible() const
  {
    return this->isKnown() || !this->Options.targets.empty() || !this->UsefulBelow.empty();
  }

  /**
   * Sets how far a value at each vertex can lie above the limit and still matter to values below
   * it. The numbers must live as long as this object is used.
   */
  void setReaches(std::span<const float> ofVertices) { this->Reaches = ofVertices; }
  std::span<const float> reaches() const { return this->Reaches; }
  /**
   * The largest value that may still matter at a vertex; infinity where there is no limit yet.
   * @pre reaches are set
   */
  double with(Index vertex) const
  {
    const double ofAll = this->ofAllWith(vertex);
    return this->UsefulBelow.empty()
      ? ofAll
      : std::min(ofAll, this->UsefulBelow[vertex] + this->Reaches[vertex]);
  }
  /** The largest exact distance of a vertex that may matter. */
  double exactly(Index vertex) const
  {
    const double ofAll = this->Limit - this->leftFrom(vertex);
    return this->UsefulBelow.empty() ? ofAll : std::min(ofAll, this->UsefulBelow[vertex]);
  }

  /** The goal of the march, if it has one. */
  const Goal& goal() const { return this->Towards; }
  /** What is left at least of a path from a vertex to a target; 0 without a goal. */
  double leftFrom(Index vertex) const
  {
    return this->Towards.leftFrom(this->Mesh.position(vertex));
  }

  /** Lowers the limit to what the targets' present distances allow. The march calls this regularly.
   */
  void update()
  {
    if (!this->Options.targets.empty())
    {
      this->Limit = std::min(this->Options.maximumDistance, this->distanceOfTargets());
    }
  }

  /** The distance of each target, as far as known; infinity for one not reached yet. */
  std::vector<double> targetDistances() const
  {
    std::vector<double> distances(this->Elsewhere.size());
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
      distances[i] = this->distanceOf(i);
    }
    return distances;
  }

  /** Takes over the targets' distances that other pieces of the surface know, and updates. */
  void learn(std::span<const double> targetDistances)
  {
    this->Elsewhere.assign(targetDistances.begin(), targetDistances.end());
    this->update();
  }

  /** Why a march that was not cancelled ended. */
  StopReason reason() const
  {
    if (!this->Options.targets.empty() && this->distanceOfTargets() <= this->Limit &&
      this->distanceOfTargets() < DistanceField::Unreached)
    {
      return StopReason::Targets;
    }
    return this->isKnown() ? StopReason::MaximumDistance : StopReason::Exhausted;
  }

  /** How much farther than all corners of its face a point from which a path is wanted may be, as
   * fronts can meet inside of the face. */
  static double beyondCorners(const TriangleMesh& mesh, std::span<const SurfacePoint> starts)
  {
    double most = 0.0;
    for (const SurfacePoint& start : starts)
    {
      const Vector3 position = mesh.positionOf(start);
      const bool isVertex = *std::max_element(start.weights.begin(), start.weights.end()) >= 1.0;
      for (const Index corner : mesh.triangle(start.triangle))
      {
        most = isVertex ? most : std::max(most, norm(mesh.position(corner) - position));
      }
    }
    return most;
  }

private:
  /** with(), by the limit of all vertices alone. */
  double ofAllWith(Index vertex) const
  {
    if (!this->isKnown())
    {
      return this->Limit;
    }
    // From one vertex to the next not only the distance can grow, but also what is left. And what
    // lies beside a path must be right for it to be traced.
    constexpr double beside = 4.0;
    return this->Towards.isKnown()
      ? this->Limit + beside * this->Reaches[vertex] - this->leftFrom(vertex)
      : this->Limit + this->Reaches[vertex];
  }

  double distanceOf(std::size_t number) const
  {
    const Triangle& target = this->Options.targets[number];
    const double known = this->Elsewhere[number];
    return target[0] == NoIndex
      ? known
      : std::min(known,
          std::max({ this->Field.distance(target[0]), this->Field.distance(target[1]),
            this->Field.distance(target[2]) }) +
            this->BeyondCorners);
  }

  double distanceOfTargets() const
  {
    const bool isAny = this->Options.targetMode == TargetMode::Any;
    // As long as one target is not reached, all are not. There may be many, so it is remembered.
    if (!isAny && this->distanceOf(this->Unreached) == DistanceField::Unreached)
    {
      return DistanceField::Unreached;
    }
    double decisive = isAny ? DistanceField::Unreached : 0.0;
    for (std::size_t i = 0; i < this->Elsewhere.size(); ++i)
    {
      const double distance = this->distanceOf(i);
      if (!isAny && distance == DistanceField::Unreached)
      {
        this->Unreached = i;
        return distance;
      }
      decisive = isAny ? std::min(decisive, distance) : std::max(decisive, distance);
    }
    return decisive;
  }

  const TriangleMesh& Mesh;
  const SolveOptions& Options;
  const DistanceField& Field;
  Goal Towards;
  double Limit;
  std::span<const double> UsefulBelow;
  std::span<const float> Reaches;
  /** For each target the distance that other pieces know. */
  std::vector<double> Elsewhere;
  double BeyondCorners;
  /** The number of a target that was not reached when this was last looked at. */
  mutable std::size_t Unreached = 0;
};

}

#endif
