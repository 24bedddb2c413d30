// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PathOutput_h
#define geodesic_bridge_PathOutput_h

#include "output/PathAttributes.h"
#include "path/PathPoint.h"

#include "vtkNew.h"
#include "vtkType.h"

class vtkCellArray;
class vtkDoubleArray;
class vtkIdTypeArray;
class vtkPoints;
class vtkPolyData;

namespace geodesic::bridge
{

/**
 * Collects paths as polylines with these arrays.
 *
 * Point arrays:
 * - ArcLength, the scalars: the length from the beginning of the path, or of the chain of paths.
 * - OriginalPointIds: the id of the nearest input point that carries the path's point.
 * - EdgePointIds: the ids of the two ends of the point's edge, nearest first; at a vertex twice the
 *   same id; inside a face the two nearest corners.
 * - OriginalBlocks and EdgeBlocks, if ids do not identify a point without its block: the flat
 *   indices of the blocks of these points in the composite data set.
 * - Normals: of length 1.
 *
 * Cell arrays: Segment and Length. Field array: TotalLength.
 */
class PathOutput
{
public:
  /**
   * @param heightOffset the length by which paths are raised along the normals, in the mesh's unit
   * @param namesBlocks whether to write OriginalBlocks and EdgeBlocks
   */
  PathOutput(double heightOffset, bool namesBlocks);
  ~PathOutput();

  /**
   * @param attributes the mesh that the path runs on, and the attributes of the input
   * @param segment    the path's number, for the array Segment
   * @param arcLength  the value of ArcLength at the path's first point
   * @return the path's length on the surface, without the offset
   */
  double add(
    const PathAttributes& attributes, const SurfacePath& path, vtkIdType segment, double arcLength);
  void writeTo(vtkPolyData* output) const;
  double totalLength() const { return this->TotalLength; }

private:
  double HeightOffset;
  bool NamesBlocks;
  double TotalLength = 0.0;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkDoubleArray> ArcLengths;
  vtkNew<vtkIdTypeArray> OriginalPointIds;
  vtkNew<vtkIdTypeArray> EdgePointIds;
  vtkNew<vtkIdTypeArray> OriginalBlocks;
  vtkNew<vtkIdTypeArray> EdgeBlocks;
  vtkNew<vtkDoubleArray> Normals;
  vtkNew<vtkIdTypeArray> Segments;
  vtkNew<vtkDoubleArray> Lengths;
};

}

#endif
