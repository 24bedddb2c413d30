// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexState_h
#define geodesic_VertexState_h

#include "base/Index.h"

#include <cstdint>

namespace geodesic
{

/**
 * The state of a vertex's value: its label, if there are several, whether it waits in the queue,
 * and whether it is final. All is in one number, so that the states of several vertices can be
 * read and compared at once.
 *
 * The bits of a label are its number plus 1; 0 means that no label is stored.
 */
class VertexState
{
public:
  /** Whether a label is stored. */
  bool hasLabel() const { return this->labelBits() != 0; }
  /** Whether a label other than that of @p labelBits is stored. There is no branch: near a front
   * about half of the vertices have no value, which a processor can't predict. */
  bool hasOtherLabel(Index labelBits) const
  {
    return std::uint64_t{ this->labelBits() } * (this->labelBits() ^ labelBits) != 0;
  }
  /** The number of the label. @pre hasLabel() */
  Index label() const { return labelOf(this->labelBits()); }
  void setLabel(Index label) { this->Bits = (this->Bits & ~LabelBits) | labelBitsOf(label); }

  /** The bits of a label's number, and the number of a label's bits. */
  static Index labelBitsOf(Index label) { return label + 1; }
  static Index labelOf(Index labelBits) { return labelBits - 1; }

  /** Whether the value waits in the queue. */
  bool isQueued() const { return (this->Bits & Queued) != 0; }
  void setQueued(bool isQueued)
  {
    this->Bits = isQueued ? this->Bits | Queued : this->Bits & ~Queued;
  }
  /** Whether the value waits, is of the label of @p labelBits, and is not final. */
  bool isQueuedFor(Index labelBits) const { return this->Bits == queuedFor(labelBits); }
  /** All bits of a value as in isQueuedFor(). */
  static Index queuedFor(Index labelBits) { return Queued | labelBits; }
  /** Does setQueued(true) and stores the label of @p labelBits. @pre no other label is stored */
  void queueFor(Index labelBits) { this->Bits |= Queued | labelBits; }
  /** Whether the value is final, see StartValue. */
  bool isFinal() const { return (this->Bits & Final) != 0; }
  void setFinal(bool isFinal) { this->Bits = isFinal ? this->Bits | Final : this->Bits & ~Final; }

  // For code that reads several states at once.

  /** All bits; the highest one is isQueued(). */
  Index bits() const { return this->Bits; }
  /** The bits of the label; 0 if none is stored. */
  Index labelBits() const { return this->Bits & LabelBits; }
  static constexpr Index LabelBits = 0x3fffffffu;

private:
  static constexpr Index Queued = 0x80000000u;
  static constexpr Index Final = 0x40000000u;
  Index Bits = 0;
};

}

#endif
