// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_InputBlocks_h
#define geodesic_bridge_InputBlocks_h

#include "input/DataSetLeaves.h"

#include <memory>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace geodesic::bridge
{

/** One data set of an input. */
struct InputBlock : DataSetLeaf
{
  explicit InputBlock(DataSetLeaf leaf);

  /** The data set itself, or its outer surface. */
  vtkPolyData* surface;
  /** What holds the outer surface; null where the data set is its own surface. */
  std::shared_ptr<vtkPolyData> outerSurface;

  /** Whether it has polygons or strips. */
  bool hasFaces() const;
  /** What makes points of different blocks one, one component; null where there is no such array.
   */
  vtkDataArray* globalPointIds() const;
};

/**
 * The data sets of an input, by leavesOf. Points and cells of all together are numbered block by
 * block. Borrows the input for one run of a filter.
 */
class InputBlocks
{
public:
  explicit InputBlocks(vtkDataObject* input);

  std::size_t size() const { return this->Blocks.size(); }
  const InputBlock& operator[](std::size_t i) const { return this->Blocks[i]; }
  auto begin() const { return this->Blocks.begin(); }
  auto end() const { return this->Blocks.end(); }

  /** Puts others in the place of the outer surfaces, in their order. */
  void setOuterSurfaces(const std::vector<std::shared_ptr<vtkPolyData>>& surfaces);

  /** How many have faces. */
  std::size_t numberWithFaces() const;
  /** Whether all that have faces have global point ids. */
  bool haveGlobalPointIds() const;

private:
  std::vector<InputBlock> Blocks;
};

}

#endif
