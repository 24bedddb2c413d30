// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/InputBlocks.h"

#include "input/OuterSurface.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

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

void InputBlocks::hideGhosts()
{
  for (InputBlock& block : this->Blocks)
  {
    vtkUnsignedCharArray* present = block.surface->GetCellGhostArray();
    if (!present)
    {
      continue;
    }
    vtkNew<vtkUnsignedCharArray> flags;
    flags->DeepCopy(present);
    for (vtkIdType cell = 0; cell < flags->GetNumberOfValues(); ++cell)
    {
      const unsigned char flag = flags->GetValue(cell);
      const bool isGhost = (flag & vtkDataSetAttributes::DUPLICATECELL) != 0;
      flags->SetValue(cell, isGhost ? flag | vtkDataSetAttributes::HIDDENCELL : int{ flag });
    }
    block.withoutGhosts = vtkSmartPointer<vtkPolyData>::New();
    block.withoutGhosts->ShallowCopy(block.surface);
    block.withoutGhosts->GetCellData()->AddArray(flags);
    block.surface = block.withoutGhosts;
  }
}

std::vector<bool> InputBlocks::areGhosts() const
{
  std::vector<bool> areGhosts;
  if (std::none_of(this->begin(), this->end(),
        [](const InputBlock& block) { return block.surface->HasAnyGhostCells(); }))
  {
    return areGhosts;
  }
  for (const InputBlock& block : this->Blocks)
  {
    vtkUnsignedCharArray* flags = block.surface->GetCellGhostArray();
    for (vtkIdType cell = 0; cell < block.surface->GetNumberOfCells(); ++cell)
    {
      areGhosts.push_back(
        flags && (flags->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0);
    }
  }
  return areGhosts;
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
