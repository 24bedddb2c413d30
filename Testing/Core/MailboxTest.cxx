// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "threads/Mailbox.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <thread>
#include <vector>

using namespace geodesic;

namespace
{

using Box = Mailbox<int, 8>;

std::vector<int> takenFrom(Box& box)
{
  std::vector<int> taken;
  box.takeAll([&](int letter) { taken.push_back(letter); });
  return taken;
}

std::vector<int> leftIn(const Box& box)
{
  std::vector<int> left;
  box.visitLeft([&](int letter) { left.push_back(letter); });
  return left;
}

}

TEST(Mailbox, KeepsTheOrder)
{
  Box box;
  for (const int letter : { 3, 1, 2 })
  {
    EXPECT_TRUE(box.put(letter));
  }
  EXPECT_EQ(leftIn(box), (std::vector<int>{ 3, 1, 2 }));
  EXPECT_EQ(takenFrom(box), (std::vector<int>{ 3, 1, 2 }));
  EXPECT_TRUE(leftIn(box).empty());
  EXPECT_TRUE(takenFrom(box).empty());
}

TEST(Mailbox, RefusesWhatFindsNoRoom)
{
  Box box;
  for (int letter = 0; letter < 8; ++letter)
  {
    EXPECT_TRUE(box.put(letter));
  }
  EXPECT_FALSE(box.put(8));
  EXPECT_EQ(takenFrom(box).size(), 8u);
  EXPECT_TRUE(box.put(9));
  EXPECT_EQ(leftIn(box), (std::vector<int>{ 9 }));
}

TEST(Mailbox, LosesNothingBetweenThreads)
{
  constexpr int Letters = 100000;
  Box box;
  std::vector<int> taken;
  std::jthread reader(
    [&]
    {
      while (taken.size() < Letters)
      {
        const std::size_t before = taken.size();
        box.takeAll([&](int letter) { taken.push_back(letter); });
        if (taken.size() == before)
        {
          std::this_thread::yield();
        }
      }
    });
  for (int letter = 0; letter < Letters; ++letter)
  {
    while (!box.put(letter))
    {
      std::this_thread::yield();
    }
  }
  reader.join();
  std::vector<int> all(Letters);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(taken, all);
}

// A march ends on the word of the writer that nothing is left.
TEST(Mailbox, TheWriterSeesWhatIsLeftBesideTheReader)
{
  constexpr int Letters = 20000;
  Box box;
  std::atomic<int> last = 0;
  std::jthread reader(
    [&]
    {
      while (last < Letters)
      {
        box.takeAll([&](int letter) { last = letter; });
        std::this_thread::yield();
      }
    });
  int least = 0;
  for (int letter = 1; letter <= Letters; letter += box.put(letter) ? 1 : 0)
  {
    const int takenBefore = last;
    const std::vector<int> left = leftIn(box);
    const int takenAfter = last;
    least = left.empty() ? letter : left.front();
    // The reader notes a letter before the box is told that it was taken.
    EXPECT_GT(least, takenBefore - 8);
    EXPECT_LE(least, takenAfter + 1);
    EXPECT_TRUE(left.empty() || left.back() == letter - 1);
  }
}
