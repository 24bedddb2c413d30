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

/** The points on the surface that a line runs through. */
using LinePoints = std::vector<SurfacePoint>;

/**
 * The lines of seeds and barriers, joined over the surface by shortest paths. If any of them
 * crosses faces, there is a copy of the mesh that is split along the lines.
 */
class SurfaceLines
{
public:
  /**
   * Joins the points of each line and splits the mesh, unless mesh and lines are those of the last
   * call.
   * @throws std::invalid_argument if the points of a line are on parts of the surface that are not
   * connected
   */
  void update(const std::shared_ptr<const TriangleMesh>& mesh, std::vector<LinePoints> seeds,
    std::vector<LinePoints> barriers);

  /** Sets lines that are joined already, and splits the mesh if needed. */
  void take(const std::shared_ptr<const TriangleMesh>& mesh, std::vector<SurfacePath> seeds,
    std::vector<SurfacePath> barriers);

  const std::vector<SurfacePath>& seeds() const { return this->SeedPaths; }
  const std::vector<SurfacePath>& barriers() const { return this->BarrierPaths; }
  /** The split mesh; null if all lines run along edges of the mesh. */
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
