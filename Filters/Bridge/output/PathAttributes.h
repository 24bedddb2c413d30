// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PathAttributes_h
#define geodesic_bridge_PathAttributes_h

#include "base/Vector3.h"
#include "input/InputSurface.h"

#include "vtkType.h"

#include <optional>

namespace geodesic::bridge
{

/** What a path runs on, and what the input says of the vertices that carry it. */
class PathAttributes
{
public:
  virtual ~PathAttributes() = default;

  virtual const TriangleMesh& mesh() const = 0;
  /** The id of the input's point. */
  virtual vtkIdType idOf(Index vertex) const = 0;
  /** The number of its block in the composite data set, where ids do not tell points apart. */
  virtual vtkIdType blockOf(Index vertex) const = 0;
  /** The input's normal, of any length; none where it has none. */
  virtual std::optional<Vector3> normalOf(Index vertex) const = 0;
};

/** The input's own mesh. */
class InputPathAttributes final : public PathAttributes
{
public:
  /** Both must live as long as this. */
  InputPathAttributes(const InputSurface& surface, const InputBlocks& blocks)
    : Surface(surface)
    , Blocks(blocks)
  {
  }

  const TriangleMesh& mesh() const override { return *this->Surface.mesh(); }
  vtkIdType idOf(Index vertex) const override;
  vtkIdType blockOf(Index vertex) const override;
  std::optional<Vector3> normalOf(Index vertex) const override;

private:
  const InputSurface& Surface;
  const InputBlocks& Blocks;
};

}

#endif
