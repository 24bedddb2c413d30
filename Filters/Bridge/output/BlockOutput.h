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
 * Makes an output that is the input with each data set's surface in its place: shallow copies, also
 * of field data and time.
 * @param output   a polydata, or a tree of the input's class
 * @param complete adds to the copy of a block's surface
 */
void writeBlocks(const InputBlocks& blocks, vtkDataObject* input, vtkDataObject* output,
  const std::function<void(std::size_t block, vtkPolyData* surface)>& complete);

}

#endif
