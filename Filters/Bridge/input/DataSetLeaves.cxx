// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/DataSetLeaves.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkSmartPointer.h"

#include <map>

namespace geodesic::bridge
{
namespace
{

std::string nameOf(vtkCompositeDataIterator* block)
{
  const char* name = block->HasCurrentMetaData()
    ? block->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
    : nullptr;
  return name ? std::string("\"") + name + "\"" : std::to_string(block->GetCurrentFlatIndex());
}

/** Returns the number of the block that each data set of a tree belongs to. */
std::map<vtkDataObject*, unsigned int> blockNumbersOf(vtkDataObjectTree* tree)
{
  std::map<vtkDataObject*, unsigned int> numbers;
  unsigned int number = 0;
  auto* whole = vtkPartitionedDataSet::SafeDownCast(tree);
  unsigned int partitions = whole ? whole->GetNumberOfPartitions() : 0;
  const auto place = vtk::TakeSmartPointer(tree->NewTreeIterator());
  place->VisitOnlyLeavesOff();
  place->SkipEmptyNodesOff();
  for (place->InitTraversal(); !place->IsDoneWithTraversal(); place->GoToNextItem())
  {
    vtkDataObject* object = place->GetCurrentDataObject();
    if (partitions > 0)
    {
      --partitions;
    }
    else
    {
      ++number;
      auto* set = vtkPartitionedDataSet::SafeDownCast(object);
      partitions = set ? set->GetNumberOfPartitions() : 0;
    }
    numbers[object] = number;
  }
  return numbers;
}

}

std::vector<DataSetLeaf> leavesOf(vtkDataObject* object)
{
  std::vector<DataSetLeaf> leaves;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    auto* tree = vtkDataObjectTree::SafeDownCast(object);
    auto numbers = tree ? blockNumbersOf(tree) : std::map<vtkDataObject*, unsigned int>{};
    const auto block = vtk::TakeSmartPointer(composite->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      if (auto* data = vtkDataSet::SafeDownCast(block->GetCurrentDataObject()))
      {
        leaves.push_back({ data, block->GetCurrentFlatIndex(), numbers[data], nameOf(block) });
      }
    }
  }
  else if (auto* data = vtkDataSet::SafeDownCast(object))
  {
    leaves.push_back({ data, 0, 0, {} });
  }
  return leaves;
}

}
