// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Mailbox_h
#define geodesic_Mailbox_h

#include <array>
#include <atomic>
#include <cstddef>

namespace geodesic
{

/** Letters from one thread to another, which takes them while the first one writes more: a ring
 * buffer of one writer and one reader. @tparam Letter  is copied; starts without a value */
template <class Letter, std::size_t Size>
class Mailbox
{
public:
  /** Leaves the room for letters as it is, as most of it is never used. */
  Mailbox() {} // NOLINT(modernize-use-equals-default)

  /** Of the writer. @return false if there is no room */
  bool put(const Letter& letter)
  {
    const std::size_t written = this->Written.load(std::memory_order_relaxed);
    if (written - this->Taken.load(std::memory_order_acquire) == Size)
    {
      return false;
    }
    this->Letters[written % Size] = letter;
    this->Written.store(written + 1, std::memory_order_release);
    return true;
  }
  /** Of the writer: calls visit(letter) for each that was not taken, and maybe for others that are
   * taken meanwhile. */
  template <class Visit>
  void visitLeft(const Visit& visit) const
  {
    const std::size_t written = this->Written.load(std::memory_order_relaxed);
    for (std::size_t i = this->Taken.load(std::memory_order_acquire); i < written; ++i)
    {
      visit(this->Letters[i % Size]);
    }
  }

  /** Of the reader: calls take(letter) for each. */
  template <class Take>
  void takeAll(const Take& take)
  {
    const std::size_t written = this->Written.load(std::memory_order_acquire);
    std::size_t taken = this->Taken.load(std::memory_order_relaxed);
    for (; taken < written; ++taken)
    {
      take(this->Letters[taken % Size]);
    }
    this->Taken.store(taken, std::memory_order_release);
  }

private:
  /** How many were ever put and taken, each on cache lines of its own. */
  alignas(128) std::atomic<std::size_t> Written = 0;
  alignas(128) std::atomic<std::size_t> Taken = 0;
  alignas(128) std::array<Letter, Size> Letters;
};

}

#endif
