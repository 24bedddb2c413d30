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

struct Bounds
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3 low{ infinity, infinity, infinity };
  Vector3 high{ -infinity, -infinity, -infinity };

  void add(const Vector3& lowest, const Vector3& highest)
  {
    const auto [lx, ly, lz] = lowest;
    const auto [hx, hy, hz] = highest;
    this->low = { std::min(this->low.x, lx), std::min(this->low.y, ly), std::min(this->low.z, lz) };
    this->high = { std::max(this->high.x, hx), std::max(this->high.y, hy),
      std::max(this->high.z, hz) };
  }
};

std::vector<Keyed> mortonCodes(
  std::span<const Vector3> points, std::span<const std::uint8_t> used, const ThreadTeam& team)
{
  std::vector<Bounds> boundsOfRange(team.numberOfRanges(points.size()));
  std::vector<std::size_t> starts(boundsOfRange.size());
  team.run(points.size(),
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      Bounds bounds;
      std::size_t count = 0;
      for (std::size_t i = first; i < last; ++i)
      {
        if (used[i])
        {
          bounds.add(points[i], points[i]);
          ++count;
        }
      }
      boundsOfRange[range] = bounds;
      starts[range] = count;
    });
  Bounds bounds;
  for (const Bounds& other : boundsOfRange)
  {
    bounds.add(other.low, other.high);
  }
  const Vector3 size = bounds.high - bounds.low;
  const double extent = std::max({ size.x, size.y, size.z });
  const double scale = extent > 0.0 ? ((1 << BitsPerAxis) - 1) / extent : 0.0;

  std::vector<Keyed> keyed(startsOf(starts));
  team.run(points.size(),
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      std::size_t next = starts[range];
      for (std::size_t i = first; i < last; ++i)
      {
        if (used[i])
        {
          const Vector3 cell = scale * (points[i] - bounds.low);
          const std::uint64_t code = spread(static_cast<std::uint64_t>(cell.x)) |
            spread(static_cast<std::uint64_t>(cell.y)) << 1 |
            spread(static_cast<std::uint64_t>(cell.z)) << 2;
          keyed[next++] = { code, static_cast<Index>(i) };
        }
      }
    });
  return keyed;
}

constexpr int lowestSortedBit = 3 * BitsPerAxis - RadixBits * RadixPasses;

/** Stable sort by the leading RadixBits * RadixPasses bits of the code. */
void radixSort(std::vector<Keyed>& keyed, const ThreadTeam& team)
{
  constexpr std::size_t digits = std::size_t{ 1 } << RadixBits;
  std::vector<Keyed> other(keyed.size());
  std::vector<std::array<std::size_t, digits>> startsOfRange(team.numberOfRanges(keyed.size()));
  for (int pass = 0; pass < RadixPasses; ++pass)
  {
    const auto digitOf = [shift = lowestSortedBit + pass * RadixBits](const Keyed& k)
    { return k.code >> shift & (digits - 1); };
    team.run(keyed.size(),
      [&](std::size_t range, std::size_t first, std::size_t last)
      {
        startsOfRange[range].fill(0);
        for (std::size_t i = first; i < last; ++i)
        {
          ++startsOfRange[range][digitOf(keyed[i])];
        }
      });
    std::size_t sum = 0;
    for (std::size_t d = 0; d < digits; ++d)
    {
      for (auto& starts : startsOfRange)
      {
        sum += std::exchange(starts[d], sum);
      }
    }
    team.run(keyed.size(),
      [&](std::size_t range, std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          other[startsOfRange[range][digitOf(keyed[i])]++] = keyed[i];
        }
      });
    keyed.swap(other);
  }
}

/** Orders the runs that the leading bits leave equal, down to the coordinates themselves. */
void sortRuns(std::vector<Keyed>& keyed, std::span<const Vector3> points, const ThreadTeam& team)
{
  const auto before = [&](const Keyed& a, const Keyed& b)
  {
    const Vector3& p = points[a.id];
    const Vector3& q = points[b.id];
    return std::tie(a.code, p.x, p.y, p.z, a.id) < std::tie(b.code, q.x, q.y, q.z, b.id);
  };
  const auto isSameRun = [&](std::size_t i, std::size_t j)
  { return keyed[i].code >> lowestSortedBit == keyed[j].code >> lowestSortedBit; };
  // A run belongs to the range that it starts in.
  std::vector<std::size_t> starts;
  for (std::size_t range = 0; range <= team.numberOfRanges(keyed.size()); ++range)
  {
    std::size_t start = team.startOf(range, keyed.size());
    while (start > 0 && start < keyed.size() && isSameRun(start - 1, start))
    {
      ++start;
    }
    starts.push_back(start);
  }
  team.run(keyed.size(),
    [&](std::size_t range, std::size_t, std::size_t)
    {
      for (std::size_t first = starts[range]; first < starts[range + 1];)
      {
        std::size_t last = first + 1;
        while (last < starts[range + 1] && isSameRun(first, last))
        {
          ++last;
        }
        if (last - first > 1)
        {
          std::sort(keyed.begin() + first, keyed.begin() + last, before);
        }
        first = last;
      }
    });
}

}

std::vector<Index> spatialOrder(
  std::span<const Vector3> points, std::span<const std::uint8_t> used, const ThreadTeam& team)
{
  std::vector<Keyed> keyed = mortonCodes(points, used, team);
  radixSort(keyed, team);
  sortRuns(keyed, points, team);
  std::vector<Index> order(keyed.size());
  team.run(order.size(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::transform(keyed.begin() + first, keyed.begin() + last, order.begin() + first,
        [](const Keyed& k) { return k.id; });
    });
  return order;
}

}
