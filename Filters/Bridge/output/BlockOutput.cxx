// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/BlockOutput.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace geodesic::bridge
{
namespace
{

void copyBlock(const InputBlock& block, vtkDataObject* output)
{
  output->ShallowCopy(block.surface);
  // The outer surface may have been extracted in an earlier run, for another time.
  output->GetInformation()->CopyEntry(
    block.data->GetInformation(), vtkDataObject::DATA_TIME_STEP());
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(block.data->GetFieldData());
  output->SetFieldData(fields);
}

}

void writeBlocks(const InputBlocks& blocks, vtkDataObject* input, vtkDataObject* output,
  const std::function<void(std::size_t block, vtkPolyData* surface)>& complete)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(output);
  if (!tree)
  {
    copyBlock(blocks[0], output);
    complete(0, vtkPolyData::SafeDownCast(output));
    return;
  }
  tree->ShallowCopy(input);
  std::size_t block = 0;
  const auto place = vtk::TakeSmartPointer(tree->NewTreeIterator());
  for (place->InitTraversal(); !place->IsDoneWithTraversal(); place->GoToNextItem())
  {
    if (vtkDataSet::SafeDownCast(place->GetCurrentDataObject()))
    {
      vtkNew<vtkPolyData> surface;
      copyBlock(blocks[block], surface);
      complete(block, surface);
      tree->SetDataSet(place, surface);
      ++block;
    }
  }
}

}
