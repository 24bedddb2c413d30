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
 * What is built once for an input's points and cells and shared by every run of every filter on it:
 * the mesh, and on first use the structure that finds closest points.
 */
class InputSurface
{
public:
  /**
   * The surface of an input, built now unless some filter still holds it. It is known by the
   * objects that hold points and cells, and ids where they count, and by their modification times,
   * so new arrays on the same surface, or a shallow copy of it, find it again.
   * @param team threads to build it on
   * @throws std::invalid_argument where there is no triangle, polygon or strip, unless this is one
   * piece of several; and see TriangleMesh and kindsOfPoints
   */
  static std::shared_ptr<const InputSurface> of(const InputBlocks& blocks,
    const PointIdentity& identity, const ThreadTeam& team = ThreadTeam());

  InputSurface(const InputBlocks& blocks, const PointIdentity& identity, const ThreadTeam& team);

  const std::shared_ptr<const TriangleMesh>& mesh() const { return this->Mesh; }
  const ClosestPointTree& closestPoints() const;
  /** How the mesh's points and the cells of all blocks are numbered. */
  const BlockNumbering& numbering() const { return this->Numbering; }
  /** The cell that a triangle of the mesh was cut from. */
  Index cellOfTriangle(Index triangle) const;

private:
  BlockNumbering Numbering;
  /** By the source triangle; empty where the cells are the triangles, counted from FirstCell. */
  std::vector<Index> CellOfSource;
  Index FirstCell = 0;
  std::shared_ptr<const TriangleMesh> Mesh;
  mutable std::once_flag ClosestPointsBuilt;
  mutable std::unique_ptr<ClosestPointTree> ClosestPoints;
};

}

#endif
