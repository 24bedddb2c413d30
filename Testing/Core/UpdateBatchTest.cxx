// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// What rings are stored and worked on in: entries, masks of batch, lists of their bits.

#include "march/CandidateLists.h"
#include "march/TriangleSlack.h"
#include "mesh/VertexRings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace geodesic;

namespace
{

using Mask = BatchMasks::Mask;

constexpr std::size_t AllSlots = BatchMasks::Most * BatchMasks::Size;

/** Masks in which each bit is set with a probability. */
BatchMasks randomMasks(double probability, std::mt19937& random)
{
  std::bernoulli_distribution isSet(probability);
  BatchMasks masks;
  for (std::size_t slot = 0; slot < AllSlots; ++slot)
  {
    masks[slot / BatchMasks::Size] |=
      static_cast<Mask>(static_cast<unsigned>(isSet(random)) << slot % BatchMasks::Size);
  }
  return masks;
}

std::vector<Slot> slotsOf(const BatchMasks& masks)
{
  std::vector<Slot> slots;
  for (std::size_t slot = 0; slot < AllSlots; ++slot)
  {
    if (masks[slot / BatchMasks::Size] >> slot % BatchMasks::Size & 1)
    {
      slots.push_back(static_cast<Slot>(slot));
    }
  }
  return slots;
}

}

TEST(RingEntry, TellsItsNeighbourAndWhetherItOpensATriangle)
{
  constexpr Index largest = 0x3fffffffu;
  for (const Index neighbour : { 0u, 7u, largest })
  {
    EXPECT_EQ(RingEntry(neighbour).neighbour(), neighbour);
    EXPECT_FALSE(RingEntry(neighbour).opensTriangle());
    EXPECT_EQ(RingEntry(neighbour, true).neighbour(), neighbour);
    EXPECT_TRUE(RingEntry(neighbour, true).opensTriangle());
  }
}

TEST(TriangleSlack, TellsWhatItsTriangleIs)
{
  EXPECT_FALSE(TriangleSlack().isThin());
  EXPECT_EQ(TriangleSlack().value(), std::numeric_limits<float>::infinity());
  EXPECT_TRUE(TriangleSlack(-0.75f, true).isThin());
  EXPECT_FALSE(TriangleSlack(-0.25f, false).isThin());
}

// The last bit of the slack tells whether the triangle is thin. A slack that became more would let
// updates be passed over.
TEST(TriangleSlack, IsRoundedDown)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> exponent(-30.0f, 30.0f);
  for (int i = 0; i < 10000; ++i)
  {
    const float size = std::exp2(exponent(random));
    for (const bool isThin : { false, true })
    {
      const float given = i % 2 == 0 || isThin ? -size : size;
      const TriangleSlack slack(given, isThin);
      ASSERT_EQ(slack.isThin(), isThin) << given;
      ASSERT_LE(slack.value(), given);
      // Less than one step of 8 significant bits for the rounding, and one for the flag.
      ASSERT_GT(slack.value(), given - size / 64.0f);
    }
  }
  constexpr float most = std::numeric_limits<float>::max();
  EXPECT_LE(TriangleSlack(most, false).value(), most);
  EXPECT_EQ(TriangleSlack(0.0f, false).value(), 0.0f);
}

TEST(BatchMasks, AreSeenOneByOneAndTogether)
{
  std::mt19937 random(2);
  const BatchMasks a = randomMasks(0.3, random);
  const BatchMasks b = randomMasks(0.3, random);
  BatchMasks both;
  both.set(a.all() & b.all());
  for (std::size_t row = 0; row < BatchMasks::Most; ++row)
  {
    ASSERT_EQ(both[row], a[row] & b[row]);
    const BatchMasks::Some some = a.some(row / BatchMasks::SizeOfSome * BatchMasks::SizeOfSome);
    ASSERT_EQ(some >> (row % BatchMasks::SizeOfSome * BatchMasks::Size) & 0xffffu, a[row]);
  }
}

TEST(BatchMasks, HaveAnyBit)
{
  EXPECT_FALSE(BatchMasks().hasAny());
  for (std::size_t slot = 0; slot < AllSlots; ++slot)
  {
    BatchMasks masks;
    masks[slot / BatchMasks::Size] = static_cast<Mask>(1u << slot % BatchMasks::Size);
    ASSERT_TRUE(masks.hasAny()) << slot;
  }
}

// From no bits at all to more than are expected.
TEST(BitList, TakesOnEveryBitInOrder)
{
  std::mt19937 random(3);
  for (const double probability : { 0.0, 0.01, 0.1, 0.5, 1.0 })
  {
    for (int i = 0; i < 20; ++i)
    {
      const BatchMasks masks = randomMasks(probability, random);
      BitList<Slot, AllSlots, 8> list;
      for (std::size_t first = 0; first < BatchMasks::Most; first += BatchMasks::SizeOfSome)
      {
        list.add(masks.some(first),
          [&](std::size_t bit) { return static_cast<Slot>(first * BatchMasks::Size + bit); });
      }
      std::vector<Slot> found;
      for (std::size_t k = 0; k < list.size(); ++k)
      {
        found.push_back(list[k]);
      }
      ASSERT_EQ(found, slotsOf(masks));
    }
  }
}

TEST(EdgeCrossing, LeadsToTheNextSlot)
{
  for (std::size_t slot = 0; slot + 1 < UpdateBatch::Slots; ++slot)
  {
    const EdgeCrossing back = EdgeCrossing(1, 0).later(slot);
    ASSERT_EQ(back.across(), slot + 1);
    ASSERT_EQ(back.target(), slot);
    const EdgeCrossing on = EdgeCrossing(0, 1).later(slot);
    ASSERT_EQ(on.across(), slot);
    ASSERT_EQ(on.target(), slot + 1);
  }
}
