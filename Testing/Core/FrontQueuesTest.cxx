// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The queues of a march: what comes first, and whose turn it is.

#include "march/FrontQueues.h"
#include "march/RadixHeap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <set>
#include <span>
#include <utility>
#include <vector>

using namespace geodesic;

namespace
{

constexpr std::uint64_t Always = std::numeric_limits<std::uint64_t>::max();
/** Keys up to so much more than the last one have buckets of their own. */
constexpr double Span = 100.0;

/** What waits before a bucket, in the order it is handed out. */
std::vector<Index> emptied(FrontQueues& queues, std::uint64_t end = Always)
{
  std::vector<Index> items;
  std::array<Index, 3> room;
  while (queues.hasBefore(end))
  {
    const std::span<const Index> taken = queues.take(room);
    items.insert(items.end(), taken.begin(), taken.end());
  }
  return items;
}

using Items = std::vector<Index>;

}

TEST(FrontQueues, AGroupGoesOnByASliceThenTheNextDoes)
{
  FrontQueues queues;
  queues.start(1.0, Span, 2);
  ASSERT_EQ(queues.numberOfGroups(), 2u);
  const Index first = 3;
  const Index last = FrontQueues::Slice - 1;
  const Index later = last + FrontQueues::Slice + 5;
  for (Index item : { later, first, last + 1, last })
  {
    queues.group(0).best.push(item, item + 0.5);
    queues.group(1).best.push(item + 100, item + 0.5);
  }
  EXPECT_EQ(emptied(queues),
    (Items{ first, last, first + 100, last + 100, last + 1, last + 101, later, later + 100 }));
  EXPECT_EQ(queues.nextKey(), std::numeric_limits<double>::infinity());
}

TEST(FrontQueues, ASliceBeginsWhereSomethingWaits)
{
  FrontQueues queues;
  queues.start(1.0, 1e4, 2);
  const Index first = 251 * FrontQueues::Slice - 1;
  queues.group(0).best.push(1, first + 0.5);
  queues.group(1).best.push(2, first + FrontQueues::Slice - 0.5);
  queues.group(0).best.push(3, first + FrontQueues::Slice + 0.5);
  EXPECT_EQ(queues.nextKey(), first);
  EXPECT_EQ(emptied(queues), (Items{ 1, 2, 3 }));
}

// What is added to them meanwhile joins the next bucket.
TEST(FrontQueues, OfABucketBestValuesComeFirst)
{
  FrontQueues queues;
  queues.start(1.0, Span, 1);
  FrontGroup& group = queues.group(0);
  group.secondary.push(1, 0.5);
  group.secondary.push(2, 0.5);
  group.best.push(3, 1.5);
  group.best.push(4, 0.5);
  std::array<Index, 1> room;
  ASSERT_TRUE(queues.hasBefore(Always));
  EXPECT_EQ(queues.take(room)[0], 4u);
  ASSERT_TRUE(queues.hasBefore(Always));
  EXPECT_EQ(queues.take(room)[0], 1u);
  group.best.push(5, 0.5);
  EXPECT_EQ(emptied(queues), (Items{ 2, 3, 5 }));
}

TEST(FrontQueues, NothingIsHandedOutBeyondTheEnd)
{
  FrontQueues queues;
  queues.start(1.0, Span, 2);
  queues.group(0).best.push(1, 2.5);
  queues.group(0).best.push(2, 20.5);
  queues.group(1).secondary.push(3, 10.5);
  queues.group(1).best.push(4, 50.5);
  EXPECT_EQ(emptied(queues, 2), Items());
  EXPECT_EQ(emptied(queues, 11), (Items{ 1, 3 }));
  EXPECT_EQ(queues.nextKey(), 20.0);
  EXPECT_EQ(emptied(queues), (Items{ 2, 4 }));
}

