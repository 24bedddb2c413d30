// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SurfaceNormals_h
#define geodesic_bridge_SurfaceNormals_h

#include "path/PathPoint.h"

#include <functional>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

class vtkDataArray;

namespace geodesic::bridge
{

/** Unit normals at points of a surface. Those of vertices are made as they are needed, by one
 * thread, and kept, as many paths go past the same ones; or all at once by makeAll(). */
class SurfaceNormals
{
public:
  /**
   * Returns the input's normal at a vertex, of any length, or none if the input has no normal
   * there.
   */
  using InputNormal = std::function<std::optional<Vector3>(Index vertex)>;

  /**
   * @param mesh        must outlive this object
   * @param inputNormal gives the input's normals; where it gives none, the normal of a vertex is
   *                    the mean of the normals of its faces, weighted by area
   */
  SurfaceNormals(const TriangleMesh& mesh, InputNormal inputNormal)
    : Mesh(mesh)
    , OfInput(std::move(inputNormal))
  {
  }

  /** @param inputNormals the input's normal at each point; null if it has none */
  SurfaceNormals(const TriangleMesh& mesh, vtkDataArray* inputNormals);

  /** Makes the normals of all vertices; then any number of threads may ask for normals. Time O(n).
   */
  void makeAll();

  /** The normal at a point; between vertices it is interpolated. */
  Vector3 at(const PathPoint& point);

private:
  const Vector3& atVertex(Index vertex);
  Vector3 makeAtVertex(Index vertex) const;

  const TriangleMesh& Mesh;
  InputNormal OfInput;
  std::unordered_map<Index, Vector3> Made;
  /** One for each vertex; empty until they are all made. */
  std::vector<Vector3> All;
};

}

#endif
