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

/** What the values of a cost array are. */
enum class CostMeaning
{
  Cost,
  /** The cost is 1 / value. */
  Speed
};

/**
 * The cost at each vertex from values at the input's points; the mean where points are merged.
 * @param role what has the values, for the message
 * @throws std::invalid_argument where a value on the surface is not positive and finite, naming the
 * first such point
 */
std::vector<double> costOfValues(const InputSurface& surface, std::span<const double> values,
  CostMeaning meaning, const std::string& role);

/** Where the front may not go. */
struct Barriers
{
  /** One flag a vertex, or empty. */
  std::vector<std::uint8_t> excluded;
  /** One flag a triangle, or empty. */
  std::vector<std::uint8_t> closed;
};

/** Excludes points; those that no cell uses need no excluding. Throws for an id that does not
 * exist. */
void excludePoints(const TriangleMesh& mesh, vtkIdList* ids, Barriers& barriers);

/** Excludes the points, or closes the cells, whose value is neither 0 nor NaN. */
void addBarrierArray(const InputSurface& surface, const ChosenArray& array, Barriers& barriers);

}

#endif
