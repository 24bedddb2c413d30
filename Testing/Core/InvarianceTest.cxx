// One field, whatever the numbering, the position in space and the unit of length.

#include "FastMarchingSolver.h"
#include "Solving.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

const std::vector<Index> seedPoints{ 17, 4000, 20000 };

class OnBunny : public ::testing::TestWithParam<int>
{
protected:
  /** Distances from the first seeds in the list, as many as the test's parameter says. */
  std::vector<double> solve(const Surface& surface, const std::vector<Index>& newId)
  {
    const auto mesh = meshOf(surface);
    std::vector<Seed> seeds;
    for (int s = 0; s < this->GetParam(); ++s)
    {
      seeds.push_back(seedAt(*mesh, newId.empty() ? seedPoints[s] : newId[seedPoints[s]]));
    }
    return distances<FastMarchingSolver>(mesh, seeds);
  }

  void expectSame(const std::vector<double>& d, const std::vector<Index>& newId, double scale)
  {
    std::size_t reached = 0;
    for (std::size_t i = 0; i < this->expected.size(); ++i)
    {
      const double value = d[newId.empty() ? i : newId[i]] / scale;
      if (std::isfinite(this->expected[i]) || std::isfinite(value))
      {
        ASSERT_NEAR(value, this->expected[i], 1e-9 * this->expected[i] + 1e-15);
        ++reached;
      }
    }
    EXPECT_GT(reached, 30000u);
  }

  const Surface bunny = readOff(GEODESICS_OFF_DIRECTORY "/Bunny.off");
  const std::vector<double> expected = solve(bunny, {});
};

}

TEST_P(OnBunny, ShufflingChangesNothing)
{
  for (unsigned seed : { 1u, 2u, 3u })
  {
    std::vector<Index> newId;
    const Surface other = shuffled(this->bunny, seed, newId);
    this->expectSame(this->solve(other, newId), newId, 1.0);
  }
}

TEST_P(OnBunny, ScalingScales)
{
  for (double scale : { 1e-6, 1e6 })
  {
    Surface other = this->bunny;
    for (Vector3& p : other.points)
    {
      p = scale * p;
    }
    this->expectSame(this->solve(other, {}), {}, scale);
  }
}

// Rotation rounds every coordinate; what rounding does to a nearly flat update is its square root.
TEST_P(OnBunny, RotatingChangesNothing)
{
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  Surface other = this->bunny;
  for (Vector3& p : other.points)
  {
    const Vector3 q{ c * p.x - s * p.y, s * p.x + c * p.y, p.z };
    p = { q.x, c * q.y - s * q.z, s * q.y + c * q.z };
  }
  this->expectSame(this->solve(other, {}), {}, 1.0);
}

TEST_P(OnBunny, ReversingOrientationChangesNothing)
{
  Surface other = this->bunny;
  std::mt19937 random(5);
  for (Triangle& t : other.triangles)
  {
    if (random() % 2 == 0)
    {
      std::swap(t[0], t[1]);
    }
  }
  this->expectSame(this->solve(other, {}), {}, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, OnBunny, ::testing::Values(1, 3));
