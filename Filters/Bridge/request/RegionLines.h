// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_RegionLines_h
#define geodesic_bridge_RegionLines_h

#include "input/InputSurface.h"
#include "path/PathPoint.h"
#include "request/PointSource.h"
#include "request/SurfaceLines.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

class vtkDataObject;

namespace geodesic
{
class DistanceSolver;
}

namespace geodesic::bridge
{

/**
 * The lines that cut a surface into regions, moved to it and joined over it. What is joined is kept
 * from run to run, for the lines that do not change.
 */
class RegionLines
{
public:
  /**
   * @param source  null for no lines
   * @param goesOn  called for each line that is not kept; false stops
   * @return false if stopped
   * @throws std::invalid_argument for points that are not finite, points without lines, and lines
   *         with points on parts of the surface that are not connected
   */
  bool update(const std::shared_ptr<const InputSurface>& surface, vtkDataObject* source,
    const std::function<bool()>& goesOn);

  const std::vector<SurfacePath>& paths() const { return this->Paths; }

private:
  /** The path through the points of a line. */
  SurfacePath joined(const LinePoints& points, std::size_t line);

  std::shared_ptr<const InputSurface> Surface;
  std::vector<LinePoints> Points;
  std::vector<SurfacePath> Paths;
  /** Made when two points of a line share no face. */
  std::shared_ptr<DistanceSolver> Solver;
};

/**
 * Checks that a data set has lines if it has points.
 * @throws std::invalid_argument otherwise
 */
void checkHasLines(const PointSource& source);

/**
 * Says which lines have the same region on both sides everywhere, and what helps; empty if none
 * has. Lines that follow on each other, as the segments of a closed path do, count as one.
 * @param ends      of each line, see chainsOf()
 * @param separates for each line whether it has different regions on its sides
 */
std::string linesThatSeparateNothing(
  std::span<const std::pair<Index, Index>> ends, const std::vector<bool>& separates);

}

#endif
