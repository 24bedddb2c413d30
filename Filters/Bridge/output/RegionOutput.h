// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_RegionOutput_h
#define geodesic_bridge_RegionOutput_h

#include "input/InputBlocks.h"
#include "input/InputSurface.h"
#include "split/RegionCut.h"

#include "vtkType.h"

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

class vtkPolyData;

namespace geodesic::bridge
{

/**
 * Writes the blocks of a surface that is cut into regions. Cells that no line cuts stay as they
 * are, polygons and strips too; the others become triangles, in their place, of a strip after all
 * polygons. Arrays of the cells are copied. New points come last; where the faces beside an edge
 * share their points, they share the new ones, and where they don't, as at a seam of texture
 * coordinates, each has its own.
 *
 * At a new point arrays of real numbers are interpolated between the corners of its edge or face,
 * normals and tangents made of length 1 again; other arrays have the value of the nearest corner.
 * Global ids of new points are the same in all blocks.
 */
class RegionOutput
{
public:
  /**
   * @param kept       one flag for each region: whether the output has its cells
   * @param keepsAll   whether the output also has cells that are no faces (lines, hidden cells),
   *                   and points of no kept cell
   * @param arrayName  of the regions' numbers; empty for no array
   * @param newIds     the global ids of the cut's new points; empty if the input has no such ids
   */
  RegionOutput(const InputBlocks& blocks, const InputSurface& surface, const RegionCut& cut,
    std::vector<bool> kept, bool keepsAll, std::string arrayName, std::vector<vtkIdType> newIds);

  /** Replaces the points and cells of a block's copy, and their arrays. */
  void complete(std::size_t block, vtkPolyData* output) const;

private:
  /** A triangle of a cell that is cut, or a part of one. */
  struct Part
  {
    Index cell;
    Index region;
    Triangle corners;

    friend bool operator<(const Part& a, const Part& b) { return a.cell < b.cell; }
  };
  class Block;

  void findRegions();
  void collectParts();
  bool isCut(Index cell) const { return this->RegionOfCell[cell] == Cut; }

  static constexpr Index Cut = NoIndex - 1;

  const InputBlocks& Blocks;
  const InputSurface& Surface;
  const RegionCut& Regions;
  std::vector<bool> Kept;
  bool KeepsAll;
  std::string ArrayName;
  /** For each cell of all blocks its region, Cut, or NoIndex for what is no face. */
  std::vector<Index> RegionOfCell;
  /** Of the cells that are cut, sorted by cell. */
  std::vector<Part> Parts;
  std::vector<vtkIdType> NewIds;
};

}

#endif
