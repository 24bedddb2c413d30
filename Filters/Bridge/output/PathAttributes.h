// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PathAttributes_h
#define geodesic_bridge_PathAttributes_h

#include "base/Vector3.h"
#include "input/InputSurface.h"
#include "input/ObjectVersion.h"

#include "vtkType.h"

#include <optional>
#include <vector>

namespace geodesic::bridge
{

/** The mesh that a path runs on, and the attributes of the input at its vertices. */
class PathAttributes
{
public:
  virtual ~PathAttributes() = default;

  virtual const TriangleMesh& mesh() const = 0;
  /** The id of the input's point at a vertex. */
  virtual vtkIdType idOf(Index vertex) const = 0;
  /**
   * The flat index of that point's block in the composite data set, for inputs whose ids are not
   * unique.
   */
  virtual vtkIdType blockOf(Index vertex) const = 0;
  /** The input's normal at a vertex, of any length; none if the input has no normals there. */
  virtual std::optional<Vector3> normalOf(Index vertex) const = 0;
};

/** The input's own mesh, with the attributes of its points. */
class InputPathAttributes final : public PathAttributes
{
public:
  /** Both arguments must outlive this object. */
  InputPathAttributes(const InputSurface& surface, const InputBlocks& blocks)
    : Surface(surface)
    , Blocks(blocks)
  {
  }

  const TriangleMesh& mesh() const override { return *this->Surface.mesh(); }
  vtkIdType idOf(Index vertex) const override;
  vtkIdType blockOf(Index vertex) const override;
  std::optional<Vector3> normalOf(Index vertex) const override;

  /** The arrays that ids and normals come from, as they are now. */
  std::vector<ObjectVersion> versions() const;

private:
  const InputSurface& Surface;
  const InputBlocks& Blocks;
};

}

#endif
