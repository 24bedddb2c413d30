// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MarchingSolver_h
#define geodesic_MarchingSolver_h

#include "march/TriangleCost.h"
#include "march/UpdateBounds.h"
#include "solve/FrontSolver.h"
#include "solve/StartValue.h"

#include <memory>
#include <span>

namespace geodesic
{

/** What both tiers of fast marching do before they march: costs, first values, margins. */
class MarchingSolver : public FrontSolver
{
protected:
  MarchingSolver(
    std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const UpdateBounds> bounds);

  bool march(const Request& request, StopLimit& limit, DistanceField& field) final;

  /** As FrontSolver::march(), from these first values. */
  virtual bool marchFrom(std::span<const StartValue> starts, const UnitCost& cost,
    const Request& request, StopLimit& limit, DistanceField& field) = 0;
  virtual bool marchFrom(std::span<const StartValue> starts, const VertexCost& cost,
    const Request& request, StopLimit& limit, DistanceField& field) = 0;
  /** Another solver of this kind on the mesh. */
  virtual std::unique_ptr<FrontSolver> another() const = 0;

  const std::shared_ptr<const UpdateBounds>& bounds() const { return this->Bounds; }

private:
  std::shared_ptr<const UpdateBounds> Bounds;
  /** Measures the discs round seeds where the cost varies; made when first needed. */
  std::unique_ptr<FrontSolver> DiscSolver;
};

}

#endif
