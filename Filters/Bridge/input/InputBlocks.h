// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_InputBlocks_h
#define geodesic_bridge_InputBlocks_h

#include "input/DataSetLeaves.h"

#include "vtkSmartPointer.h"

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
  /** Owns the outer surface; null if the data set is its own surface. */
  std::shared_ptr<vtkPolyData> outerSurface;
  /** Owns the surface if its ghost cells were hidden; else null. */
  vtkSmartPointer<vtkPolyData> withoutGhosts;

  /** Whether the surface has polygons or strips. */
  bool hasFaces() const;
  /**
   * The array of global point ids, one component; null if the block has none. Points of different
   * blocks with the same id are the same point.
   */
  vtkDataArray* globalPointIds() const;
};

/**
 * The data sets of an input, in the order of leavesOf(). Points and cells are numbered
 * consecutively, block by block. The input must outlive this object, which serves one run of a
 * filter.
 */
class InputBlocks
{
public:
  explicit InputBlocks(vtkDataObject* input);

  std::size_t size() const { return this->Blocks.size(); }
  const InputBlock& operator[](std::size_t i) const { return this->Blocks[i]; }
  auto begin() const { return this->Blocks.begin(); }
  auto end() const { return this->Blocks.end(); }

  /** Replaces the outer surfaces, in their order. */
  void setOuterSurfaces(const std::vector<std::shared_ptr<vtkPolyData>>& surfaces);

  /** Hides the ghost cells, which are other ranks' cells. */
  void hideGhosts();
  /** For each cell of all blocks whether it is a ghost cell; empty if none is. */
  std::vector<bool> areGhosts() const;

  /** The number of blocks with faces. */
  std::size_t numberWithFaces() const;
  /** Whether all blocks with faces have global point ids. */
  bool haveGlobalPointIds() const;

private:
  std::vector<InputBlock> Blocks;
};

}

#endif
