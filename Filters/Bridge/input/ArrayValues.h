// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_ArrayValues_h
#define geodesic_bridge_ArrayValues_h

#include "input/InputBlocks.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace geodesic::bridge
{

/**
 * Appends the values of an array that has one component and any value type.
 * @param count  number of tuples that the array must have
 * @param role   name of the array in the error message
 * @throws std::invalid_argument if the array has another number of components or tuples
 */
template <class Value>
void appendValues(
  vtkDataArray* array, vtkIdType count, const std::string& role, std::vector<Value>& values)
{
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != count)
  {
    throw std::invalid_argument(role + " has " + std::to_string(array->GetNumberOfTuples()) +
      " tuples of " + std::to_string(array->GetNumberOfComponents()) +
      " components; give an array of one component and " + std::to_string(count) + " tuples.");
  }
  values.resize(values.size() + static_cast<std::size_t>(count));
  const auto copy = [&](auto* typed)
  {
    auto next = values.end() - count;
    for (const auto value : vtk::DataArrayValueRange<1>(typed))
    {
      *next++ = static_cast<Value>(value);
    }
  };
  if (!vtkArrayDispatch::Dispatch::Execute(array, copy))
  {
    copy(array);
  }
}

/** A point or cell array of the input that the user chose, or none. */
struct ChosenArray
{
  /**
   * The property's name and the array's name in quotes, for error messages; empty if none is
   * chosen.
   */
  std::string role;
  bool isOfCells = false;
  /** One value for each point or cell of all blocks; NaN in blocks without faces. */
  std::vector<double> values;

  /** Whether an array is chosen. */
  explicit operator bool() const { return !this->role.empty(); }
};

/**
 * @param property  the property that names the array, for the error message
 * @param name      the array's name; "None" means no array, unless a block has an array of that
 *                  name
 * @throws std::invalid_argument if a block with faces lacks the array or has it with several
 * components
 */
ChosenArray chosenArray(
  const InputBlocks& blocks, const std::string& property, const std::string& name, bool isOfCells);

}

#endif
