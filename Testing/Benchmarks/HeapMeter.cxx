// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HeapMeter.h"

#include <atomic>
#include <cstdlib>
#include <malloc.h>
#include <new>

namespace
{
std::atomic<std::size_t> Held = 0;
std::atomic<std::size_t> Peak = 0;
}

void* operator new(std::size_t size)
{
  void* memory = std::malloc(size);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  const std::size_t held = Held += malloc_usable_size(memory);
  if (held > Peak)
  {
    Peak = held;
  }
  return memory;
}

void operator delete(void* memory) noexcept
{
  Held -= malloc_usable_size(memory);
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  operator delete(memory);
}

namespace geodesic::testing
{

HeapMeter::HeapMeter()
  : Start(Held)
{
  Peak = this->Start;
}

std::size_t HeapMeter::held() const
{
  return Held - this->Start;
}

std::size_t HeapMeter::peak() const
{
  return Peak - this->Start;
}

}
