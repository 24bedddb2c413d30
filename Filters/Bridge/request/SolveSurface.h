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
 * The mesh that a request is solved on, and the request on it: the input's own mesh, or the copy
 * that is split along the lines of seeds and barriers.
 */
class SolveSurface
{
public:
  /**
   * @param mesh       the input's, or on several ranks what took its place: its points after the
   *                   input's are other ranks'
   * @param alongEdges whether ways go along edges only: then they also keep off the points that
   *                   the splitting made on barriers
   */
  SolveSurface(std::shared_ptr<const InputSurface> base,
    const std::shared_ptr<const TriangleMesh>& mesh, const SurfaceLines& lines,
    const Barriers& barriers, const std::vector<double>& cost, bool alongEdges);

  const std::shared_ptr<const TriangleMesh>& mesh() const { return this->Mesh; }
  const SplitMesh* split() const { return this->Split.get(); }
  /** One flag a vertex, or empty; for what other ranks exclude. */
  std::vector<std::uint8_t>& excluded() { return this->Excluded; }
  /** What does not depend on where to start: cost and barriers, which live as long as this. */
  SolveOptions options() const;

  SurfacePoint pointOf(const SurfacePoint& basePoint) const;
  /** @throws std::invalid_argument for a point on a line of a barrier, naming it @p name */
  SurfacePoint openPointOf(const SurfacePoint& basePoint, const std::string& name) const;
  /** @throws as openPointOf */
  std::vector<Seed> seedsOf(const std::vector<Seed>& baseSeeds) const;
  /**
   * A path of this mesh on the input's own, without the points inside faces that it runs straight
   * through.
   */
  SurfacePath basePathOf(const SurfacePath& path) const;

  /** Whether a request on this would find the same ways as on another one. */
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
