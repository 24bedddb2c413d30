// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleMeasure_h
#define geodesic_TriangleMeasure_h

#include "base/Index.h"
#include "base/Vector3.h"
#include "march/TriangleSlack.h"
#include "mesh/RingNumbers.h"

#include <span>

namespace geodesic
{

/**
 * Measures triangles for UpdateBounds, two or four at a time. A ring entry gets the TriangleSlack
 * of its triangle, a vertex the largest labelMargin() round it, rounded up.
 */
class TriangleMeasurer final : public RingMeasurer
{
public:
  /** @param mayUseQuads whether four triangles are measured at once if the processor can; the
   * results are the same either way */
  explicit TriangleMeasurer(bool mayUseQuads = true)
    : UsesQuads(mayUseQuads && hasQuads())
  {
  }

  void measure(std::span<const Triangle> triangles, std::span<const Vector3> positions,
    TriangleNumbers& numbers) const override;
  EntryNumber ofNoTriangle() const override { return TriangleSlack().stored(); }

private:
  bool UsesQuads;
};

}

#endif
