// What rings are stored and worked on in: entries, masks of windows, lists of their bits.

#include "march/RingWays.h"
#include "mesh/VertexRings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace geodesic;

namespace
{

using Mask = WindowMasks::Mask;

constexpr std::size_t AllSlots = WindowMasks::Most * WindowMasks::Size;

/** Masks in which each bit is set with a probability. */
WindowMasks randomMasks(double probability, std::mt19937& random)
{
  std::bernoulli_distribution isSet(probability);
  WindowMasks masks;
  for (std::size_t slot = 0; slot < AllSlots; ++slot)
  {
    masks[slot / WindowMasks::Size] |=
      static_cast<Mask>(static_cast<unsigned>(isSet(random)) << slot % WindowMasks::Size);
  }
  return masks;
}

std::vector<Slot> slotsOf(const WindowMasks& masks)
{
  std::vector<Slot> slots;
  for (std::size_t slot = 0; slot < AllSlots; ++slot)
  {
    if (masks[slot / WindowMasks::Size] >> slot % WindowMasks::Size & 1)
    {
      slots.push_back(static_cast<Slot>(slot));
    }
  }
  return slots;
}

}

TEST(RingEntry, TellsWhatItsTriangleIs)
{
  const RingEntry none(7);
  EXPECT_FALSE(none.opensTriangle());
  EXPECT_FALSE(none.isThin());
  EXPECT_EQ(none.slack(), std::numeric_limits<float>::infinity());
  constexpr Index largest = 0x3fffffffu;
  const RingEntry thin = RingEntry(7, -0.75f, true).at(largest);
  EXPECT_EQ(thin.neighbour(), largest);
  EXPECT_TRUE(thin.opensTriangle());
  EXPECT_TRUE(thin.isThin());
  EXPECT_FALSE(RingEntry(7, -0.25f, false).isThin());
}

// The last bit of the slack tells whether the triangle is thin. A slack that became more would let
// updates be passed over.
TEST(RingEntry, RoundsSlackDown)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> exponent(-30.0f, 30.0f);
  for (int i = 0; i < 10000; ++i)
  {
    const float size = std::exp2(exponent(random));
    for (const bool isThin : { false, true })
    {
      const float slack = i % 2 == 0 || isThin ? -size : size;
      const RingEntry entry(3, slack, isThin);
      ASSERT_EQ(entry.isThin(), isThin) << slack;
      ASSERT_TRUE(entry.opensTriangle());
      ASSERT_LE(entry.slack(), slack);
      ASSERT_GE(entry.slack(), std::nextafter(slack, -2.0f * size));
    }
  }
  constexpr float most = std::numeric_limits<float>::max();
  EXPECT_TRUE(RingEntry(3, most, false).opensTriangle());
  EXPECT_EQ(RingEntry(3, 0.0f, false).slack(), 0.0f);
}

TEST(WindowMasks, AreSeenOneByOneAndTogether)
{
  std::mt19937 random(2);
  const WindowMasks a = randomMasks(0.3, random);
  const WindowMasks b = randomMasks(0.3, random);
  WindowMasks both;
  both.set(a.all() & b.all());
  for (std::size_t window = 0; window < WindowMasks::Most; ++window)
  {
    ASSERT_EQ(both[window], a[window] & b[window]);
    const WindowMasks::Some some =
      a.some(window / WindowMasks::SizeOfSome * WindowMasks::SizeOfSome);
    ASSERT_EQ(some >> (window % WindowMasks::SizeOfSome * WindowMasks::Size) & 0xffffu, a[window]);
  }
}

TEST(WindowMasks, HaveAnyBit)
{
  EXPECT_FALSE(WindowMasks().hasAny());
  for (std::size_t slot = 0; slot < AllSlots; ++slot)
  {
    WindowMasks masks;
    masks[slot / WindowMasks::Size] = static_cast<Mask>(1u << slot % WindowMasks::Size);
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
      const WindowMasks masks = randomMasks(probability, random);
      BitList<Slot, AllSlots, 8> list;
      for (std::size_t first = 0; first < WindowMasks::Most; first += WindowMasks::SizeOfSome)
      {
        list.add(masks.some(first),
          [&](std::size_t bit) { return static_cast<Slot>(first * WindowMasks::Size + bit); });
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

TEST(WayOver, LeadsToTheNextSlot)
{
  for (std::size_t slot = 0; slot + 1 < RingWindows::Slots; ++slot)
  {
    const WayOver back = WayOver(1, 0).later(slot);
    ASSERT_EQ(back.over(), slot + 1);
    ASSERT_EQ(back.target(), slot);
    const WayOver on = WayOver(0, 1).later(slot);
    ASSERT_EQ(on.over(), slot);
    ASSERT_EQ(on.target(), slot + 1);
  }
}
