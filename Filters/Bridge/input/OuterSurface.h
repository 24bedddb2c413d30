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
 * The outer surface of a grid or an image, as VTK extracts it, with the data set's arrays and two
 * more, vtkOriginalPointIds (-1: made by VTK in a curved face) and vtkOriginalCellIds. It is
 * extracted now unless somebody still holds it from the data set as it is, or a shallow copy.
 */
std::shared_ptr<vtkPolyData> outerSurfaceOf(vtkDataSet* data);

}

#endif
