// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_OuterSurface_h
#define geodesic_bridge_OuterSurface_h

#include <memory>

class vtkDataSet;
class vtkPolyData;

namespace geodesic::bridge
{

/**
 * Returns the outer surface of a grid or an image, as VTK extracts it. The surface has the data
 * set's arrays and two more: vtkOriginalPointIds, which is -1 for points that VTK made on a curved
 * face, and vtkOriginalCellIds. It is extracted now, unless somebody still holds the surface of
 * this unchanged data set or of a shallow copy.
 */
std::shared_ptr<vtkPolyData> outerSurfaceOf(vtkDataSet* data);

}

#endif
