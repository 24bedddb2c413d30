// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SurfaceNormals_h
#define geodesic_bridge_SurfaceNormals_h

#include "PathPoint.h"

class vtkDataArray;

namespace geodesic::bridge
{

/** Normals of length 1 at points of a surface. */
class SurfaceNormals
{
public:
  /**
   * @param normals the input's point normals of any length, or null: then they are those of the
   *                faces round each vertex, weighted by area. Both must live as long as this.
   */
  SurfaceNormals(const TriangleMesh& mesh, vtkDataArray* normals)
    : Mesh(mesh)
    , InputNormals(normals)
  {
  }

  /** Between vertices theirs, interpolated. */
  Vector3 at(const PathPoint& point) const;

private:
  Vector3 atVertex(Index vertex) const;

  const TriangleMesh& Mesh;
  vtkDataArray* InputNormals;
};

}

#endif