// As when a value comes from another piece of the surface.
TEST(FrontQueues, WhoGoesBackComesBeforeWhatWaits)
{
  FrontQueues queues;
  queues.start(1.0, Span, 2);
  queues.group(0).best.push(1, 60.5);
  queues.group(1).best.push(2, 61.5);
  EXPECT_EQ(emptied(queues, 60), Items());
  queues.goBackTo(queues.group(1), 7.5);
  queues.group(1).best.push(3, 8.5);
  queues.group(1).secondary.push(4, 7.5);
  EXPECT_EQ(queues.nextKey(), 7.0);
  EXPECT_EQ(emptied(queues, 40), (Items{ 4, 3 }));
  EXPECT_EQ(emptied(queues), (Items{ 1, 2 }));
}

TEST(FrontQueues, GroupsTakeTurnsFromWhereOneWentBackTo)
{
  FrontQueues queues;
  queues.start(1.0, Span, 2);
  EXPECT_EQ(emptied(queues, 60), Items());
  queues.goBackTo(queues.group(0), 7.5);
  queues.goBackTo(queues.group(1), 8.5);
  queues.group(0).best.push(1, 7.5);
  queues.group(0).best.push(2, 50.5);
  queues.group(1).best.push(3, 8.5);
  EXPECT_EQ(emptied(queues), (Items{ 1, 3, 2 }));
}

// What group 1 displaces of group 0 is not forgotten.
TEST(FrontQueues, WhatIsAddedToAGroupAfterItsTurnWaitsForTheNext)
{
  FrontQueues queues;
  queues.start(1.0, Span, 2);
  queues.group(1).best.push(1, 3.5);
  std::array<Index, 1> room;
  ASSERT_TRUE(queues.hasBefore(10));
  EXPECT_EQ(queues.take(room)[0], 1u);
  queues.group(0).secondary.push(2, 4.5);
  EXPECT_FALSE(queues.hasBefore(10));
  EXPECT_EQ(emptied(queues), Items{ 2 });
}

// Else one would do all of a bucket that holds much, and the next do it again.
TEST(FrontQueues, AfterManyItemsATurnIsOverAndTheOthersComeAsFar)
{
  FrontQueues queues;
  queues.start(1.0, Span, 2);
  const Index many = FrontQueues::ItemsOfTurn + 1000;
  for (Index item = 0; item < many; ++item)
  {
    queues.group(0).best.push(item, 1.5);
  }
  queues.group(0).best.push(many, 2.5);
  for (Index item : { many + 1, many + 2 })
  {
    queues.group(1).best.push(item, item - many + 0.5);
  }
  const Items items = emptied(queues);
  ASSERT_EQ(items.size(), many + 3u);
  const auto placeOf = [&](Index item)
  { return std::find(items.begin(), items.end(), item) - items.begin(); };
  EXPECT_NEAR(placeOf(many + 1), FrontQueues::ItemsOfTurn, 3);
  EXPECT_EQ(placeOf(many), many + 1);
  EXPECT_EQ(placeOf(many + 2), many + 2);
}

TEST(FrontQueues, ManyBucketsLeaveRoomForFewerGroups)
{
  FrontQueues queues;
  queues.start(1.0, 1e4, 1000);
  EXPECT_EQ(queues.numberOfGroups(), 4u);
  queues.start(1.0, 1e9, 1000);
  EXPECT_EQ(queues.numberOfGroups(), 1u);
}

// Keys of one bucket, in any order, and an item that is queued again with a lower key.
// Several of one queue are taken together, but none from the end on.
TEST(FrontQueues, ByValueTheLeastKeyComesFirst)
{
  FrontQueues queues;
  queues.start(1.0, Span, 1, QueueOrder::ByValue);
  FrontGroup& group = queues.group(0);
  group.best.push(1, 0.7);
  group.best.push(2, 0.3);
  group.best.push(3, 0.5);
  group.best.push(1, 0.1);
  group.best.push(4, 3.5);
  group.secondary.push(5, 0.4);
  group.secondary.push(6, 0.5);
  EXPECT_EQ(emptied(queues, queues.endOfMarch(0.5)), (Items{ 1, 2, 5 }));
  EXPECT_EQ(queues.nextKey(), 0.5);
  EXPECT_EQ(emptied(queues, queues.endOfMarch(3.0)), (Items{ 3, 1, 6 }));
  EXPECT_EQ(queues.nextKey(), 3.5);
  EXPECT_EQ(emptied(queues), (Items{ 4 }));
  EXPECT_EQ(queues.nextKey(), std::numeric_limits<double>::infinity());
}

