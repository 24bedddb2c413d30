// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataSetLeaves.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkSmartPointer.h"

namespace geodesic::bridge
{
namespace
{

std::string nameOf(vtkCompositeDataIterator* block)
{
  const char* name = block->HasCurrentMetaData()
    ? block->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
    : nullptr;
  return name ? "\"" + std::string(name) + "\"" : std::to_string(block->GetCurrentFlatIndex());
}

}

std::vector<DataSetLeaf> leavesOf(vtkDataObject* object)
{
  std::vector<DataSetLeaf> leaves;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    const auto block = vtk::TakeSmartPointer(composite->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      if (auto* data = vtkDataSet::SafeDownCast(block->GetCurrentDataObject()))
      {
        leaves.push_back({ data, block->GetCurrentFlatIndex(), nameOf(block) });
      }
    }
  }
  else if (auto* data = vtkDataSet::SafeDownCast(object))
  {
    leaves.push_back({ data, 0, {} });
  }
  return leaves;
}

}
