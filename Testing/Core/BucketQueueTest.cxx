// The queue of the march: what comes first, and in what order.

#include "BucketQueue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace geodesic;

namespace
{

/** All that waits, in the order it is handed out. */
std::vector<Index> emptied(BucketQueue& queue)
{
  std::vector<Index> items;
  std::array<Index, 12> room;
  while (queue.hasBefore(std::numeric_limits<std::uint64_t>::max()))
  {
    for (Index item : queue.take(room))
    {
      items.push_back(item);
    }
  }
  return items;
}

constexpr int BlockBits = 4;

/** Returns the bucket of each item. */
std::vector<Index> pushAtRandom(BucketQueue& queue, Index numberOfItems)
{
  std::mt19937 random(numberOfItems);
  std::vector<Index> buckets;
  for (Index item = 0; item < numberOfItems; ++item)
  {
    buckets.push_back(1 + random() % 5);
  }
  std::vector<Index> order(numberOfItems);
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), random);
  queue.start(10.0, 100.0, BlockBits);
  for (Index item : order)
  {
    queue.push(item, 10.0 * buckets[item] + 1.0);
  }
  return buckets;
}

}

// And backwards in every second bucket, so that the next one begins where one ended.
TEST(BucketQueue, ABucketIsHandedOutBlockByBlock)
{
  BucketQueue queue;
  const std::vector<Index> buckets = pushAtRandom(queue, 2000);
  const std::vector<Index> items = emptied(queue);
  ASSERT_EQ(std::set<Index>(items.begin(), items.end()).size(), buckets.size());
  ASSERT_EQ(items.size(), buckets.size());
  for (std::size_t i = 1; i < items.size(); ++i)
  {
    const auto placeOf = [&](Index item)
    {
      const int block = static_cast<int>(item >> BlockBits);
      return std::pair(buckets[item], buckets[item] % 2 == 0 ? block : -block);
    };
    EXPECT_LE(placeOf(items[i - 1]), placeOf(items[i]));
  }
}

TEST(BucketQueue, FewItemsOfManyBlocksKeepTheOrderTheyCameIn)
{
  BucketQueue queue;
  queue.start(1.0, 10.0, BlockBits);
  const std::vector<Index> items{ 3000000000u, 5, 70, 1000000 };
  for (Index item : items)
  {
    queue.push(item, 2.5);
  }
  EXPECT_EQ(emptied(queue), items);
}
