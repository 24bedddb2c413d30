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
  /** VTK's flat index in the composite data set; 0 if the data object is the data set. */
  unsigned int flatIndex = 0;
  /**
   * The number of its block. All partitions of one partitioned data set, on all ranks, are one
   * block.
   */
  unsigned int block = 0;
  /**
   * Its name in quotes, or its flat index, for messages; empty if the data object is the data set.
   */
  std::string name;
};

/**
 * Returns the data object if it is a data set, or the data sets in a composite one in their order.
 * Empty leaves and leaves of other types are left out.
 */
std::vector<DataSetLeaf> leavesOf(vtkDataObject* object);

}

#endif
