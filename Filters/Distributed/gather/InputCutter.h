// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_InputCutter_h
#define geodesic_distributed_InputCutter_h

#include "gather/PatchCutter.h"
#include "gather/SurfacePatch.h"
#include "output/PathAttributes.h"
#include "pieces/DistributedSurface.h"
#include "ranks/RankGroup.h"

#include <span>
#include <vector>

namespace geodesic::distributed
{

/** Cuts patches with the attributes of the input, along paths that are to be written. */
class InputCutter
{
public:
  /** The arguments must outlive this object. @param input this rank's piece. Time O(n) */
  InputCutter(
    RankGroup& ranks, const DistributedSurface& surface, const bridge::PathAttributes& input);

  /**
   * Returns the input's triangles at some vertices, on the first rank, and nothing on the others.
   * Collective; all ranks must pass the same vertices.
   */
  std::vector<SurfacePatch> cutOnAll(std::span<const GlobalVertex> vertices);

private:
  RankGroup& Ranks;
  const DistributedSurface& Surface;
  const bridge::PathAttributes& Input;
  PatchCutter Cutter;
};

}

#endif
