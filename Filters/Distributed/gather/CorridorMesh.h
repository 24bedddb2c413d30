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
#include <map>
#include <span>
#include <vector>

namespace geodesic::distributed
{

/** The mesh of a corridor, for the algorithms that find paths on a whole surface. */
class CorridorMesh final : public bridge::PathAttributes
{
public:
  /** @param hasCost whether costs count */
  CorridorMesh(const Corridor& corridor, bool hasCost);

  const TriangleMesh& mesh() const override { return this->Mesh; }
  /** Global ids; -1 where there are none. */
  vtkIdType idOf(Index vertex) const override { return this->vertex(vertex).id; }
  vtkIdType blockOf(Index) const override { return 0; }
  std::optional<Vector3> normalOf(Index vertex) const override;

  /** Costs and barriers, and where the corridor ends; all live as long as this. */
  SolveOptions options() const;
  const PatchVertex& vertex(Index vertex) const
  {
    return this->Vertices[this->Mesh.pointOfVertex(vertex)];
  }
  /** @pre the corridor has the vertex */
  Index find(const GlobalVertex& vertex) const { return this->VertexOf.at(vertex); }
  /** Points whose triangles the corridor has. */
  std::vector<SurfacePoint> pointsOf(std::span<const GlobalPoint> points) const;

  /** The field by the distances that the corridor has now; its triangles must be the same. */
  const DistanceField& fieldOf(const Corridor& corridor, StopReason reason);

private:
  std::vector<PatchVertex> Vertices;
  TriangleMesh Mesh;
  std::map<GlobalVertex, Index> VertexOf;
  std::vector<double> Cost;
  std::vector<std::uint8_t> Excluded;
  std::vector<std::uint8_t> Incomplete;
  std::vector<std::uint8_t> Closed;
  DistanceField Field;
};

}

#endif
