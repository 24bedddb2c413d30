// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/InputBlocks.h"

#include "input/OuterSurface.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace geodesic::bridge
{
InputBlock::InputBlock(DataSetLeaf leaf)
  : DataSetLeaf(std::move(leaf))
  , surface(vtkPolyData::SafeDownCast(this->data))
{
  if (!this->surface)
  {
    this->outerSurface = outerSurfaceOf(this->data);
    this->surface = this->outerSurface.get();
  }
}

bool InputBlock::hasFaces() const
{
  return this->surface->GetNumberOfPolys() + this->surface->GetNumberOfStrips() > 0;
}

vtkDataArray* InputBlock::globalPointIds() const
{
  vtkPointData* pointData = this->surface->GetPointData();
  vtkDataArray* ids = pointData->GetGlobalIds();
  // Scripts, and file formats without attributes, give the ids as an ordinary array of this name.
  return ids ? ids : pointData->GetArray("GlobalPointIds");
}

InputBlocks::InputBlocks(vtkDataObject* input)
{
  for (DataSetLeaf& leaf : leavesOf(input))
  {
    this->Blocks.emplace_back(std::move(leaf));
  }
}

void InputBlocks::setOuterSurfaces(const std::vector<std::shared_ptr<vtkPolyData>>& surfaces)
{
  auto next = surfaces.begin();
  for (InputBlock& block : this->Blocks)
  {
    if (block.outerSurface)
    {
      block.outerSurface = *next++;
      block.surface = block.outerSurface.get();
    }
  }
}

std::size_t InputBlocks::numberWithFaces() const
{
  return static_cast<std::size_t>(std::count_if(
    this->begin(), this->end(), [](const InputBlock& block) { return block.hasFaces(); }));
}

bool InputBlocks::haveGlobalPointIds() const
{
  return std::all_of(this->begin(), this->end(),
    [](const InputBlock& block) { return !block.hasFaces() || block.globalPointIds(); });
}

}
