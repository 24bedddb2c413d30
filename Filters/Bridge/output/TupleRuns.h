// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_TupleRuns_h
#define geodesic_bridge_TupleRuns_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkAbstractArray;
class vtkDataSetAttributes;

namespace geodesic::bridge
{

/** Which tuples of an input an output has, in its order, as runs of consecutive ones. */
class TupleRuns
{
public:
  /** Adds the tuples @p first to @p first + @p count - 1. */
  void add(vtkIdType first, vtkIdType count);
  /** The number of tuples. */
  vtkIdType size() const { return this->Size; }
  /** Writes the number of each tuple in the input. */
  void writeSources(vtkIdType* sources) const;

  /** Returns the array's tuples, with room for more at the end. */
  vtkSmartPointer<vtkAbstractArray> copied(vtkAbstractArray* input, vtkIdType more) const;
  /** Replaces the output's arrays by those of the input, as copied(), as the same attributes. */
  void copyArrays(vtkDataSetAttributes& input, vtkDataSetAttributes& output, vtkIdType more) const;

private:
  struct Run
  {
    vtkIdType first;
    vtkIdType count;
  };

  std::vector<Run> Runs;
  vtkIdType Size = 0;
};

}

#endif
