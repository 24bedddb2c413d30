// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PathOutput_h
#define geodesic_bridge_PathOutput_h

#include "base/ThreadTeam.h"
#include "output/PathAttributes.h"
#include "output/SurfaceNormals.h"
#include "path/PathPoint.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <vector>

class vtkDoubleArray;
class vtkIdTypeArray;
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

  /** From now on only the beginnings of paths are added, see beginningOf(). */
  void limitLength(double maximumLength, bool cutsEdges);
  /**
   * Adds a path; this and the attributes must live as long as this object.
   * @param attributes the mesh that the path runs on, and the attributes of the input
   * @param segment    the path's number, for the array Segment
   */
  void add(const PathAttributes& attributes, const SurfacePath& path, vtkIdType segment);
  /**
   * Writes all paths.
   * @param isChain whether ArcLength goes on from each path to the next one
   * @param team    threads to work on
   * @return false, with an empty output, if the filter was aborted
   */
  bool writeTo(vtkPolyData* output, bool isChain, const ThreadTeam& team);
  /** The length of all paths on the surface, without the offset, once they are written. */
  double totalLength() const { return this->TotalLength; }

private:
  struct LengthLimit
  {
    double maximumLength;
    bool cutsEdges;
  };
  struct Line
  {
    const PathAttributes& attributes;
    const SurfacePath& path;
    /** The place of its first point among those of all lines. */
    std::size_t start;

    /** A polyline needs at least two points. */
    std::size_t size() const { return this->path.size() < 2 ? 2 : this->path.size(); }
  };

  void allocate();
  void writePoints(const ThreadTeam& team);
  /** Writes all that belongs to the points of a line. @return its length */
  double write(const Line& line, SurfaceNormals& normals);
  using NormalsOfMesh = std::map<const PathAttributes*, SurfaceNormals>;
  /** Normals at all vertices of the meshes on which lines have many points. */
  NormalsOfMesh normalsOfMany() const;
  void addLengths(bool isChain);

  double HeightOffset;
  bool NamesBlocks;
  double TotalLength = 0.0;
  std::optional<LengthLimit> Limit;
  /** Of the paths, where there is a limit; they stay where they are. */
  std::deque<SurfacePath> Beginnings;
  std::vector<Line> Lines;
  std::size_t Size = 0;
  vtkNew<vtkDoubleArray> Positions;
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
