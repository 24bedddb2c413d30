// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/BlockNumbering.h"

#include "input/ArrayValues.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <algorithm>
#include <map>

namespace geodesic::bridge
{

BlockNumbering::BlockNumbering(const InputBlocks& blocks, std::optional<int> rank)
  : Rank(rank)
{
  const bool hasSeveral = blocks.numberWithFaces() > 1;
  const bool hasGlobalIds = (hasSeveral || rank) && blocks.haveGlobalPointIds();
  this->UniqueIds = hasGlobalIds || !(hasSeveral || rank);
  Index firstPoint = 0;
  Index firstCell = 0;
  for (const InputBlock& block : blocks)
  {
    const auto points = static_cast<Index>(block.surface->GetNumberOfPoints());
    vtkDataArray* own = block.surface->GetPointData()->GetArray("vtkOriginalPointIds");
    vtkDataArray* ids =
      hasGlobalIds ? block.globalPointIds() : (block.outerSurface ? own : nullptr);
    this->Blocks.push_back({ firstPoint, firstCell, points, block.flatIndex, block.block,
      block.name, ids, block.outerSurface });
    if (!hasSeveral && block.hasFaces())
    {
      this->NumberOfIds = block.data->GetNumberOfPoints();
    }
    firstPoint += points;
    firstCell += static_cast<Index>(block.surface->GetNumberOfCells());
  }
}

std::size_t BlockNumbering::blockOfPoint(Index point) const
{
  const auto next = std::upper_bound(this->Blocks.begin(), this->Blocks.end(), point,
    [](Index p, const Block& block) { return p < block.firstPoint; });
  return static_cast<std::size_t>(next - this->Blocks.begin()) - 1;
}

vtkIdType BlockNumbering::idOfPoint(Index point) const
{
  const Block& block = this->Blocks[this->blockOfPoint(point)];
  const Index own = point - block.firstPoint;
  // GetComponent() would make it a double, which does not hold all ids.
  return block.ids ? static_cast<vtkIdType>(block.ids->GetVariantValue(own).ToTypeInt64()) : own;
}

unsigned int BlockNumbering::flatIndexOf(Index point) const
{
  return this->Blocks[this->blockOfPoint(point)].flatIndex;
}

unsigned int BlockNumbering::blockNumberOf(Index point) const
{
  return this->Blocks[this->blockOfPoint(point)].number;
}

std::string BlockNumbering::nameOfPoint(Index point) const
{
  const Block& block = this->Blocks[this->blockOfPoint(point)];
  std::string name = "point " + std::to_string(this->idOfPoint(point));
  if (!this->UniqueIds && !block.name.empty())
  {
    name += " of block " + block.name;
  }
  if (!this->UniqueIds && this->Rank)
  {
    name += " on rank " + std::to_string(*this->Rank);
  }
  return name;
}

std::vector<std::vector<Index>> BlockNumbering::pointsWithIds(std::span<const vtkIdType> ids) const
{
  std::multimap<vtkIdType, std::size_t> wanted;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    wanted.emplace(ids[i], i);
  }
  std::vector<std::vector<Index>> points(ids.size());
  const auto note = [&](vtkIdType id, Index point)
  {
    const auto [first, last] = wanted.equal_range(id);
    std::for_each(first, last, [&](const auto& entry) { points[entry.second].push_back(point); });
  };
  for (const Block& block : this->Blocks)
  {
    if (block.ids)
    {
      std::vector<vtkIdType> own;
      if (!wanted.empty())
      {
        appendValues(block.ids, block.numberOfPoints, "GlobalPointIds", own);
      }
      for (std::size_t i = 0; i < own.size(); ++i)
      {
        note(own[i], block.firstPoint + static_cast<Index>(i));
      }
      continue;
    }
    for (const auto& entry : wanted)
    {
      if (entry.first >= 0 && entry.first < block.numberOfPoints)
      {
        points[entry.second].push_back(block.firstPoint + static_cast<Index>(entry.first));
      }
    }
  }
  return points;
}

}
