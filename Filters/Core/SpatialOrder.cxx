#include "SpatialOrder.h"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>
#include <utility>

namespace geodesic
{
namespace
{

constexpr int BitsPerAxis = 21;
constexpr int RadixBits = 11;
constexpr int RadixPasses = 3;

struct Keyed
{
  std::uint64_t code;
  Index id;
};

/** Moves the low 21 bits of @p value to every third bit. */
std::uint64_t spread(std::uint64_t value)
{
  value = (value | value << 32) & 0x1f00000000ffffull;
  value = (value | value << 16) & 0x1f0000ff0000ffull;
  value = (value | value << 8) & 0x100f00f00f00f00full;
  value = (value | value << 4) & 0x10c30c30c30c30c3ull;
  value = (value | value << 2) & 0x1249249249249249ull;
  return value;
}

std::vector<Keyed> mortonCodes(std::span<const Vector3> points, std::span<const std::uint8_t> used)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3 low{ infinity, infinity, infinity };
  Vector3 high{ -infinity, -infinity, -infinity };
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (used[i])
    {
      const Vector3& p = points[i];
      low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
      high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
      ++count;
    }
  }
  const Vector3 size = high - low;
  const double extent = std::max({ size.x, size.y, size.z });
  const double scale = extent > 0.0 ? ((1 << BitsPerAxis) - 1) / extent : 0.0;

  std::vector<Keyed> keyed;
  keyed.reserve(count);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (used[i])
    {
      const Vector3 cell = scale * (points[i] - low);
      const std::uint64_t code = spread(static_cast<std::uint64_t>(cell.x)) |
        spread(static_cast<std::uint64_t>(cell.y)) << 1 |
        spread(static_cast<std::uint64_t>(cell.z)) << 2;
      keyed.push_back({ code, static_cast<Index>(i) });
    }
  }
  return keyed;
}

constexpr int lowestSortedBit = 3 * BitsPerAxis - RadixBits * RadixPasses;

/** Stable sort by the leading RadixBits * RadixPasses bits of the code. */
void radixSort(std::vector<Keyed>& keyed)
{
  constexpr std::size_t digits = std::size_t{ 1 } << RadixBits;
  std::vector<Keyed> other(keyed.size());
  for (int pass = 0; pass < RadixPasses; ++pass)
  {
    const int shift = lowestSortedBit + pass * RadixBits;
    std::array<std::size_t, digits + 1> start{};
    for (const Keyed& k : keyed)
    {
      ++start[(k.code >> shift & (digits - 1)) + 1];
    }
    for (std::size_t d = 0; d < digits; ++d)
    {
      start[d + 1] += start[d];
    }
    for (const Keyed& k : keyed)
    {
      other[start[k.code >> shift & (digits - 1)]++] = k;
    }
    keyed.swap(other);
  }
}

/** Orders the runs that the leading bits leave equal, down to the coordinates themselves. */
void sortRuns(std::vector<Keyed>& keyed, std::span<const Vector3> points)
{
  const auto before = [&](const Keyed& a, const Keyed& b)
  {
    const Vector3& p = points[a.id];
    const Vector3& q = points[b.id];
    return std::tie(a.code, p.x, p.y, p.z, a.id) < std::tie(b.code, q.x, q.y, q.z, b.id);
  };
  for (auto first = keyed.begin(); first != keyed.end();)
  {
    auto last = first + 1;
    while (last != keyed.end() && last->code >> lowestSortedBit == first->code >> lowestSortedBit)
    {
      ++last;
    }
    if (last - first > 1)
    {
      std::sort(first, last, before);
    }
    first = last;
  }
}

}

std::vector<Index> spatialOrder(std::span<const Vector3> points, std::span<const std::uint8_t> used)
{
  std::vector<Keyed> keyed = mortonCodes(points, used);
  radixSort(keyed);
  sortRuns(keyed, points);
  std::vector<Index> order(keyed.size());
  std::transform(keyed.begin(), keyed.end(), order.begin(), [](const Keyed& k) { return k.id; });
  return order;
}

}
