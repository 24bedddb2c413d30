// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_examples_DistanceColors_h
#define geodesic_examples_DistanceColors_h

#include "SurfaceWindow.h"

#include "vtkLookupTable.h"
#include "vtkScalarBarActor.h"

#include <vector>

class vtkDataArray;

namespace geodesic::examples
{

/** Shows distances on a surface in bands of colour, and a scalar bar. */
class DistanceColors
{
public:
  /** @param window must outlive this object */
  explicit DistanceColors(SurfaceWindow& window);

  /** @param distances one for each point; negative ones stay grey */
  void show(vtkDataArray* distances, double maximum);
  void markSeeds(const std::vector<vtkIdType>& pointIds);

private:
  SurfaceWindow& Window;
  vtkNew<vtkLookupTable> Table;
  vtkNew<vtkScalarBarActor> Bar;
  std::vector<vtkSmartPointer<vtkActor>> Marks;
};

}

#endif
