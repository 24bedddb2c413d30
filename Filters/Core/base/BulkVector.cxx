// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/BulkVector.h"

#include <cstdint>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace geodesic
{

void askForPages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) noexcept
{
#ifdef MADV_POPULATE_WRITE
  // Below the least size the call costs more than it saves. Above the most, it is faster that each
  // thread touches its own part first.
  constexpr std::size_t least = std::size_t{ 1 } << 16;
  constexpr std::size_t most = std::size_t{ 1 } << 22;
  if (bytes >= least && bytes <= most)
  {
    constexpr std::uintptr_t pageSize = 4096;
    const std::uintptr_t beforeIt = reinterpret_cast<std::uintptr_t>(memory) % pageSize;
    madvise(static_cast<char*>(memory) - beforeIt, beforeIt + bytes, MADV_POPULATE_WRITE);
  }
#endif
}

}
