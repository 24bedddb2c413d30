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
 * Appends the values of an array of one component, whatever their type.
 * @param count  how many there must be
 * @param role   what the array is, for the message
 * @throws std::invalid_argument where the array has another shape
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

/** An array of the input that its user chose. */
struct ChosenArray
{
  /** The property and the name in quotes, for messages. */
  std::string role;
  bool isOfCells = false;
  /** One a point or cell of all blocks; NaN in blocks without faces. */
  std::vector<double> values;

  /** Whether one is chosen. */
  explicit operator bool() const { return !this->role.empty(); }
};

/**
 * @param property  who asks for the array
 * @param name      of the array; "None" and no such array in any block: none is chosen
 * @throws std::invalid_argument where blocks with faces do not have it, or not with one component
 */
ChosenArray chosenArray(
  const InputBlocks& blocks, const std::string& property, const std::string& name, bool isOfCells);

}

#endif
