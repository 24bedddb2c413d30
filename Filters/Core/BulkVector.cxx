#include "BulkVector.h"

#include <cstdint>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace geodesic
{

void askForPages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) noexcept
{
#ifdef __linux__
  constexpr std::uintptr_t pageSize = 4096;
  const std::uintptr_t beforeIt = reinterpret_cast<std::uintptr_t>(memory) % pageSize;
  void* const firstPage = static_cast<char*>(memory) - beforeIt;
  const std::size_t length = beforeIt + bytes;
  constexpr std::size_t hugePage = std::size_t{ 1 } << 21;
  if (bytes >= hugePage)
  {
    madvise(firstPage, length, MADV_HUGEPAGE);
  }
#ifdef MADV_POPULATE_WRITE
  // For less a call costs more than it saves; of more, threads had better touch their parts.
  constexpr std::size_t least = std::size_t{ 1 } << 16;
  if (bytes >= least && bytes <= 2 * hugePage)
  {
    madvise(firstPage, length, MADV_POPULATE_WRITE);
  }
#endif
#endif
}

}
