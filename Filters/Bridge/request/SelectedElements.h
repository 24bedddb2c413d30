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

/** The points and cells of an input that a selection selects. */
struct SelectedElements
{
  SelectedElements(vtkSelection* selection, vtkDataObject* input, const InputBlocks& blocks);

  /** Whether the selection is empty, whatever the input is. */
  bool isEmpty = true;
  /** One flag for each point of the blocks' surfaces. */
  std::vector<std::uint8_t> points;
  /** One flag for each cell of the blocks' surfaces. */
  std::vector<std::uint8_t> cells;
};

}

#endif
