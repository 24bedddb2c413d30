#ifndef geodesic_TriangleMeasure_h
#define geodesic_TriangleMeasure_h

#include "LabelMargin.h"
#include "Lanes.h"
#include "Vector3.h"

#include <array>
#include <limits>

namespace geodesic
{

/** What the rings of its corners tell of the size of a triangle. */
struct TriangleMeasure
{
  /** RingEntry::isThin */
  bool isThin() const { return this->slack < -0.5f * this->longestSide; }

  /** RingEntry::slack */
  float slack;
  /** Rounded up. */
  float longestSide;
  /** labelMargin(), rounded up. */
  float margin;
};

/** The measures of two triangles at once, of corners @p a, @p b and @p c. */
inline std::array<TriangleMeasure, 2> measuresOf(
  const Vector3Of<Pair>& a, const Vector3Of<Pair>& b, const Vector3Of<Pair>& c)
{
  // More than what rounding to a float changes.
  constexpr double relative = std::numeric_limits<float>::epsilon();
  constexpr double absolute = std::numeric_limits<float>::denorm_min();
  const auto roundedUp = [](Pair x) { return x * (1.0 + relative) + absolute; };

  const Vector3Of<Pair> ab = b - a;
  const Vector3Of<Pair> ac = c - a;
  const Pair squareB = dot(ab, ab);
  const Pair squareC = dot(ac, ac);
  const Pair product = dot(ab, ac);
  const Pair squareA = squareB + squareC - 2.0 * product;
  const Pair longest = root(largest(squareA, largest(squareB, squareC)));
  const Pair doubleArea = root(largest(squareB * squareC - product * product, Pair()));
  // A triangle whose longest side is 0 has no height.
  const Pair leastHeight =
    doubleArea / largest(longest, Pair() + std::numeric_limits<double>::min());
  // A height near 0 is off by up to 3e-8 of the side, by the rounding of the squares.
  const Pair slack = 2.0 * leastHeight - longest * (1.0 + 1.5 * relative) - absolute;
  const Pair slackDown = least(slack, Pair() + std::numeric_limits<float>::max());
  const Pair longestUp = roundedUp(longest);
  const Pair marginUp = roundedUp(labelMargin(longest, leastHeight));
  const auto ofNumber = [&](int i) -> TriangleMeasure
  {
    return { static_cast<float>(slackDown[i]), static_cast<float>(longestUp[i]),
      static_cast<float>(marginUp[i]) };
  };
  return { ofNumber(0), ofNumber(1) };
}

}

#endif
