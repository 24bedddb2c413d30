// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_Trial_h
#define geodesic_testing_Trial_h

#include "Measuring.h"
#include "Subject.h"

#include <functional>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace geodesic::testing
{

/** What a run takes. */
struct RunCost
{
  /** Processor time, the median of several runs where one is short. */
  double seconds = 0.0;
  /** The longest processor time without a report of progress. */
  double silence = 0.0;
  /** Those of the last march, to the last report. */
  std::size_t updates = 0;
  /** Vertices with a distance; 0 where that is not what the run is about. */
  std::size_t reached = 0;
};

/** A surface on which worst cases are measured, with what is made once for an input. */
class Trial
{
public:
  /** @param method  a name of the table of solvers */
  explicit Trial(const Surface& surface, const std::string& method = "FastMarching");

  const TriangleMesh& mesh() const { return *this->Made.mesh; }
  const std::shared_ptr<const TriangleMesh>& sharedMesh() const { return this->Made.mesh; }
  DistanceSolver& solver() { return *this->Solver; }
  std::mt19937& random() { return this->Random; }

  /** Processor time of a field from one vertex. */
  double secondsOfOneSeed();
  /** The same by Dijkstra's algorithm. @param cost of each vertex; empty: 1 */
  double secondsOfDijkstra(std::span<const double> cost = {}) const;

  /** The cost of the field of some seeds. */
  RunCost solve(const std::vector<Seed>& seeds, const SolveOptions& options = {});
  /** The cost of any work on the solver, which is given options that watch its progress. */
  RunCost run(
    const std::function<void(const SolveOptions&)>& work, const SolveOptions& options = {});

private:
  /** Options with which the filters solve: on intrinsic triangles where many are thin. */
  SolveOptions asUsersRun(std::span<const Seed> seeds, SolveOptions options) const;

  SetUp Made;
  std::unique_ptr<DistanceSolver> Solver;
  /** Whether many triangles are thin. */
  bool NeedsOthers;
  std::mt19937 Random;
};

}

#endif
