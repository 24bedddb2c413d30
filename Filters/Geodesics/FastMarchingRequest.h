// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_FastMarchingRequest_h
#define geodesic_bridge_FastMarchingRequest_h

#include "filter/ProgressReporter.h"
#include "request/CostAndBarriers.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include "vtkFastMarchingGeodesicDistance.h"

#include <span>
#include <vector>

namespace geodesic::bridge
{

/** The seeds and options of a vtkFastMarchingGeodesicDistance, as a solver takes them. */
class FastMarchingRequest
{
public:
  /**
   * @param filter the filter with the options; it invokes IterationEvent
   * @param runner the filter that runs: it reports progress, and either of the two can abort it
   * @throws std::invalid_argument if an option does not fit the surface
   */
  FastMarchingRequest(
    vtkFastMarchingGeodesicDistance& filter, const InputSurface& surface, vtkAlgorithm& runner);
  FastMarchingRequest(const FastMarchingRequest&) = delete;
  FastMarchingRequest& operator=(const FastMarchingRequest&) = delete;

  std::span<const Seed> seeds() const { return this->Seeds; }
  /** The options refer to arrays of this object, which must outlive them. */
  const SolveOptions& options() const { return this->Options; }

private:
  bool mayGoOn(std::size_t taken);

  vtkFastMarchingGeodesicDistance& Filter;
  vtkAlgorithm& Runner;
  ProgressReporter Reporter;
  std::vector<Seed> Seeds;
  std::vector<Triangle> Targets;
  std::vector<double> Cost;
  Barriers Excluded;
  SolveOptions Options;
};

}

#endif
