// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SurfaceNormals_h
#define geodesic_bridge_SurfaceNormals_h

#include "path/PathPoint.h"

#include <functional>
#include <optional>

class vtkDataArray;

namespace geodesic::bridge
{

/** Normals of length 1 at points of a surface. */
class SurfaceNormals
{
public:
  /** The input's normal at a vertex, of any length; none where it has none. */
  using InputNormal = std::function<std::optional<Vector3>(Index vertex)>;

  /**
   * @param mesh        must live as long as this
   * @param inputNormal where it gives none, normals are those of the faces round each vertex,
   *                    weighted by area
   */
  SurfaceNormals(const TriangleMesh& mesh, InputNormal inputNormal)
    : Mesh(mesh)
    , OfInput(std::move(inputNormal))
  {
  }

  /** @param inputNormals by point, or null: none */
  SurfaceNormals(const TriangleMesh& mesh, vtkDataArray* inputNormals);

  /** Between vertices theirs, interpolated. */
  Vector3 at(const PathPoint& point) const;

private:
  Vector3 atVertex(Index vertex) const;

  const TriangleMesh& Mesh;
  InputNormal OfInput;
};

}

#endif
