// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_BlockOutput_h
#define geodesic_bridge_BlockOutput_h

#include "input/InputBlocks.h"

#include <cstddef>
#include <functional>

class vtkDataObject;
class vtkPolyData;

namespace geodesic::bridge
{

/**
 * Fills the output with shallow copies of the blocks' surfaces, in the structure of the input. Each
 * copy has the field data and the time of its data set.
 * @param output   a vtkPolyData, or a vtkDataObjectTree of the input's class
 * @param complete called with the copy of each block's surface, to add arrays to it
 */
void writeBlocks(const InputBlocks& blocks, vtkDataObject* input, vtkDataObject* output,
  const std::function<void(std::size_t block, vtkPolyData* surface)>& complete);

}

#endif
