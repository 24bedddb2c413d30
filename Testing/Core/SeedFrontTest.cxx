// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Labels and starts of seeds on a surface in two pieces: those of the whole surface, after as many
// messages for thousands of seeds as for a few.
#include "solve/SeedFront.h"
#include "Solving.h"
#include "Surfaces.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/Partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <barrier>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <span>
#include <thread>
#include <tuple>
#include <vector>

namespace geodesic::testing
{
namespace
{

/** What two pieces send each other. */
struct Channel
{
  std::barrier<> together{ 2 };
  std::array<std::vector<double>, 2> numbers;
  std::array<std::vector<StartValue>, 2> values;
};

/** One of two pieces which both have all of a surface. The first one owns it. */
class Piece final : public Partition
{
public:
  Piece(Channel& channel, std::size_t number)
    : Both(channel)
    , Number(number)
  {
  }

  std::size_t number() const override { return this->Number; }
  bool isDivided() const override { return true; }
  bool owns(Index) const override { return this->Number == 0; }
  std::vector<double> gather(std::span<const double> own) override
  {
    ++this->Calls;
    this->Both.numbers[this->Number].assign(own.begin(), own.end());
    this->Both.together.arrive_and_wait();
    std::vector<double> all = this->Both.numbers[0];
    all.insert(all.end(), this->Both.numbers[1].begin(), this->Both.numbers[1].end());
    this->Both.together.arrive_and_wait();
    return all;
  }
  std::vector<StartValue> exchange(std::span<const StartValue> own) override
  {
    ++this->Calls;
    this->Both.values[this->Number].assign(own.begin(), own.end());
    this->Both.together.arrive_and_wait();
    std::vector<StartValue> others = this->Both.values[1 - this->Number];
    this->Both.together.arrive_and_wait();
    return others;
  }
  /** The number of collective calls. */
  int calls() const { return this->Calls; }

private:
  Channel& Both;
  std::size_t Number;
  int Calls = 0;
};

/** The fronts of both pieces, and the collective calls that one made. */
struct Fronts
{
  std::array<SeedFront, 2> of;
  std::array<int, 2> calls;
};

Fronts frontsOf(
  const TriangleMesh& mesh, const std::array<std::vector<Seed>, 2>& seeds, bool isCancelled)
{
  Channel channel;
  Fronts fronts;
  const auto make = [&](std::size_t number)
  {
    Piece piece(channel, number);
    const auto goesOn = [&] { return !isCancelled || number == 1; };
    makeSeedFront(
      mesh, ClosedTriangles(mesh, {}), seeds[number], false, goesOn, piece, fronts.of[number]);
    fronts.calls[number] = piece.calls();
  };
  std::thread other([&] { make(1); });
  make(0);
  other.join();
  return fronts;
}

using LabelKey = std::tuple<Index, FrontShape, double, double, double, double>;

LabelKey keyOf(const Label& label)
{
  return { label.seed, label.shape, label.position.x, label.position.y, label.position.z,
    label.length };
}

/** What tells a front's labels, in their order. */
std::vector<LabelKey> labelsOf(const SeedFront& front)
{
  std::vector<LabelKey> keys;
  std::transform(front.labels.begin(), front.labels.end(), std::back_inserter(keys), keyOf);
  return keys;
}

using StartKey = std::tuple<LabelKey, Index, double>;

/** What tells starts, each once and in ascending order. */
std::vector<StartKey> startsOf(std::initializer_list<const SeedFront*> fronts)
{
  std::vector<StartKey> keys;
  for (const SeedFront* front : fronts)
  {
    for (const FrontStart& start : front->starts)
    {
      keys.emplace_back(keyOf(front->labels[start.label]), start.vertex, start.length);
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

/** Points, edges and regions by turns; the regions are single vertices and squares. */
std::vector<Seed> mixedSeeds(const TriangleMesh& mesh, std::size_t count, Index side)
{
  std::vector<Seed> seeds;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Index vertex = 7 * static_cast<Index>(i);
    const SurfacePoint place = mesh.pointAtVertex(vertex);
    switch (i % 4)
    {
      case 0:
        seeds.push_back(Seed::atPosition(mesh.position(vertex), { place }));
        break;
      case 1:
        seeds.push_back(
          Seed::alongCurve({ place, mesh.pointAtVertex(mesh.ring(vertex)[0].neighbour()) }));
        break;
      case 2:
        seeds.push_back(Seed::onRegion({ vertex }));
        break;
      default:
        seeds.push_back(Seed::onRegion({ vertex, vertex + 1, vertex + side, vertex + side + 1 }));
        break;
    }
  }
  return seeds;
}

/** The parts of seeds that two pieces have: curves are on the one or the other, vertices of regions
 * too. */
std::array<std::vector<Seed>, 2> dividedSeeds(const std::vector<Seed>& whole)
{
  std::array<std::vector<Seed>, 2> parts{ whole, whole };
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    const std::size_t absent = i / 4 % 2;
    if (whole[i].kind != Seed::Kind::Region)
    {
      parts[absent][i].points.clear();
      continue;
    }
    parts[absent][i].vertices.resize(whole[i].vertices.size() / 2);
    std::vector<Index>& rest = parts[1 - absent][i].vertices;
    rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(rest.size() / 2));
  }
  return parts;
}

constexpr int Side = 120;

}

TEST(SeedFront, OnPiecesItIsThatOfTheWholeSurface)
{
  const auto mesh = meshOf(hillyGrid(Side, Side));
  const std::vector<Seed> seeds = mixedSeeds(*mesh, 400, Side + 1);
  Partition whole;
  SeedFront expected;
  makeSeedFront(
    *mesh, ClosedTriangles(*mesh, {}), seeds, false, [] { return true; }, whole, expected);
  const Fronts fronts = frontsOf(*mesh, dividedSeeds(seeds), false);
  // The round labels of one region are in an order of their own.
  std::vector<LabelKey> labels = labelsOf(expected);
  std::vector<LabelKey> onPieces = labelsOf(fronts.of[0]);
  EXPECT_EQ(onPieces, labelsOf(fronts.of[1]));
  EXPECT_TRUE(std::is_sorted(onPieces.begin(), onPieces.end(),
    [](const LabelKey& a, const LabelKey& b) { return std::get<0>(a) < std::get<0>(b); }));
  std::sort(labels.begin(), labels.end());
  std::sort(onPieces.begin(), onPieces.end());
  EXPECT_EQ(onPieces, labels);
  EXPECT_EQ(startsOf({ &fronts.of[0], &fronts.of[1] }), startsOf({ &expected }));
}

TEST(SeedFront, OnPiecesVeryManySeedsTakeNoMoreMessages)
{
  const auto mesh = meshOf(hillyGrid(Side, Side));
  const Fronts few = frontsOf(*mesh, dividedSeeds(mixedSeeds(*mesh, 8, Side + 1)), false);
  const Fronts many = frontsOf(*mesh, dividedSeeds(mixedSeeds(*mesh, 2000, Side + 1)), false);
  EXPECT_EQ(few.calls[0], few.calls[1]);
  EXPECT_EQ(many.calls, few.calls);
  EXPECT_LT(few.calls[0], 10);
}

// Otherwise one piece would wait for ever.
TEST(SeedFront, ACancelledPieceAnswersTheOther)
{
  const auto mesh = meshOf(hillyGrid(Side, Side));
  std::vector<Seed> seeds = mixedSeeds(*mesh, 8, Side + 1);
  const SurfacePoint a = mesh->pointAtVertex(0);
  const SurfacePoint b = mesh->pointAtVertex(1);
  for (std::size_t i = 0; i < 2 * PointsOfFrontReport; ++i)
  {
    seeds.push_back(Seed::alongCurve({ a, b }));
  }
  const Fronts fronts = frontsOf(*mesh, dividedSeeds(seeds), true);
  EXPECT_EQ(fronts.calls[0], fronts.calls[1]);
  // It has not made its fronts to the end.
  EXPECT_LT(fronts.of[0].starts.size(), fronts.of[1].starts.size());
}

}
