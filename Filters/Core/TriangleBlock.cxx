#include "TriangleBlock.h"

#include "LabelMargin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geodesic
{
namespace
{

/** More than what rounding to a float can change. */
double roundingOf(double x)
{
  return std::abs(x) * std::numeric_limits<float>::epsilon() +
    std::numeric_limits<float>::denorm_min();
}

double roundedUp(double x)
{
  return x + roundingOf(x);
}

double roundedDown(double x)
{
  constexpr double largest = std::numeric_limits<float>::max();
  const double down = x - roundingOf(x);
  return largest < down ? largest : down;
}

}

TriangleBlock::TriangleBlock(
  std::span<const Triangle> triangles, std::span<const Vector3> positions)
  : Triangles(triangles.size())
{
  struct Points
  {
    void set(std::size_t i, const Vector3& p)
    {
      this->X[i] = p.x;
      this->Y[i] = p.y;
      this->Z[i] = p.z;
    }
    Vector3 operator[](std::size_t i) const { return { this->X[i], this->Y[i], this->Z[i] }; }

    Numbers X;
    Numbers Y;
    Numbers Z;
  };
  std::array<Points, 3> corners;
  for (std::size_t i = 0; i < this->Triangles; ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      corners[corner].set(i, positions[triangles[i][corner]]);
    }
  }
  for (std::size_t i = 0; i < this->Triangles; ++i)
  {
    const Vector3 a = corners[0][i];
    const Vector3 b = corners[1][i];
    const Vector3 c = corners[2][i];
    this->Sides[0][i] = norm(c - b);
    this->Sides[1][i] = norm(a - c);
    this->Sides[2][i] = norm(b - a);
    this->DoubleAreas[i] = norm(cross(b - a, c - a));
  }
  for (std::size_t i = 0; i < this->Triangles; ++i)
  {
    const double longer = std::max(this->Sides[1][i], this->Sides[2][i]);
    this->LongestSides[i] = std::max(this->Sides[0][i], longer);
  }
}

void TriangleBlock::measure(std::span<TriangleMeasure> measures) const
{
  Numbers slacks;
  Numbers longestSides;
  Numbers margins;
  for (std::size_t i = 0; i < this->Triangles; ++i)
  {
    const double longest = this->LongestSides[i];
    // A triangle whose longest side is 0 has no height.
    const double leastHeight =
      this->DoubleAreas[i] / std::max(longest, std::numeric_limits<double>::min());
    slacks[i] = roundedDown(2.0 * leastHeight - longest);
    longestSides[i] = roundedUp(longest);
    margins[i] = roundedUp(labelMargin(longest, leastHeight));
  }
  for (std::size_t i = 0; i < this->Triangles; ++i)
  {
    measures[i] = { static_cast<float>(slacks[i]), static_cast<float>(longestSides[i]),
      static_cast<float>(margins[i]) };
  }
}

double TriangleBlock::sumOfLengths() const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < this->Triangles; ++i)
  {
    sum += this->Sides[0][i] + this->Sides[1][i] + this->Sides[2][i];
  }
  return sum;
}

double TriangleBlock::longestSide() const
{
  // Two at a time, the last with itself where it is alone.
  Pair longest{};
  for (std::size_t i = 0; i < this->Triangles; i += 2)
  {
    const std::size_t next = std::min(i + 1, this->Triangles - 1);
    longest = largest(longest, Pair{ this->LongestSides[i], this->LongestSides[next] });
  }
  return std::max(longest[0], longest[1]);
}

}
