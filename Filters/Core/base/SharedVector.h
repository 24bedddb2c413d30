// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedVector_h
#define geodesic_SharedVector_h

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace geodesic
{

/** A vector whose elements never change again, so that its copies share them. They are read as fast
 * as those of a vector: where they begin is kept here. */
template <class T>
class SharedVector
{
public:
  SharedVector() = default;
  template <class Allocator>
  explicit SharedVector(std::vector<T, Allocator> elements)
  {
    const auto owner = std::make_shared<const std::vector<T, Allocator>>(std::move(elements));
    this->First = owner->data();
    this->Size = owner->size();
    this->Owner = owner;
  }

  const T* data() const { return this->First; }
  std::size_t size() const { return this->Size; }
  bool empty() const { return this->Size == 0; }
  const T* begin() const { return this->First; }
  const T* end() const { return this->First + this->Size; }
  const T& operator[](std::size_t i) const { return this->First[i]; }
  const T& back() const { return this->First[this->Size - 1]; }

  /** Whether these are the very elements of another one, and not only equal. */
  bool isShared(const SharedVector& other) const { return this->Owner == other.Owner; }

private:
  std::shared_ptr<const void> Owner;
  const T* First = nullptr;
  std::size_t Size = 0;
};

}

#endif
