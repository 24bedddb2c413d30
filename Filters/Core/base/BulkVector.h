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
 * Has the system hand out memory that is soon to be written as a whole. It comes in pages as they
 * are first touched; to ask for many at once costs half as much. Memory that is there already stays
 * as it is, and where the system cannot be asked nothing happens.
 */
void askForPages(void* memory, std::size_t bytes) noexcept;

/** Leaves elements that are made without a value as they are found in memory. */
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
 * A vector whose resize() does not touch the new elements: threads are to write them all, and
 * memory costs most where it is first touched.
 */
template <class T>
using BulkVector = std::vector<T, UninitializedAllocator<T>>;

}

#endif
