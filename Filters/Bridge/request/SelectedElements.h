// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SelectedElements_h
#define geodesic_bridge_SelectedElements_h

#include "input/InputBlocks.h"

#include <cstdint>
#include <vector>

class vtkDataObject;
class vtkSelection;

namespace geodesic::bridge
{

/** What a selection selects of an input. */
struct SelectedElements
{
  SelectedElements(vtkSelection* selection, vtkDataObject* input, const InputBlocks& blocks);

  /** Whether the selection names nothing at all. */
  bool isEmpty = true;
  /** One flag a point of the blocks' surfaces. */
  std::vector<std::uint8_t> points;
  /** One flag a cell of the blocks' surfaces. */
  std::vector<std::uint8_t> cells;
};

}

#endif
