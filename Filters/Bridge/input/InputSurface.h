// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_InputSurface_h
#define geodesic_bridge_InputSurface_h

#include "base/ThreadTeam.h"
#include "input/BlockNumbering.h"
#include "input/PointIdentity.h"
#include "mesh/TriangleMesh.h"
#include "search/ClosestPointTree.h"

#include <memory>
#include <mutex>
#include <vector>

namespace geodesic::bridge
{

/**
 * The triangle mesh of an input, and the search tree for closest points, which is built on first
 * use. Both are built once for an input's points and cells and shared by all filters and runs.
 */
class InputSurface
{
public:
  /**
   * Returns the surface of an input; it is built now unless some filter still holds it. The surface
   * is identified by the VTK objects that hold the points, the cells and, if they matter, the ids,
   * and by the modification times of these objects, and by the places and names of the blocks. So a
   * shallow copy of the input, and the same input with new arrays, find the same surface.
   * @param team the threads that build the surface
   * @throws std::invalid_argument if the input has no triangle, polygon or strip with an area,
   * unless it is one piece of several; also as TriangleMesh and kindsOfPoints()
   */
  static std::shared_ptr<const InputSurface> of(const InputBlocks& blocks,
    const PointIdentity& identity, const ThreadTeam& team = ThreadTeam());

  InputSurface(const InputBlocks& blocks, const PointIdentity& identity, const ThreadTeam& team);

  const std::shared_ptr<const TriangleMesh>& mesh() const { return this->Mesh; }
  const ClosestPointTree& closestPoints() const;
  /** The numbering of the mesh's points and of the cells of all blocks. */
  const BlockNumbering& numbering() const { return this->Numbering; }
  /** The cell that a triangle of the mesh was cut from. */
  Index cellOfTriangle(Index triangle) const;

private:
  BlockNumbering Numbering;
  /** The cell of each source triangle; empty if source triangle i is cell FirstCell + i. */
  std::vector<Index> CellOfSource;
  Index FirstCell = 0;
  std::shared_ptr<const TriangleMesh> Mesh;
  mutable std::once_flag ClosestPointsBuilt;
  mutable std::unique_ptr<ClosestPointTree> ClosestPoints;
};

}

#endif
