// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Secondary values that several threads share: each is found under its number, none moves, and a
// reader never sees a distance below that of its label.

#include "march/SharedSecondaryValues.h"
#include "base/CallsTogether.h"
#include "march/SecondaryValues.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

using namespace geodesic;

TEST(SharedSecondaryValues, GoOnFromThoseOfOneThread)
{
  SecondaryValues begun;
  begun.start(100);
  std::map<std::pair<Index, Index>, double> expected;
  for (Index vertex = 0; vertex < 100; ++vertex)
  {
    for (Index label = 0; label < vertex % 5; ++label)
    {
      const double distance = 10.0 * vertex + label;
      begun.secondary(begun.add(vertex, label)).distance = distance;
      expected[{ vertex, label }] = distance;
    }
  }
  SharedSecondaryValues shared(begun);
  for (Index vertex = 0; vertex < 100; ++vertex)
  {
    EXPECT_EQ(shared.hasSecondary(vertex), vertex % 5 != 0);
    EXPECT_EQ(shared.find(vertex, 4), NoIndex);
  }
  for (const auto& [place, distance] : expected)
  {
    const Index number = shared.find(place.first, place.second);
    ASSERT_NE(number, NoIndex);
    EXPECT_EQ(number, begun.find(place.first, place.second))
      << "items in queues have these numbers";
    EXPECT_EQ(shared.vertexOf(number), place.first);
    EXPECT_EQ(shared.secondary(number).distance, distance);
  }
  begun.finish();
}

TEST(SharedSecondaryValues, FindsWhatSeveralThreadsAdd)
{
  constexpr Index Vertices = 30000;
  constexpr Index Labels = 6;
  SecondaryValues begun;
  begun.start(Vertices);
  SharedSecondaryValues shared(begun);
  callTogether(
    3, [](const auto&) {},
    [&](std::size_t thread)
    {
      SharedSecondaryValues::Block block;
      for (auto vertex = static_cast<Index>(thread); vertex < Vertices; vertex += 3)
      {
        for (Index label = 0; label < Labels; ++label)
        {
          const Index number = shared.add(vertex, label, block);
          SharedSecondaryValues::setDistance(shared.secondary(number), vertex + 0.1 * label);
        }
      }
      EXPECT_EQ(block.added(), Vertices / 3 * Labels);
    });
  for (Index vertex = 0; vertex < Vertices; ++vertex)
  {
    Index count = 0;
    shared.visitSecondary(vertex,
      [&](const SharedSecondaryValues::SecondaryValue& value)
      {
        ++count;
        EXPECT_EQ(value.distance, vertex + 0.1 * value.state.label());
      });
    EXPECT_EQ(count, Labels);
    EXPECT_EQ(shared.vertexOf(shared.find(vertex, Labels - 1)), vertex);
  }
}

TEST(SharedSecondaryValues, OthersNeverSeeADistanceBelowThatOfItsLabel)
{
  SecondaryValues begun;
  begun.start(1);
  SharedSecondaryValues shared(begun);
  // The place falls from a million to 1, and the label at each distance is the distance itself.
  constexpr Index First = 1000000;
  SharedSecondaryValues::Block block;
  shared.add(0, First, block);
  SharedSecondaryValues::setDistance(shared.secondary(0), First);
  std::atomic<bool> isRight = true;
  callTogether(
    2, [](const auto&) {},
    [&](std::size_t thread)
    {
      for (Index label = First; label > 0 && thread == 0; --label)
      {
        VertexState state;
        state.setLabel(label);
        SharedSecondaryValues::setState(shared.secondary(0), state);
        keepSharedInOrder();
        SharedSecondaryValues::setDistance(shared.secondary(0), label);
      }
      for (double distance = First; distance > 1.0 && thread == 1;)
      {
        distance = SharedSecondaryValues::distanceOf(shared.inPlace(0));
        keepSharedInOrder();
        const Index label = SharedSecondaryValues::stateOf(shared.inPlace(0)).label();
        isRight = isRight && distance >= label;
      }
    });
  EXPECT_TRUE(isRight);
}

TEST(SharedSecondaryValues, TooManyOfAVertexAreAnError)
{
  SecondaryValues begun;
  begun.start(2);
  SharedSecondaryValues shared(begun);
  SharedSecondaryValues::Block block;
  for (Index label = 0; label <= SharedSecondaryValues::MostOthers; ++label)
  {
    EXPECT_EQ(shared.find(1, label), NoIndex);
    shared.add(1, label, block);
  }
  EXPECT_EQ(shared.find(1, 1000), NoIndex);
  shared.add(1, 1000, block);
  EXPECT_THROW(shared.find(1, 1001), SharedSecondaryValues::TooManyValues);
}
