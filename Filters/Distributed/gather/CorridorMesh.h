// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_CorridorMesh_h
#define geodesic_distributed_CorridorMesh_h

#include "gather/Corridor.h"
#include "global/GlobalPoints.h"
#include "mesh/TriangleMesh.h"
#include "output/PathAttributes.h"
#include "solve/DistanceField.h"
#include "solve/SolveOptions.h"

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace geodesic::distributed
{

/** The mesh of a corridor, on which PathFinder works as on a whole surface. */
class CorridorMesh final : public bridge::PathAttributes
{
public:
  /** @param hasCost whether options() has the costs of the corridor's vertices */
  CorridorMesh(const Corridor& corridor, bool hasCost);

  const TriangleMesh& mesh() const override { return this->Mesh; }
  /** The global id of a vertex; -1 if the input has none. */
  vtkIdType idOf(Index vertex) const override { return this->vertex(vertex).id; }
  vtkIdType blockOf(Index) const override { return 0; }
  std::optional<Vector3> normalOf(Index vertex) const override;

  /**
   * The cost, the barriers, and the vertices that lack triangles of the surface. The options refer
   * to arrays of this object, which must outlive them.
   */
  SolveOptions options() const;
  const PatchVertex& vertex(Index vertex) const
  {
    return this->Vertices[this->Mesh.pointOfVertex(vertex)];
  }
  /**
   * Returns the mesh's number of a vertex.
   * @pre the corridor has the vertex
   */
  Index find(const GlobalVertex& vertex) const { return this->VertexOf.at(vertex); }
  /**
   * Converts points to points of this mesh.
   * @pre the corridor has the triangles of the points
   */
  std::vector<SurfacePoint> pointsOf(std::span<const GlobalPoint> points) const;

  /**
   * Makes the field from the distances that the corridor has now.
   * @pre the corridor's triangles are the same as when this was made
   */
  const DistanceField& fieldOf(const Corridor& corridor, StopReason reason);

private:
  std::vector<PatchVertex> Vertices;
  TriangleMesh Mesh;
  std::unordered_map<GlobalVertex, Index, HashOfVertex> VertexOf;
  std::vector<double> Cost;
  std::vector<std::uint8_t> Excluded;
  std::vector<std::uint8_t> Incomplete;
  std::vector<std::uint8_t> Closed;
  DistanceField Field;
};

}

#endif
