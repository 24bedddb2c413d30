// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef bridge_SegmentMeasures_h
#define bridge_SegmentMeasures_h

#include "vtkType.h"

class vtkDoubleArray;
class vtkPolyData;

namespace geodesic::bridge
{

/**
 * Measures the polylines of a PathOutput.
 * @param paths    with the cell arrays Segment and Length
 * @param count    the number of segments; some of them may have no polyline
 * @param lengths  gets a value for each segment, in mesh length units; -1 where it has no polyline
 * @param middles  gets x, y and z of the middle of each segment's polyline; 0 where it has none
 */
void measureSegments(
  vtkPolyData* paths, vtkIdType count, vtkDoubleArray* lengths, vtkDoubleArray* middles);

}

#endif
