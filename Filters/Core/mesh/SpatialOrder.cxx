// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/SpatialOrder.h"

#include "base/Platform.h"
#include "mesh/MortonCurve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace geodesic
{

void throwNotFinite(Index point, const Vector3& position)
{
  std::ostringstream message;
  message << "Point " << point << " is at (" << position.x << ", " << position.y << ", "
          << position.z << "), which is no finite position, and cells use it. Remove it, for "
          << "example with Threshold.";
  throw std::invalid_argument(message.str());
}

void checkMagnitude(const BoundingBox& box)
{
  constexpr double least = 1e-30;
  constexpr double most = 1e30;
  double largest = 0.0;
  for (const Vector3& p : { box.low, box.high })
  {
    largest = std::max({ largest, std::abs(p.x), std::abs(p.y), std::abs(p.z) });
  }
  if (isFinite(box.low) && largest > 0.0 && !(largest >= least && largest <= most))
  {
    std::ostringstream message;
    message << "The largest coordinate of the surface is " << largest << "; it must lie between "
            << least << " and " << most
            << ", beyond which lengths overflow. Scale the surface, for "
            << "example with Transform.";
    throw std::invalid_argument(message.str());
  }
}

namespace
{

constexpr int RadixBits = 11;
constexpr int RadixPasses = 3;

/** A point and the highest 32 bits of its code, which differ between most points. */
struct Keyed
{
  std::uint32_t key;
  Index id;
};

BoundingBox boxOf(
  std::span<const Vector3> points, std::span<const std::uint8_t> used, const ThreadTeam& team)
{
  std::vector<BoundingBox> boxOfRange(team.numberOfRanges(points.size()));
  team.run(points.size(),
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      BoundingBox box;
      for (std::size_t i = first; i < last; ++i)
      {
        if (used[i])
        {
          checkFinite(static_cast<Index>(i), points[i]);
          box.add(points[i]);
        }
      }
      boxOfRange[range] = box;
    });
  BoundingBox box;
  for (const BoundingBox& other : boxOfRange)
  {
    box.add(other.low, other.high);
  }
  checkMagnitude(box);
  return box;
}

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
          keyed[next++] = { curve.leadingBitsOf(points[i]), static_cast<Index>(i) };
        }
      }
    });
  return keyed;
}

/** Sorts by the keys; equal keys keep their order. */
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

/** Sorts points of equal keys by the rest of their codes, then by coordinates, then by id. */
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
      this->Run.push_back({ this->Curve.otherBitsOf(this->Points[k.id]), k.id });
    }
    if (run.size() >= Least && run.size() <= Most && this->putByRanks(run))
    {
      return;
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
    /** The lowest 31 bits of the point's code. */
    std::uint32_t code;
    Index id;
  };
  /** Four codes that are compared with another one at once, by vector instructions where the
   * compiler has them. putByRanks() works on four of these at a time. */
#if GEODESIC_HAS_LANES
  using Codes = std::int32_t __attribute__((vector_size(16)));
#else
  struct Codes
  {
    std::int32_t operator[](std::size_t i) const { return this->Code[i]; }
    /** Subtracts a test's results, -1 where it holds: adds 1 there. */
    void operator-=(const Codes& test)
    {
      for (std::size_t i = 0; i < 4; ++i)
      {
        this->Code[i] -= test[i];
      }
    }
    friend Codes operator<(std::int32_t code, const Codes& others)
    {
      Codes test;
      for (std::size_t i = 0; i < 4; ++i)
      {
        test.Code[i] = code < others[i] ? -1 : 0;
      }
      return test;
    }
    std::array<std::int32_t, 4> Code;
  };
#endif
  static constexpr std::size_t CodesAtOnce = 16;
  /** For Least to Most points it is faster to count, for each one, the points before it than to
   * sort: a sort's branches depend on the data and are mispredicted. */
  static constexpr std::size_t Least = 8;
  static constexpr std::size_t Most = 256;

  /**
   * Puts each id of Run to the place in @p run that is the number of lower codes.
   * @return false, with @p run undefined, where codes are equal
   */
  bool putByRanks(std::span<Keyed> run) const
  {
    std::array<std::int32_t, Most> codes;
    const std::size_t size = run.size();
    for (std::size_t i = 0; i < size; ++i)
    {
      codes[i] = static_cast<std::int32_t>(this->Run[i].code);
    }
    std::fill_n(codes.data() + size, (Most - size) % CodesAtOnce, 0);
    std::size_t sum = 0;
    for (std::size_t i = 0; i < size; i += CodesAtOnce)
    {
      std::array<Codes, 4> own;
      std::memcpy(&own, &codes[i], sizeof own);
      std::array<Codes, 4> before{};
      for (std::size_t j = 0; j < size; ++j)
      {
        for (int k = 0; k < 4; ++k)
        {
          before[k] -= codes[j] < own[k];
        }
      }
      for (std::size_t k = 0; k < std::min(CodesAtOnce, size - i); ++k)
      {
        run[before[k / 4][k % 4]].id = this->Run[i + k].id;
        sum += before[k / 4][k % 4];
      }
    }
    return sum == size * (size - 1) / 2;
  }

  std::span<const Vector3> Points;
  const MortonCurve& Curve;
  std::vector<Coded> Run;
};

void sortRuns(BulkVector<Keyed>& keyed, std::span<const Vector3> points, const MortonCurve& curve,
  const ThreadTeam& team)
{
  const auto isSameRun = [&](std::size_t i, std::size_t j) { return keyed[i].key == keyed[j].key; };
  // A run of equal keys that crosses the end of a range belongs to the range where it starts.
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
      const auto isSame = [](const Keyed& a, const Keyed& b) { return a.key == b.key; };
      const auto end = keyed.begin() + starts[range + 1];
      auto first = std::adjacent_find(keyed.begin() + starts[range], end, isSame);
      while (first != end)
      {
        const auto last =
          std::find_if(first, end, [&](const Keyed& k) { return !isSame(k, *first); });
        sorter.sort({ first, last });
        first = std::adjacent_find(last, end, isSame);
      }
    });
}

}

BulkVector<Index> spatialOrder(
  std::span<const Vector3> points, std::span<const std::uint8_t> used, const ThreadTeam& team)
{
  const MortonCurve curve(boxOf(points, used, team));
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
