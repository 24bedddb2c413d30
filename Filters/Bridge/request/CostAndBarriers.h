// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_CostAndBarriers_h
#define geodesic_bridge_CostAndBarriers_h

#include "input/ArrayValues.h"
#include "input/InputSurface.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

class vtkIdList;

namespace geodesic::bridge
{

/** The meaning of the values of a cost array. */
enum class CostMeaning
{
  Cost,
  /** The cost is 1 / value. */
  Speed
};

/**
 * Computes the cost at each vertex from values at the input's points. The cost of merged points is
 * the mean of theirs.
 * @param role name of the values in the error message
 * @throws std::invalid_argument if a value on the surface is not positive and finite; the message
 * names the first such point
 */
std::vector<double> costOfValues(const InputSurface& surface, std::span<const double> values,
  CostMeaning meaning, const std::string& role);

/** The same from an array of points. @throws std::invalid_argument for one of cells, too */
std::vector<double> costOfArray(
  const InputSurface& surface, const ChosenArray& array, CostMeaning meaning);

/** The vertices and triangles that no front enters. */
struct Barriers
{
  /** One flag for each vertex; empty if none is excluded. */
  std::vector<std::uint8_t> excluded;
  /** One flag for each triangle; empty if none is closed. */
  std::vector<std::uint8_t> closed;

  friend bool operator==(const Barriers&, const Barriers&) = default;
};

/**
 * Excludes the points with the given ids; null means none. Points that no cell uses are ignored.
 * @throws std::invalid_argument if an id does not exist
 */
void excludePoints(const TriangleMesh& mesh, vtkIdList* ids, Barriers& barriers);

/** Excludes the points, or closes the cells, whose value is neither 0 nor NaN. */
void addBarrierArray(const InputSurface& surface, const ChosenArray& array, Barriers& barriers);

}

#endif
