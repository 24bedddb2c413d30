// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_InputGeometry_h
#define geodesic_bridge_InputGeometry_h

#include "base/BulkVector.h"
#include "base/Vector3.h"
#include "input/BlockNumbering.h"
#include "input/InputBlocks.h"
#include "input/PolyDataTriangles.h"

#include <optional>
#include <span>

namespace geodesic::bridge
{

/** The points and the triangles of an input, each copied when first asked for. The blocks must
 * outlive this object. */
class InputGeometry
{
public:
  /** @param rank see BlockNumbering */
  InputGeometry(const InputBlocks& blocks, std::optional<int> rank);

  const InputBlocks& blocks() const { return this->Blocks; }
  const BlockNumbering& numbering() const { return this->Numbering; }
  std::span<const Vector3> points();
  SurfaceTriangles& triangles();

private:
  const InputBlocks& Blocks;
  BlockNumbering Numbering;
  std::optional<BulkVector<Vector3>> Points;
  std::optional<SurfaceTriangles> Triangles;
};

}

#endif
