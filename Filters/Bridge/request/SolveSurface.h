// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SolveSurface_h
#define geodesic_bridge_SolveSurface_h

#include "path/PathPoint.h"
#include "request/CostAndBarriers.h"
#include "request/SurfaceLines.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <memory>
#include <string>
#include <vector>

namespace geodesic::bridge
{

/**
 * The mesh that a request is solved on, and the request's cost, barriers and seeds on that mesh.
 * The mesh is the input's own, or a copy that is split along the lines of seeds and barriers.
 * Points and paths of the input's own mesh are called base points and base paths.
 */
class SolveSurface
{
public:
  /**
   * @param mesh       the input's mesh; on several ranks it can have more points of other ranks
   *                   after the input's
   * @param alongEdges whether paths run along edges only; then the points that the splitting made
   *                   on barriers are excluded as well
   */
  SolveSurface(std::shared_ptr<const InputSurface> base,
    const std::shared_ptr<const TriangleMesh>& mesh, const SurfaceLines& lines,
    const Barriers& barriers, const std::vector<double>& cost, bool alongEdges);

  const std::shared_ptr<const TriangleMesh>& mesh() const { return this->Mesh; }
  /** Null if the mesh is not split. */
  const SplitMesh* split() const { return this->Split.get(); }
  /** One flag for each vertex, or empty. The caller adds the vertices that other ranks exclude. */
  std::vector<std::uint8_t>& excluded() { return this->Excluded; }
  /**
   * The cost and the barriers. The options refer to arrays of this object, which must outlive them.
   */
  SolveOptions options() const;

  /** Returns the point of this mesh at a base point. */
  SurfacePoint pointOf(const SurfacePoint& basePoint) const;
  /**
   * Returns the point of this mesh at a base point.
   * @throws std::invalid_argument if the point lies on a barrier; the message calls it @p name
   */
  SurfacePoint openPointOf(const SurfacePoint& basePoint, const std::string& name) const;
  /**
   * Returns the seeds on this mesh. The points of curves come from the lines of seeds.
   * @throws as openPointOf()
   */
  std::vector<Seed> seedsOf(const std::vector<Seed>& baseSeeds) const;
  /**
   * Converts a path to one of the input's own mesh. Points inside the input's faces are left out if
   * the path runs straight through them.
   */
  SurfacePath basePathOf(const SurfacePath& path) const;

  /** Whether both have the same mesh, cost and barriers, so that paths are the same. */
  bool isLike(const SolveSurface& other) const;

private:
  const TriangleMesh& baseMesh() const;
  void checkOpen(const SurfacePoint& point, const std::string& name) const;

  std::shared_ptr<const InputSurface> Base;
  std::shared_ptr<const TriangleMesh> Mesh;
  std::shared_ptr<const SplitMesh> Split;
  std::vector<SurfacePath> SeedLines;
  std::vector<std::uint8_t> Excluded;
  std::vector<std::uint8_t> Closed;
  std::vector<double> Cost;
};

}

#endif
