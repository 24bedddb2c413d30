#include "SpatialOrder.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace geodesic
{
namespace
{

constexpr int BitsPerAxis = 21;
constexpr int CodeBits = 3 * BitsPerAxis;
constexpr int RadixBits = 11;
constexpr int RadixPasses = 3;

/** The leading bits of a point's code, as many as tell most points apart. */
struct Keyed
{
  std::uint32_t key;
  Index id;
};
constexpr int KeyBits = 32;

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

/** A Morton curve through the bounding cube of the points that are used. */
class MortonCurve
{
public:
  MortonCurve(
    std::span<const Vector3> points, std::span<const std::uint8_t> used, const ThreadTeam& team)
  {
    std::vector<Bounds> boundsOfRange(team.numberOfRanges(points.size()));
    team.run(points.size(),
      [&](std::size_t range, std::size_t first, std::size_t last)
      {
        Bounds bounds;
        for (std::size_t i = first; i < last; ++i)
        {
          if (used[i])
          {
            bounds.add(points[i], points[i]);
          }
        }
        boundsOfRange[range] = bounds;
      });
    Bounds bounds;
    for (const Bounds& other : boundsOfRange)
    {
      bounds.add(other.low, other.high);
    }
    const Vector3 size = bounds.high - bounds.low;
    const double extent = std::max({ size.x, size.y, size.z });
    this->Low = bounds.low;
    this->CellsPerUnit = extent > 0.0 ? ((1 << BitsPerAxis) - 1) / extent : 0.0;
  }

  std::uint64_t codeOf(const Vector3& point) const
  {
    const Vector3 cell = this->CellsPerUnit * (point - this->Low);
    return spread(static_cast<std::int64_t>(cell.x)) |
      spread(static_cast<std::int64_t>(cell.y)) << 1 |
      spread(static_cast<std::int64_t>(cell.z)) << 2;
  }

private:
  Vector3 Low;
  double CellsPerUnit;
};

BulkVector<Keyed> keysOf(std::span<const Vector3> points, std::span<const std::uint8_t> used,
  const MortonCurve& curve, const ThreadTeam& team)
{
  std::vector<std::size_t> starts(team.numberOfRanges(points.size()));
  team.run(points.size(),
    [&](std::size_t range, std::size_t first, std::size_t last) {
      starts[range] = std::accumulate(used.begin() + first, used.begin() + last, std::size_t{ 0 });
    });
  BulkVector<Keyed> keyed(startsOf(starts));
  team.run(points.size(),
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      std::size_t next = starts[range];
      for (std::size_t i = first; i < last; ++i)
      {
        if (used[i])
        {
          const std::uint64_t code = curve.codeOf(points[i]);
          keyed[next++] = { static_cast<std::uint32_t>(code >> (CodeBits - KeyBits)),
            static_cast<Index>(i) };
        }
      }
    });
  return keyed;
}

/** Stable sort by the keys. */
void radixSort(BulkVector<Keyed>& keyed, const ThreadTeam& team)
{
  constexpr std::size_t digits = std::size_t{ 1 } << RadixBits;
  BulkVector<Keyed> other(keyed.size());
  std::vector<std::array<std::size_t, digits>> startsOfRange(team.numberOfRanges(keyed.size()));
  for (int pass = 0; pass < RadixPasses; ++pass)
  {
    const auto digitOf = [shift = pass * RadixBits](const Keyed& k)
    { return k.key >> shift & (digits - 1); };
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

/** Orders points of equal keys by the whole of their codes, down to the coordinates themselves. */
class RunSorter
{
public:
  RunSorter(std::span<const Vector3> points, const MortonCurve& curve)
    : Points(points)
    , Curve(curve)
  {
  }

  void sort(std::span<Keyed> run)
  {
    this->Run.clear();
    for (const Keyed& k : run)
    {
      this->Run.push_back({ this->Curve.codeOf(this->Points[k.id]), k.id });
    }
    std::sort(this->Run.begin(), this->Run.end(),
      [&](const Coded& a, const Coded& b)
      {
        const Vector3& p = this->Points[a.id];
        const Vector3& q = this->Points[b.id];
        return std::tie(a.code, p.x, p.y, p.z, a.id) < std::tie(b.code, q.x, q.y, q.z, b.id);
      });
    for (std::size_t i = 0; i < run.size(); ++i)
    {
      run[i].id = this->Run[i].id;
    }
  }

private:
  struct Coded
  {
    std::uint64_t code;
    Index id;
  };

  std::span<const Vector3> Points;
  const MortonCurve& Curve;
  std::vector<Coded> Run;
};

void sortRuns(BulkVector<Keyed>& keyed, std::span<const Vector3> points, const MortonCurve& curve,
  const ThreadTeam& team)
{
  const auto isSameRun = [&](std::size_t i, std::size_t j) { return keyed[i].key == keyed[j].key; };
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
      RunSorter sorter(points, curve);
      for (std::size_t first = starts[range]; first < starts[range + 1];)
      {
        std::size_t last = first + 1;
        while (last < starts[range + 1] && isSameRun(first, last))
        {
          ++last;
        }
        if (last - first > 1)
        {
          sorter.sort({ &keyed[first], last - first });
        }
        first = last;
      }
    });
}

}

BulkVector<Index> spatialOrder(
  std::span<const Vector3> points, std::span<const std::uint8_t> used, const ThreadTeam& team)
{
  const MortonCurve curve(points, used, team);
  BulkVector<Keyed> keyed = keysOf(points, used, curve, team);
  radixSort(keyed, team);
  sortRuns(keyed, points, curve, team);
  BulkVector<Index> order(keyed.size());
  team.run(order.size(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::transform(keyed.begin() + first, keyed.begin() + last, order.begin() + first,
        [](const Keyed& k) { return k.id; });
    });
  return order;
}

}
