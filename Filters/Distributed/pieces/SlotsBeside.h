// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_SlotsBeside_h
#define geodesic_distributed_SlotsBeside_h

#include "base/Index.h"

#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

class TriangleMesh;

namespace distributed
{

/**
 * For each vertex the slots of the shared vertices at it: its own and those of its neighbours. When
 * a vertex is taken from a front's queue, these are the shared values that may fall.
 *
 * Memory 1 bit for each vertex, and about 50 bytes for each shared one.
 */
class SlotsBeside
{
public:
  /** @param shared  the shared vertices in ascending order, see SharedPoints::vertices() */
  SlotsBeside(const TriangleMesh& mesh, std::span<const Index> shared);

  /** The slots at a vertex; of most there are none. */
  std::span<const std::uint32_t> of(Index vertex) const;

private:
  /** Whether a vertex has slots. */
  std::vector<bool> HasSlots;
  /** The vertices that have, in ascending order, and the place of the first slot of each. */
  std::vector<Index> Vertices;
  std::vector<std::uint32_t> First;
  std::vector<std::uint32_t> Slots;
};

}
}

#endif
