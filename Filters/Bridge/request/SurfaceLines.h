// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SurfaceLines_h
#define geodesic_bridge_SurfaceLines_h

#include "mesh/SurfacePoint.h"
#include "path/PathPoint.h"

#include <memory>
#include <vector>

namespace geodesic
{
class SplitMesh;
}

namespace geodesic::bridge
{

/** Points on the surface that a line leads through. */
using LinePoints = std::vector<SurfacePoint>;

/**
 * The lines that seeds and barriers give: joined over the surface and, where they cross faces, with
 * a copy of the mesh that is split along them.
 */
class SurfaceLines
{
public:
  /**
   * Joins and splits, unless it did so for the same mesh and lines last time.
   * @throws std::invalid_argument where the points of a line are on parts that do not hang together
   */
  void update(const std::shared_ptr<const TriangleMesh>& mesh, std::vector<LinePoints> seeds,
    std::vector<LinePoints> barriers);

  /** Lines that are joined; splits where that is needed. */
  void take(const std::shared_ptr<const TriangleMesh>& mesh, std::vector<SurfacePath> seeds,
    std::vector<SurfacePath> barriers);

  const std::vector<SurfacePath>& seeds() const { return this->SeedPaths; }
  const std::vector<SurfacePath>& barriers() const { return this->BarrierPaths; }
  /** Null where all lines run along edges of the mesh. */
  const std::shared_ptr<const SplitMesh>& split() const { return this->Split; }

private:
  std::shared_ptr<const TriangleMesh> Mesh;
  std::vector<LinePoints> Seeds;
  std::vector<LinePoints> Barriers;
  std::vector<SurfacePath> SeedPaths;
  std::vector<SurfacePath> BarrierPaths;
  std::shared_ptr<const SplitMesh> Split;
};

}

#endif
