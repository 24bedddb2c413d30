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
 * Numbers the points and cells of all blocks of an input one after the other, and knows them by the
 * ids that users know: of a data set its own, of several blocks and on several ranks their global
 * point ids. Lives longer than the input.
 */
class BlockNumbering
{
public:
  /** @param rank that has these blocks of an input on several ranks */
  explicit BlockNumbering(const InputBlocks& blocks, std::optional<int> rank = {});

  std::size_t numberOfBlocks() const { return this->Blocks.size(); }
  Index firstPointOf(std::size_t block) const { return this->Blocks[block].firstPoint; }
  Index firstCellOf(std::size_t block) const { return this->Blocks[block].firstCell; }
  /** The block that has a point. Time O(log blocks). */
  std::size_t blockOfPoint(Index point) const;
  /** Whether an id tells a point without its block. */
  bool hasUniqueIds() const { return this->UniqueIds; }
  /** The id of a point, in its block where ids are not unique; -1 for one that VTK made. */
  vtkIdType idOfPoint(Index point) const;
  /** The number of a point's data set in the composite one. */
  unsigned int flatIndexOf(Index point) const;
  /** See DataSetLeaf::block. */
  unsigned int blockNumberOf(Index point) const;
  /** A point in a message: its id, and block and rank where they are needed. */
  std::string nameOfPoint(Index point) const;
  /**
   * The points that have ids, a list for each id, empty where there is none. Ids must be unique.
   */
  std::vector<std::vector<Index>> pointsWithIds(std::span<const vtkIdType> ids) const;
  /** How many ids there are, counted from 0; 0 where ids are global. */
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
    /** Null where the ids count from 0. */
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