// An item may be there several times, and counts once; what may gain by others comes after them.
TEST(FrontQueues, ByValueOnlyWhatWaitsAndGainsNothingIsTakenTogether)
{
  FrontQueues queues;
  queues.start(10.0, Span, 1, QueueOrder::ByValue);
  FrontGroup& group = queues.group(0);
  group.best.push(1, 0.7);
  group.best.push(2, 0.3);
  group.best.push(1, 0.1);
  group.best.push(3, 0.2);
  group.best.push(4, 0.8);
  std::array<Index, 8> room;
  Items taken;
  const auto isWaiting = [&](Index item)
  { return std::find(taken.begin(), taken.end(), item) == taken.end(); };
  const auto areApart = [](Index item, std::span<const Index> others)
  { return item != 2 || others.empty(); };
  const auto take = [&]
  {
    EXPECT_TRUE(queues.hasBefore(Always));
    const std::span<const Index> some = queues.take(room, isWaiting, areApart);
    taken.insert(taken.end(), some.begin(), some.end());
    return Items(some.begin(), some.end());
  };
  EXPECT_EQ(take(), (Items{ 1, 3 }));
  EXPECT_EQ(take(), (Items{ 2, 4 }));
  EXPECT_FALSE(queues.hasBefore(Always));
}

TEST(FrontQueues, GroupsOfVerticesNeedOneForEachPart)
{
  constexpr std::size_t size = FrontQueues::VerticesOfDenseGroup;
  FrontQueues queues;
  queues.start(1.0, Span, 3);
  EXPECT_FALSE(queues.groupByVertex(3 * size + 1));
  EXPECT_EQ(queues.groupOfVertex(2 * size), 0u);
  EXPECT_TRUE(queues.groupByVertex(3 * size));
  EXPECT_EQ(queues.groupOfVertex(2 * size - 1), 1u);
  EXPECT_EQ(queues.groupOfVertex(2 * size), 2u);
  // A later march has groups of fronts again.
  queues.start(1.0, Span, 3);
  EXPECT_EQ(queues.groupOfVertex(2 * size), 0u);
}

namespace
{

/** Pushes keys and takes the least ones, at random. @param keyOf  gives the key of a step, from the
 * last one taken */
template <class KeyOf>
void expectTheLeastFirst(const KeyOf& keyOf)
{
  constexpr int steps = 40000;
  std::mt19937 random(5);
  RadixHeap heap;
  std::set<std::pair<double, Index>> known;
  double last = 0.0;
  for (int step = 0; step < steps; ++step)
  {
    // It grows at first and shrinks at last.
    if (heap.isEmpty() || static_cast<int>(random() % steps) > step)
    {
      const double key = keyOf(random, last);
      heap.push(static_cast<Index>(step), key);
      known.emplace(std::max(key, 0.0), static_cast<Index>(step));
    }
    else
    {
      last = heap.first().key();
      known.erase({ last, heap.first().item });
      heap.pop();
    }
    if (step == steps / 2)
    {
      const auto isOdd = [](Index item) { return item % 2 == 1; };
      EXPECT_EQ(heap.remove(isOdd),
        std::erase_if(known, [&](const auto& entry) { return isOdd(entry.second); }));
    }
    ASSERT_EQ(heap.isEmpty(), known.empty());
    if (!heap.isEmpty())
    {
      ASSERT_EQ(heap.first().key(), known.begin()->first);
      ASSERT_TRUE(known.contains({ heap.first().key(), heap.first().item }));
    }
  }
  std::size_t left = 0;
  heap.visit([&](Index) { ++left; });
  EXPECT_EQ(left, known.size());
  heap.clear();
  EXPECT_TRUE(heap.isEmpty());
}

}

