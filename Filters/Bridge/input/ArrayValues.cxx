// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/ArrayValues.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>

namespace geodesic::bridge
{

ChosenArray chosenArray(
  const InputBlocks& blocks, const std::string& property, const std::string& name, bool isOfCells)
{
  const int kind = isOfCells ? vtkDataObject::CELL : vtkDataObject::POINT;
  const auto find = [&](const InputBlock& block)
  { return block.surface->GetAttributes(kind)->GetArray(name.c_str()); };
  const auto hasIt = [&](const InputBlock& block) { return find(block) != nullptr; };
  const bool isAnywhere = std::any_of(blocks.begin(), blocks.end(), hasIt);
  // ParaView gives the name None where the user chose no array.
  if (!isAnywhere && name == "None")
  {
    return {};
  }
  const std::string isNone =
    property + " \"" + name + "\" is not a " + (isOfCells ? "cell" : "point") + " array of ";
  if (!isAnywhere)
  {
    throw std::invalid_argument(isNone + "the input. Choose one of its arrays, or None.");
  }
  ChosenArray chosen{ property + " \"" + name + "\"", isOfCells, {} };
  for (const InputBlock& block : blocks)
  {
    const vtkIdType count = block.surface->GetNumberOfElements(kind);
    if (!block.hasFaces())
    {
      chosen.values.resize(chosen.values.size() + count, std::numeric_limits<double>::quiet_NaN());
    }
    else if (vtkDataArray* array = find(block))
    {
      appendValues(array, count, chosen.role, chosen.values);
    }
    else
    {
      throw std::invalid_argument(isNone + "block " + block.name +
        ", but other blocks have it. Give it to all blocks, or choose None.");
    }
  }
  return chosen;
}

}
