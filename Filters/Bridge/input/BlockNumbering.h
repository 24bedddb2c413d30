// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_BlockNumbering_h
#define geodesic_bridge_BlockNumbering_h

#include "base/Index.h"
#include "input/InputBlocks.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace geodesic::bridge
{

/**
 * Numbers the points and cells of all blocks of an input consecutively, and converts between these
 * numbers and the point ids that users give and read.
 *
 * The users' ids are the data set's own point ids or, with several blocks or ranks, global point
 * ids. This object stays valid when the input is gone.
 */
class BlockNumbering
{
public:
  /** @param rank the rank that has these blocks, if the input is spread over several ranks */
  explicit BlockNumbering(const InputBlocks& blocks, std::optional<int> rank = {});

  std::size_t numberOfBlocks() const { return this->Blocks.size(); }
  Index firstPointOf(std::size_t block) const { return this->Blocks[block].firstPoint; }
  Index firstCellOf(std::size_t block) const { return this->Blocks[block].firstCell; }
  /** The number of the block that contains a point. Time O(log blocks). */
  std::size_t blockOfPoint(Index point) const;
  /** Whether a point's id identifies the point without its block. */
  bool hasUniqueIds() const { return this->UniqueIds; }
  /** The id of a point, within its block if ids are not unique; -1 for a point that VTK made. */
  vtkIdType idOfPoint(Index point) const;
  /** VTK's flat index of the data set that contains a point. */
  unsigned int flatIndexOf(Index point) const;
  /** See DataSetLeaf::block. */
  unsigned int blockNumberOf(Index point) const;
  /** The name of a point in messages: its id, with block and rank if the id is not unique. */
  std::string nameOfPoint(Index point) const;
  /**
   * Returns the points with the given ids: a list for each id, empty if no point has it.
   * @pre hasUniqueIds()
   */
  std::vector<std::vector<Index>> pointsWithIds(std::span<const vtkIdType> ids) const;
  /** The number of ids, which count from 0; 0 if ids are global. */
  vtkIdType numberOfIds() const { return this->NumberOfIds; }

private:
  struct Block
  {
    Index firstPoint;
    Index firstCell;
    Index numberOfPoints;
    unsigned int flatIndex;
    unsigned int number;
    std::string name;
    /** Null if the ids count from 0. */
    vtkSmartPointer<vtkDataArray> ids;
    std::shared_ptr<vtkPolyData> outerSurface;
  };

  std::vector<Block> Blocks;
  std::optional<int> Rank;
  bool UniqueIds = true;
  vtkIdType NumberOfIds = 0;
};

}

#endif
