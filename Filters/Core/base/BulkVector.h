// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BulkVector_h
#define geodesic_BulkVector_h

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace geodesic
{

/**
 * Asks the operating system to provide all pages of some memory at once, before the memory is
 * written as a whole. Otherwise each page is provided when it is first touched, which costs twice
 * as much. The content of the memory does not change. Does nothing outside 64 KiB to 4 MiB, where
 * it would not pay, or where the system has no such call.
 * @param memory  first byte
 * @param bytes   size of the memory
 */
void askForPages(void* memory, std::size_t bytes) noexcept;

/** Allocator that leaves elements uninitialized where they are made without a value. */
template <class T>
class UninitializedAllocator : public std::allocator<T>
{
public:
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  template <class Other>
  struct rebind
  {
    using other = UninitializedAllocator<Other>;
  };

  UninitializedAllocator() = default;
  template <class Other>
  UninitializedAllocator(const UninitializedAllocator<Other>&) noexcept
  {
  }

  T* allocate(std::size_t count)
  {
    T* const elements = std::allocator<T>::allocate(count);
    askForPages(elements, count * sizeof(T));
    return elements;
  }

  template <class Element>
  void construct(Element*) const noexcept
  {
  }
  template <class Element, class... Arguments>
  void construct(Element* element, Arguments&&... arguments) const
  {
    std::construct_at(element, std::forward<Arguments>(arguments)...);
  }
};

/**
 * A vector whose resize() leaves the new elements uninitialized. Threads then write them all: the
 * first access to memory is the most expensive one, so it is not wasted on setting zeros.
 */
template <class T>
using BulkVector = std::vector<T, UninitializedAllocator<T>>;

}

#endif
