// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MarchingSolver_h
#define geodesic_MarchingSolver_h

#include "march/LabelBounds.h"
#include "march/StraightLines.h"
#include "march/TriangleCost.h"
#include "march/UpdateBounds.h"
#include "solve/DistanceField.h"
#include "solve/FrontSolver.h"
#include "solve/StartValue.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace geodesic
{

class OptionsOfMarches;

/**
 * The base of both tiers of fast marching: ReferenceSolver, the algorithm in its plain form, and
 * FastMarchingSolver, its fast form. It prepares what both need, costs, start values and margins,
 * and leaves the march to the tier. Both compute the same field with the update of EikonalUpdate.h.
 */
class MarchingSolver : public FrontSolver
{
public:
  /** The order of a march is that of the distances: values that come before those of their
   * neighbours would be wrong at first, and corrected again and again. */
  bool gainsByMaximumDistance() const override { return true; }
  const Detours* detours() const override
  {
    return this->LastCost ? &this->LastCost->detours() : nullptr;
  }

protected:
  MarchingSolver(
    std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const UpdateBounds> bounds);

  bool march(const Request& request, StopLimit& limit, DistanceField& field) override;
  bool renewFor(const TriangleMesh& mesh) final;

  /**
   * Marches from start values. The second form is for a cost that varies.
   * @param starts  first values of vertices on this piece of the surface
   * @param cost    cost of each triangle, with margins that all pieces agree on
   * @param request, limit, field  as in FrontSolver::march()
   * @return false when cancelled
   */
  virtual bool marchFrom(std::span<const StartValue> starts, const UnitCost& cost,
    const Request& request, LabelBounds* bounds, StopLimit& limit, DistanceField& field) = 0;
  virtual bool marchFrom(std::span<const StartValue> starts, const VertexCost& cost,
    const Request& request, LabelBounds* bounds, StopLimit& limit, DistanceField& field) = 0;
  /** Another solver of the same tier on the same mesh, with its own workspace. */
  virtual std::unique_ptr<MarchingSolver> another() const = 0;

  const std::shared_ptr<const UpdateBounds>& bounds() const { return this->Bounds; }

private:
  template <class Cost>
  bool marchAtCost(std::span<const StartValue> starts, const Cost& cost, const Request& request,
    StopLimit& limit, DistanceField& field);

  /** Marches of several labels within bounds of values, see BoundedMarches.cxx.
   * @param areDense  whether labels are; else costs jump */
  template <class Cost>
  bool marchWithinBounds(std::span<const StartValue> starts, const Cost& cost,
    const Request& request, bool areDense, StopLimit& limit, DistanceField& field);
  /** A march within LineBounds. */
  bool marchWithinLines(std::span<const StartValue> starts, const UnitCost& cost,
    const Request& request, OptionsOfMarches& marches, StopLimit& limit, DistanceField& field);
  /** A march of labels within LabelsWithin, which are checked after it. */
  template <class Cost>
  bool marchLabels(std::span<const StartValue> starts, const Cost& cost, const Request& request,
    OptionsOfMarches& marches, StopLimit& limit, DistanceField& field);
  /** See LineBounds::Marching. */
  const DistanceField* marchWays(std::span<const StartValue> starts,
    std::span<const std::uint8_t> excluded, const UnitCost& cost, const Request& request,
    OptionsOfMarches& marches, StopLimit& limit);
  /** Completes a field that was found within bounds, see takeFirstMarch() and lowerAlongEdges(),
   * and removes the bounds. @return false when cancelled */
  bool finishWithinBounds(std::span<const StartValue> starts, const Request& request, bool areDense,
    bool isFinished, OptionsOfMarches& marches, StopLimit& limit, DistanceField& field);
  /** Whether there are hubVertices(); found at the first run that asks. Collective. */
  bool hasHubs(Partition& partition);
  /** A first march, and one within the bounds that it gives. @pre LabelBounds::begin() */
  template <class Cost>
  bool marchTwice(std::span<const StartValue> starts, const Cost& cost, const Request& request,
    bool areDense, OptionsOfMarches& marches, StopLimit& limit, DistanceField& field);

  /** The reaches of a cost of 1 everywhere, made at the first run that may stop. Collective. */
  std::span<const float> unitReaches(Partition& partition);

  std::shared_ptr<const UpdateBounds> Bounds;
  std::optional<std::vector<float>> UnitReaches;
  /** The cost of the last run with one, and its reaches if that run could stop, for the next run
   * that keeps the surface. */
  std::optional<VertexCost> LastCost;
  bool IsCostOfOneLabel = false;
  std::optional<std::vector<float>> CostReaches;
  /** Measures the lengths in the discs round seeds (see CostedStart.h); made at the first run with
   * a cost. */
  std::unique_ptr<FrontSolver> DiscSolver;
  /** Kept for its memory. */
  LabelBounds LabelsWithin;
  std::optional<bool> HasHubs;
  /** Made at the first run within LineBounds. */
  std::optional<StraightLines> Lines;
  /** For where they say too little; made at the first run that needs it, with its field. */
  std::unique_ptr<MarchingSolver> WaysSolver;
  std::optional<DistanceField> Ways;
};

}

#endif
