// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/PointIdentity.h"

#include "base/NumberText.h"
#include "filter/VtkVersions.h"
#include "input/ArrayValues.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>

namespace geodesic::bridge
{
namespace
{

/** Gives all points that compare equal the number of the lowest of them. */
template <class IsBefore>
void joinEqual(std::vector<Index> group, IsBefore&& isBefore, std::vector<Index>& kinds)
{
  std::stable_sort(group.begin(), group.end(), isBefore);
  for (std::size_t i = 1; i < group.size(); ++i)
  {
    if (!isBefore(group[i - 1], group[i]))
    {
      kinds[group[i]] = kinds[group[i - 1]];
    }
  }
}

/**
 * Checks that points with the same global id differ by no more than the rounding of their
 * coordinates.
 */
void checkDistances(const std::vector<vtkIdType>& ids, const std::vector<Index>& kinds,
  std::span<const Vector3> points)
{
  double size = 0.0;
  for (const Vector3& p : points)
  {
    size = isFinite(p) ? std::max({ size, std::abs(p.x), std::abs(p.y), std::abs(p.z) }) : size;
  }
  for (Index i = 0; i < points.size(); ++i)
  {
    const double distance = kinds[i] == i ? 0.0 : norm(points[i] - points[kinds[i]]);
    if (distance > 1e-5 * size)
    {
      throw std::invalid_argument("Two points with the global id " + std::to_string(ids[i]) +
        " are " + textOf(distance) +
        " apart, but equal ids mean the same point. Make the ids again for all blocks together, " +
        MakeGlobalIdsOfBlocks + ", or remove the array.");
    }
  }
}

}

PointIdentity::By identityBy(bool haveGlobalIds, bool mergeCoincidentPoints)
{
  if (haveGlobalIds)
  {
    return PointIdentity::By::GlobalIds;
  }
  return mergeCoincidentPoints ? PointIdentity::By::Coordinates : PointIdentity::By::Nothing;
}

PointIdentity identityOf(const InputBlocks& blocks, bool mergeCoincidentPoints, bool connectBlocks)
{
  const std::size_t count = blocks.numberWithFaces();
  const PointIdentity identity{
    identityBy(count > 0 && blocks.haveGlobalPointIds(), mergeCoincidentPoints), connectBlocks
  };
  if (connectBlocks && count > 1 && identity.by == PointIdentity::By::Nothing)
  {
    throw std::invalid_argument("ConnectBlocks is on, but it is not known which points of the " +
      std::to_string(count) +
      " blocks belong together: MergeCoincidentPoints is off, and not all blocks have "
      "GlobalPointIds. Turn "
      "MergeCoincidentPoints on, make the ids " +
      MakeGlobalIdsOfBlocks + ", or turn ConnectBlocks off.");
  }
  return identity;
}

std::vector<vtkIdType> globalPointIdsOf(const InputBlocks& blocks)
{
  std::vector<vtkIdType> ids;
  for (const InputBlock& block : blocks)
  {
    const vtkIdType count = block.surface->GetNumberOfPoints();
    if (block.hasFaces())
    {
      appendValues(block.globalPointIds(), count, "GlobalPointIds", ids);
    }
    else
    {
      ids.resize(ids.size() + count, -1);
    }
  }
  return ids;
}

std::vector<Index> kindsOfPoints(
  const InputBlocks& blocks, const PointIdentity& identity, std::span<const Vector3> points)
{
  std::vector<Index> kinds(points.size());
  std::iota(kinds.begin(), kinds.end(), Index{ 0 });
  std::vector<vtkIdType> ids;
  if (identity.by == PointIdentity::By::GlobalIds)
  {
    ids = globalPointIdsOf(blocks);
  }
  const auto join = [&](std::vector<Index> group)
  {
    if (identity.by == PointIdentity::By::GlobalIds)
    {
      joinEqual(
        std::move(group), [&](Index a, Index b) { return ids[a] < ids[b]; }, kinds);
    }
    else if (identity.by == PointIdentity::By::Coordinates)
    {
      const auto isBefore = [&](Index a, Index b)
      {
        const Vector3& p = points[a];
        const Vector3& q = points[b];
        return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
      };
      joinEqual(std::move(group), isBefore, kinds);
    }
  };
  std::vector<Index> group;
  Index next = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const InputBlock& block = blocks[i];
    const Index end = next + static_cast<Index>(block.surface->GetNumberOfPoints());
    for (; next < end; ++next)
    {
      // Coordinates that are NaN have no order.
      const bool isNumbered = ids.empty() || ids[next] >= 0;
      if (isNumbered && isFinite(points[next]))
      {
        group.push_back(next);
      }
    }
    const bool isLastOfBlock = i + 1 == blocks.size() || blocks[i + 1].block != block.block;
    if (!identity.acrossBlocks && isLastOfBlock)
    {
      join(std::move(group));
      group.clear();
    }
  }
  join(std::move(group));
  if (!ids.empty())
  {
    checkDistances(ids, kinds, points);
  }
  return kinds;
}

}
