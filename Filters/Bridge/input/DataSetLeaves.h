// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_DataSetLeaves_h
#define geodesic_bridge_DataSetLeaves_h

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace geodesic::bridge
{

/** A data set in a data object. */
struct DataSetLeaf
{
  vtkDataSet* data;
  /** Its number in the composite data set as VTK counts them; 0 for the data object itself. */
  unsigned int flatIndex = 0;
  /** Of its block: the partitions of one partitioned data set, on all ranks, are one block. */
  unsigned int block = 0;
  /** For messages: its name in quotes, or its number; empty for the data object itself. */
  std::string name;
};

/**
 * The data object itself, or the leaves of a composite one in their order, without empty places and
 * what is no data set.
 */
std::vector<DataSetLeaf> leavesOf(vtkDataObject* object);

}

#endif
