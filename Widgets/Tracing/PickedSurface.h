// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PickedSurface_h
#define geodesic_bridge_PickedSurface_h

#include "input/InputSurface.h"
#include "methods/SolverTable.h"
#include "path/PathFinder.h"

#include "vtkType.h"

#include <map>
#include <memory>
#include <optional>

namespace geodesic::bridge
{

/** A surface that lines are drawn on, with the solvers that are kept from one line to the next. */
class PickedSurface
{
public:
  explicit PickedSurface(std::shared_ptr<const InputSurface> surface)
    : Surface(std::move(surface))
  {
  }

  const std::shared_ptr<const InputSurface>& surface() const { return this->Surface; }
  const TriangleMesh& mesh() const { return *this->Surface->mesh(); }

  /** A point of the input near a position, and the distance from the position to the surface. */
  struct NearPoint
  {
    vtkIdType id;
    double distance;
  };
  /** Finds the face that is nearest to a finite position, and returns the face's nearest corner. */
  NearPoint nearestPoint(const Vector3& position) const;

  /**
   * The shortest path from one point of the input to another: along edges, or across faces and then
   * made locally shortest.
   * @return none if there is no path, or one of the ids is not a point of the surface
   */
  std::optional<SurfacePath> path(
    vtkIdType begin, vtkIdType end, const SolverTraits& method, PathOrder order);

private:
  Index vertexAt(vtkIdType id) const;
  DistanceSolver& solverOf(const SolverTraits& method);

  std::shared_ptr<const InputSurface> Surface;
  /** By number; made when first asked for. */
  std::map<int, std::unique_ptr<DistanceSolver>> Solvers;
};

}

#endif
