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
 * Of points: ArcLength (the scalars; from the beginning of the path, or of the chain of paths),
 * OriginalPointIds (the nearest of the input's points that carry the path's), EdgePointIds (the two
 * ends of the edge, nearest first; at a vertex twice the same; inside a face the two nearest
 * corners), Normals (of length 1); where ids do not tell of which block the points are, also
 * OriginalBlocks and EdgeBlocks, their blocks' numbers in the composite data set. Of cells:
 * Segment, Length. Of the field: TotalLength.
 */
class PathOutput
{
public:
  /** @param namesBlocks whether ids do not tell of which block points are */
  PathOutput(double heightOffset, bool namesBlocks);
  ~PathOutput();

  /**
   * @param attributes the mesh that the path runs on, and what the input says of it
   * @param segment    its number
   * @param arcLength  at its first point
   * @return its length on the surface, before the offset
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
