// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_InputSurface_h
#define geodesic_bridge_InputSurface_h

#include "base/ThreadTeam.h"
#include "input/BlockNumbering.h"
#include "input/PointIdentity.h"
#include "mesh/TriangleMesh.h"
#include "search/PointSearch.h"

#include <memory>
#include <vector>

namespace geodesic::bridge
{

class InputGeometry;

/**
 * The triangle mesh of an input, and the search for closest points on it. Both are built once for
 * an input's points and cells and shared by all filters and runs.
 */
class InputSurface
{
public:
  /**
   * Returns the surface of an input; it is built now unless some filter still holds it. The surface
   * is identified by the VTK objects that hold the points, the cells and, if they matter, the ids,
   * and by the modification times of these objects, and by the places and names of the blocks. So a
   * shallow copy of the input, and the same input with new arrays, find the same surface. Where the
   * cells are those of a surface that is still held, in the same objects or in others of the same
   * content, and only points have moved, the structure of that one is shared
   * (TriangleMesh::withPositions).
   * @param team the threads that build the surface
   * @throws std::invalid_argument if the input has no triangle, polygon or strip with an area,
   * unless it is one piece of several; also as TriangleMesh and kindsOfPoints()
   */
  static std::shared_ptr<const InputSurface> of(const InputBlocks& blocks,
    const PointIdentity& identity, const ThreadTeam& team = ThreadTeam());

  const std::shared_ptr<const TriangleMesh>& mesh() const { return this->Mesh; }
  const PointSearch& closestPoints() const { return *this->ClosestPoints; }
  /** The numbering of the mesh's points and of the cells of all blocks. */
  const BlockNumbering& numbering() const { return this->Numbering; }
  /** The cell that a triangle of the mesh was cut from. */
  Index cellOfTriangle(Index triangle) const;

private:
  /** The cell of each source triangle. */
  struct SourceCells
  {
    /** Empty if source triangle i is cell first + i. */
    std::vector<Index> cells;
    Index first = 0;
  };

  InputSurface(BlockNumbering numbering, std::shared_ptr<const TriangleMesh> mesh);
  static std::shared_ptr<const InputSurface> built(
    InputGeometry& geometry, const PointIdentity& identity, const ThreadTeam& team);
  /** @p held with its points where the input has them now; null where it has another structure.
   * @param hasSameCells whether its cells are known to be the same */
  static std::shared_ptr<const InputSurface> moved(const InputSurface& held, bool hasSameCells,
    InputGeometry& geometry, const PointIdentity& identity, const ThreadTeam& team);
  static std::shared_ptr<const SourceCells> sourceCellsOf(std::vector<Index> cells);

  BlockNumbering Numbering;
  std::shared_ptr<const SourceCells> Cells;
  bool IsCutByPositions = false;
  std::shared_ptr<const TriangleMesh> Mesh;
  std::unique_ptr<const PointSearch> ClosestPoints;
};

}

#endif
