// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/ClosestPointTree.h"

#include "base/Interruption.h"
#include "base/Platform.h"
#include "mesh/TriangleMesh.h"
#include "search/BvhSplit.h"
#include "search/NearestPoint.h"
#include "search/ShearedRay.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace geodesic
{

/** Makes the nodes: cuts the whole surface into runs, and these again, down to the leaves. */
class ClosestPointTree::Builder
{
public:
  explicit Builder(ClosestPointTree& tree)
    : Tree(tree)
    , Cuts(*tree.Mesh)
  {
  }

  /** Adds a node, and all below it, for the triangles from @p first to before @p last; returns
   * their bounds. */
  BvhBounds addNode(Index first, Index last)
  {
    const std::size_t number = this->Tree.Nodes.size();
    Interruption::checkAt(number);
    this->Tree.Nodes.emplace_back();
    const Parts parts = this->partsOf(first, last);
    std::array<BvhBounds, FourBvhBounds::Runs> bounds;
    for (std::size_t i = 0; i < parts.count; ++i)
    {
      const Index begin = parts.begins[i];
      const Index end = parts.begins[i + 1];
      Run run{ begin, end - begin };
      if (run.triangles > TrianglesPerLeaf)
      {
        run = { static_cast<Index>(this->Tree.Nodes.size()), 0 };
        bounds[i] = this->addNode(begin, end);
      }
      else
      {
        bounds[i] = this->boundsOf(begin, end);
      }
      Node& node = this->Tree.Nodes[number];
      node.runs[i] = run;
      node.bounds.set(i, bounds[i]);
    }
    return BvhBounds::ofRuns({ bounds.data(), parts.count });
  }

private:
  static constexpr Index TrianglesPerLeaf = 8;

  struct Parts
  {
    std::size_t count;
    /** The first triangle of each part, then the end of the last part. */
    std::array<Index, FourBvhBounds::Runs + 1> begins;
  };

  /** Cuts the largest part in two until there are four, or all are small enough for a leaf. */
  Parts partsOf(Index first, Index last) const
  {
    Parts parts{ 1, { first, last } };
    auto& [count, begins] = parts;
    while (count < FourBvhBounds::Runs)
    {
      std::size_t largest = 0;
      for (std::size_t i = 1; i < count; ++i)
      {
        largest = begins[i + 1] - begins[i] > begins[largest + 1] - begins[largest] ? i : largest;
      }
      if (begins[largest + 1] - begins[largest] <= TrianglesPerLeaf)
      {
        break;
      }
      const Index cut = this->Cuts.cut(begins[largest], begins[largest + 1]);
      std::copy_backward(&begins[largest + 1], &begins[count + 1], &begins[count + 1] + 1);
      begins[largest + 1] = cut;
      ++count;
    }
    return parts;
  }

  BvhBounds boundsOf(Index first, Index last) const
  {
    std::array<Vector3, std::size_t{ 3 } * TrianglesPerLeaf> corners;
    std::size_t count = 0;
    for (Index t = first; t < last; ++t)
    {
      for (const Vector3& corner : this->Tree.cornersOf(t))
      {
        corners[count++] = corner - this->Tree.Origin;
      }
    }
    return BvhBounds::ofTriangles({ corners.data(), count });
  }

  ClosestPointTree& Tree;
  BvhSplit Cuts;
};

ClosestPointTree::ClosestPointTree(std::shared_ptr<const TriangleMesh> mesh)
  : Mesh(std::move(mesh))
{
  if (this->Mesh->numberOfTriangles() > 0)
  {
    this->Origin = this->Mesh->position(0);
    Builder(*this).addNode(0, this->Mesh->numberOfTriangles());
    this->Nodes.shrink_to_fit();
  }
}

/** Asks the processor to fetch the first triangle or the node of a run, which will soon be read. */
GEODESIC_INLINED void ClosestPointTree::prefetch(const Run& run) const
{
  if (run.triangles > 0)
  {
    prefetchToRead(&this->Mesh->triangle(run.first));
    return;
  }
  constexpr std::size_t cacheLine = 64;
  const auto* const node = reinterpret_cast<const char*>(&this->Nodes[run.first]);
  for (std::size_t offset = 0; offset < sizeof(Node); offset += cacheLine)
  {
    prefetchToRead(node + offset);
  }
}

std::array<Vector3, 3> ClosestPointTree::cornersOf(Index triangle) const
{
  const Triangle& corners = this->Mesh->triangle(triangle);
  return { this->Mesh->position(corners[0]), this->Mesh->position(corners[1]),
    this->Mesh->position(corners[2]) };
}

ClosestPointTree::Result ClosestPointTree::closestPoint(const Vector3& query) const
{
  if (this->Nodes.empty())
  {
    throw std::invalid_argument("The surface has no triangle that a point could lie on.");
  }
  struct Pending
  {
    double squaredDistance;
    double toCentre;
    Run run;
  };
  const auto farther = [](const Pending& a, const Pending& b) { return a.toCentre > b.toCentre; };

  const Vector3 fromOrigin = query - this->Origin;
  NearestPoint nearest(*this->Mesh, query);
  std::vector<Pending> pending{ { 0.0, 0.0, { 0, 0 } } };
  while (!pending.empty())
  {
    const Pending next = pending.back();
    pending.pop_back();
    if (next.squaredDistance > nearest.reach())
    {
      continue;
    }
    const auto [first, triangles] = next.run;
    if (triangles > 0)
    {
      for (Index t = first; t < first + triangles; ++t)
      {
        nearest.tryTriangle(t);
      }
      continue;
    }
    // The part with the nearest centre is searched first. The least distance of a large run says
    // little about where in it the nearest point is; its centre is a better guess, and a good first
    // guess keeps the search short.
    const Node& node = this->Nodes[first];
    const auto [least, toCentre] = node.bounds.squaredDistances(fromOrigin);
    const std::size_t start = pending.size();
    for (std::size_t i = 0; i < FourBvhBounds::Runs && node.runs[i].first != NoIndex; ++i)
    {
      if (least[i] <= nearest.reach())
      {
        this->prefetch(node.runs[i]);
        pending.push_back({ least[i], toCentre[i], node.runs[i] });
      }
    }
    std::sort(pending.begin() + start, pending.end(), farther);
  }

  return nearest.result();
}

std::optional<ClosestPointTree::Result> ClosestPointTree::firstOnRay(
  const Vector3& origin, const Vector3& direction) const
{
  if (this->Nodes.empty())
  {
    return {};
  }
  // The boxes are relative to Origin, the triangles are not.
  const ShearedRay toBoxes(origin - this->Origin, direction);
  const ShearedRay toTriangles(origin, direction);
  struct Pending
  {
    double entry;
    Run run;
  };
  const auto farther = [](const Pending& a, const Pending& b) { return a.entry > b.entry; };

  Index nearest = NoIndex;
  ShearedRay::Crossing best{ {}, std::numeric_limits<double>::infinity() };
  std::vector<Pending> pending{ { 0.0, { 0, 0 } } };
  while (!pending.empty())
  {
    const Pending next = pending.back();
    pending.pop_back();
    if (next.entry > best.along)
    {
      continue;
    }
    const auto [first, triangles] = next.run;
    if (triangles > 0)
    {
      for (Index t = first; t < first + triangles; ++t)
      {
        const auto crossing = toTriangles.crossing(this->cornersOf(t));
        if (crossing && crossing->along >= 0.0 && crossing->along < best.along)
        {
          best = *crossing;
          nearest = t;
        }
      }
      continue;
    }
    // The nearest part comes last, so that it is taken first.
    const Node& node = this->Nodes[first];
    const std::size_t start = pending.size();
    for (std::size_t i = 0; i < FourBvhBounds::Runs && node.runs[i].first != NoIndex; ++i)
    {
      const double entry = toBoxes.entry(node.bounds.low(i), node.bounds.high(i));
      if (entry <= best.along && entry < std::numeric_limits<double>::infinity())
      {
        pending.push_back({ entry, node.runs[i] });
      }
    }
    std::sort(pending.begin() + start, pending.end(), farther);
  }

  if (nearest == NoIndex)
  {
    return {};
  }
  Result result;
  result.point = snapped({ nearest, best.weights });
  result.position = this->Mesh->positionOf(result.point);
  result.distance = norm(result.position - origin);
  return result;
}

}
