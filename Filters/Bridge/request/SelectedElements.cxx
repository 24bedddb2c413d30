// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "request/SelectedElements.h"

#include "input/ArrayValues.h"

#include "vtkDataSetAttributes.h"
#include "vtkExtractSelection.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <map>

namespace geodesic::bridge
{
namespace
{

bool namesNothing(vtkSelection* selection)
{
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    vtkAbstractArray* list = node->GetSelectionList();
    const bool isList = node->GetContentType() != vtkSelectionNode::QUERY &&
      node->GetContentType() != vtkSelectionNode::USER;
    if (!isList || (list && list->GetNumberOfTuples() > 0))
    {
      return false;
    }
  }
  return true;
}

/** Returns the flags of a data set's own points or cells; empty if none is selected. */
std::vector<std::uint8_t> flagsOf(vtkDataSet* data, int kind)
{
  std::vector<std::uint8_t> flags;
  if (vtkDataArray* array = data->GetAttributes(kind)->GetArray("vtkInsidedness"))
  {
    appendValues(array, data->GetNumberOfElements(kind), "vtkInsidedness", flags);
  }
  return flags;
}

/**
 * Appends the flags of a block's surface.
 * @param flags     flags of the data set's own points or cells; empty if none is set
 * @param original  name of the surface's array that has the ids of the data set's points or cells
 */
void appendFlags(const InputBlock& block, int kind, const std::vector<std::uint8_t>& flags,
  const char* original, std::vector<std::uint8_t>& all)
{
  const vtkIdType count = block.surface->GetNumberOfElements(kind);
  if (flags.empty())
  {
    all.resize(all.size() + count, 0);
    return;
  }
  if (!block.outerSurface)
  {
    all.insert(all.end(), flags.begin(), flags.end());
    return;
  }
  std::vector<vtkIdType> ids;
  appendValues(block.surface->GetAttributes(kind)->GetArray(original), count, original, ids);
  for (const vtkIdType id : ids)
  {
    all.push_back(id < 0 ? 0 : flags[id]);
  }
}

}

SelectedElements::SelectedElements(
  vtkSelection* selection, vtkDataObject* input, const InputBlocks& blocks)
  : isEmpty(namesNothing(selection))
{
  vtkNew<vtkExtractSelection> extract;
  extract->PreserveTopologyOn();
  extract->SetInputDataObject(0, input);
  extract->SetInputDataObject(1, selection);
  extract->Update();
  std::map<unsigned int, vtkDataSet*> selected;
  for (const DataSetLeaf& leaf : leavesOf(extract->GetOutputDataObject(0)))
  {
    selected[leaf.flatIndex] = leaf.data;
  }
  for (const InputBlock& block : blocks)
  {
    const auto found = selected.find(block.flatIndex);
    const auto append = [&](int kind, const char* original, std::vector<std::uint8_t>& all)
    {
      const auto flags =
        found == selected.end() ? std::vector<std::uint8_t>{} : flagsOf(found->second, kind);
      appendFlags(block, kind, flags, original, all);
    };
    append(vtkDataObject::POINT, "vtkOriginalPointIds", this->points);
    append(vtkDataObject::CELL, "vtkOriginalCellIds", this->cells);
  }
}

}
