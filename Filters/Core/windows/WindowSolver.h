// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowSolver_h
#define geodesic_WindowSolver_h

#include "mesh/EdgeTable.h"
#include "solve/FrontSolver.h"
#include "windows/WindowFront.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace geodesic
{

class WindowMerging;

/** What the solvers by windows have in common: the march, and what paths need of it. */
class WindowSolver : public FrontSolver
{
public:
  bool findsPaths() const override { return true; }
  /** See DistanceSolver. The points are left out if rounding led the path astray, or a seed is a
   * curve or a region. */
  std::optional<FoundPath> pathFrom(const SurfacePoint& start) const override;

protected:
  /** Time O(n). */
  explicit WindowSolver(std::shared_ptr<const TriangleMesh> mesh);

  /**
   * Marches windows.
   * @param distances  what is asked for, to begin a message: "Exact distances"
   * @param merging    null: the field gets exact distances, else bounds that are not below them
   */
  bool marchWindows(const char* distances, const WindowMerging* merging, const Request& request,
    StopLimit& limit, DistanceField& field);

  void forgetLast() override { this->Reach = -1.0; }

  /** How the last run came to a point that it reached. */
  virtual std::vector<SurfacePoint> trace(
    const SurfacePoint& start, const PathStarts::Start& found) const = 0;

  EdgeTable Edges;
  WindowWorkspace Workspace;
  // Of the last run, for paths.
  std::optional<PassableTriangles> Passable;
  std::vector<SurfacePoint> SeedPoints;
  std::vector<double> SeedValues;
  const DistanceField* Found = nullptr;

private:
  void keepSeeds(std::span<const Seed> seeds);

  bool ArePoints = true;
  /** Up to which value of the field all was found. */
  double Reach = 0.0;
};

}

#endif