TEST(RadixHeap, HasTheLeastKeyFirst)
{
  std::lognormal_distribution<double> spread(0.0, 4.0);
  // As in a march: a little more than the last one, by orders of magnitude.
  expectTheLeastFirst([&](auto& random, double last) { return last + spread(random); });
  expectTheLeastFirst([](auto& random, double) { return 0.001 * (random() % 1000000); });
}

TEST(RadixHeap, TakesKeysBelowThoseTaken)
{
  double next = 1e6;
  expectTheLeastFirst([&](auto&, double) { return next -= 1.0; });
  expectTheLeastFirst(
    [](auto& random, double last) { return random() % 4 == 0 ? 0.5 * last : last + 1.0; });
}

// Each of these took a time in proportion to what waits: equal keys above a front, and others
// between them and those of the next bucket.
TEST(RadixHeap, TakesManyEqualKeysWithoutMovingThem)
{
  constexpr Index many = 1000000;
  RadixHeap heap;
  heap.push(0, 0.0);
  for (Index i = 0; i < many; ++i)
  {
    heap.push(i, 100.0);
  }
  for (int step = 0; step < 20000; ++step)
  {
    const double key = heap.first().key();
    ASSERT_LT(key, 100.0);
    heap.pop();
    heap.push(0, key + 1e-3);
  }
  heap.clear();
  for (Index i = 0; i < many; ++i)
  {
    heap.push(i, 0.5);
  }
  for (Index i = 0; i < 100000; ++i)
  {
    heap.push(i, 0.9 + 1e-7 * i);
  }
  EXPECT_EQ(heap.first().key(), 0.5);
  // What is taken gives its room back.
  while (!heap.isEmpty())
  {
    heap.pop();
  }
  heap.clear();
  EXPECT_LT(heap.bytes(), 100u * many);
}

// Each key is below all others, so every few become a radix heap of their own, which is taken over
// later; if it were not, there would be 60,000.
TEST(RadixHeap, TakesManyKeysThatFall)
{
  constexpr Index many = 1000000;
  RadixHeap heap;
  for (Index i = 0; i < many; ++i)
  {
    heap.push(i, 1.0 * (many - i));
    ASSERT_EQ(heap.first().item, i);
  }
  EXPECT_LT(heap.bytes(), 60u * many);
  for (Index i = many; i > 0; --i)
  {
    ASSERT_EQ(heap.first().item, i - 1);
    heap.pop();
  }
  EXPECT_TRUE(heap.isEmpty());
}

// Levels that grow after they were made are not taken over. With a look at each of 5,000 this took
// eighteen times as long.
TEST(RadixHeap, FindsTheLevelOfAKeyAmongMany)
{
  constexpr Index levels = 5000;
  constexpr Index many = 500000;
  RadixHeap heap;
  double least = 1e6;
  Index item = 0;
  for (Index level = 0; level < levels; ++level)
  {
    for (Index i = 0; i < 60; ++i)
    {
      heap.push(item++, i < 17 ? least - 17.0 + i : least - 1.0 + 0.01 * i);
    }
    least -= 17.0;
  }
  for (Index i = 0; i < many; ++i)
  {
    heap.push(item++, 1e6 + i);
  }
  double last = 0.0;
  for (Index i = 0; i < item; ++i)
  {
    ASSERT_GE(heap.first().key(), last);
    last = heap.first().key();
    heap.pop();
  }
  EXPECT_TRUE(heap.isEmpty());
}

TEST(RadixHeap, TakesEqualKeysAndEnds)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  expectTheLeastFirst([](auto& random, double) { return random() % 3; });
  expectTheLeastFirst([](auto&, double) { return 7.0; });
  expectTheLeastFirst(
    [](auto& random, double) {
      return std::array{ -1e-300, 0.0, 1e-300, 5e-324, 1e300, infinity }[random() % 6];
    });
}
