// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexState_h
#define geodesic_VertexState_h

#include "base/Index.h"

#include <cstdint>

namespace geodesic
{

/**
 * What a march notes of a vertex's value beside it: whose it is, where there are several labels,
 * and what is to be done with it. All in one number, so that several can be looked at at once.
 */
class VertexState
{
public:
  /** Whether a label is noted. */
  bool hasLabel() const { return this->labelBits() != 0; }
  /** Whether one is, but not that of @p labelBits. Without a branch in between: on a front about
   * half of the vertices have no value. */
  bool hasOtherLabel(Index labelBits) const
  {
    return std::uint64_t{ this->labelBits() } * (this->labelBits() ^ labelBits) != 0;
  }
  Index label() const { return labelOf(this->labelBits()); }
  void setLabel(Index label) { this->Bits = (this->Bits & ~LabelBits) | bitsOf(label); }

  /** What labelBits() of a label are, and whose they are. */
  static Index bitsOf(Index label) { return label + 1; }
  static Index labelOf(Index labelBits) { return labelBits - 1; }

  /** It waits to be swept. */
  bool isQueued() const { return (this->Bits & Queued) != 0; }
  void setQueued(bool isQueued)
  {
    this->Bits = isQueued ? this->Bits | Queued : this->Bits & ~Queued;
  }
  /** It waits, for the label of @p labelBits, and is not pinned. */
  bool isQueuedFor(Index labelBits) const { return this->Bits == (Queued | labelBits); }
  /** The same as setQueued(true), and notes the label of @p labelBits, where no other one is. */
  void queueFor(Index labelBits) { this->Bits |= Queued | labelBits; }
  /** It stays, whatever is proposed. */
  bool isPinned() const { return (this->Bits & Pinned) != 0; }
  void setPinned(bool isPinned)
  {
    this->Bits = isPinned ? this->Bits | Pinned : this->Bits & ~Pinned;
  }

  // For who reads several at once.

  /** Of these the highest bit tells what isQueued() does. */
  Index bits() const { return this->Bits; }
  /** 0 without a label. */
  Index labelBits() const { return this->Bits & LabelBits; }
  static constexpr Index LabelBits = 0x3fffffffu;

private:
  static constexpr Index Queued = 0x80000000u;
  static constexpr Index Pinned = 0x40000000u;
  Index Bits = 0;
};

}

#endif
