#include "ClosestPointTree.h"

#include "TriangleMesh.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace geodesic
{
namespace
{

constexpr Index TrianglesPerLeaf = 4;
constexpr Index ChildrenPerNode = 4;

struct OnTriangle
{
  std::array<double, 3> weights;
  double squaredDistance;
};

/** Nearest point of the side from corner @p i to corner @p j. */
OnTriangle onSide(const std::array<Vector3, 3>& corners, int i, int j, const Vector3& query)
{
  const Vector3 side = corners[j] - corners[i];
  const double length2 = dot(side, side);
  const double t =
    length2 > 0.0 ? std::clamp(dot(query - corners[i], side) / length2, 0.0, 1.0) : 0.0;
  const Vector3 away = query - (corners[i] + t * side);
  OnTriangle result{ { 0.0, 0.0, 0.0 }, dot(away, away) };
  result.weights[i] = 1.0 - t;
  result.weights[j] = t;
  return result;
}

OnTriangle onTriangle(const std::array<Vector3, 3>& corners, const Vector3& query)
{
  const Vector3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double area2 = dot(normal, normal);
  if (area2 > 0.0)
  {
    const Vector3 toQuery = query - corners[0];
    const double w1 = dot(cross(toQuery, corners[2] - corners[0]), normal) / area2;
    const double w2 = dot(cross(corners[1] - corners[0], toQuery), normal) / area2;
    const double w0 = 1.0 - w1 - w2;
    if (w0 >= 0.0 && w1 >= 0.0 && w2 >= 0.0)
    {
      const double height = dot(toQuery, normal);
      return { { w0, w1, w2 }, height * height / area2 };
    }
  }
  const std::array<OnTriangle, 3> sides = { onSide(corners, 0, 1, query),
    onSide(corners, 1, 2, query), onSide(corners, 2, 0, query) };
  return *std::min_element(sides.begin(), sides.end(),
    [](const OnTriangle& a, const OnTriangle& b) { return a.squaredDistance < b.squaredDistance; });
}

float roundedDown(double x)
{
  const float rounded = static_cast<float>(x);
  return rounded > x ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
}

}

ClosestPointTree::ClosestPointTree(std::shared_ptr<const TriangleMesh> mesh)
  : Mesh(std::move(mesh))
{
  const Index triangles = this->Mesh->numberOfTriangles();
  if (triangles == 0)
  {
    return;
  }
  this->Origin = this->Mesh->position(0);
  auto& leaves = this->Levels.emplace_back();
  leaves.reserve(triangles / TrianglesPerLeaf + 1);
  for (Index first = 0; first < triangles; first += TrianglesPerLeaf)
  {
    leaves.push_back(this->boxOfTriangles(first, std::min(first + TrianglesPerLeaf, triangles)));
  }
  while (this->Levels.back().size() > 1)
  {
    const std::vector<Box>& below = this->Levels.back();
    std::vector<Box> level((below.size() + ChildrenPerNode - 1) / ChildrenPerNode);
    for (std::size_t i = 0; i < below.size(); ++i)
    {
      Box& box = level[i / ChildrenPerNode];
      for (int axis = 0; axis < 3; ++axis)
      {
        const bool isFirst = i % ChildrenPerNode == 0;
        box.low[axis] = isFirst ? below[i].low[axis] : std::min(box.low[axis], below[i].low[axis]);
        box.high[axis] =
          isFirst ? below[i].high[axis] : std::max(box.high[axis], below[i].high[axis]);
      }
    }
    this->Levels.push_back(std::move(level));
  }
}

ClosestPointTree::Box ClosestPointTree::boxOfTriangles(Index first, Index last) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3 low{ infinity, infinity, infinity };
  Vector3 high{ -infinity, -infinity, -infinity };
  for (Index t = first; t < last; ++t)
  {
    for (Index v : this->Mesh->triangle(t))
    {
      const Vector3 p = this->Mesh->position(v) - this->Origin;
      low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
      high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
    }
  }
  return { { roundedDown(low.x), roundedDown(low.y), roundedDown(low.z) },
    { -roundedDown(-high.x), -roundedDown(-high.y), -roundedDown(-high.z) } };
}

double ClosestPointTree::squaredDistance(const Box& box, const Vector3& query) const
{
  const Vector3 p = query - this->Origin;
  const auto outside = [](double x, double low, double high) {
    return std::max({ low - x, x - high, 0.0 });
  };
  const Vector3 gap{ outside(p.x, box.low[0], box.high[0]), outside(p.y, box.low[1], box.high[1]),
    outside(p.z, box.low[2], box.high[2]) };
  return dot(gap, gap);
}

ClosestPointTree::Result ClosestPointTree::closestPoint(const Vector3& query) const
{
  if (this->Levels.empty())
  {
    throw std::invalid_argument("The surface has no triangle that a point could lie on.");
  }
  struct Pending
  {
    double squaredDistance;
    std::size_t level;
    Index box;
  };
  const auto farther = [](const Pending& a, const Pending& b)
  { return a.squaredDistance > b.squaredDistance; };

  Index nearest = NoIndex;
  OnTriangle best{ {}, std::numeric_limits<double>::infinity() };
  std::vector<Pending> pending{ { 0.0, this->Levels.size() - 1, 0 } };
  while (!pending.empty())
  {
    const Pending next = pending.back();
    pending.pop_back();
    if (next.squaredDistance >= best.squaredDistance)
    {
      continue;
    }
    if (next.level == 0)
    {
      const Index first = next.box * TrianglesPerLeaf;
      const Index last = std::min(first + TrianglesPerLeaf, this->Mesh->numberOfTriangles());
      for (Index t = first; t < last; ++t)
      {
        const Triangle& corners = this->Mesh->triangle(t);
        const OnTriangle candidate =
          onTriangle({ this->Mesh->position(corners[0]), this->Mesh->position(corners[1]),
                       this->Mesh->position(corners[2]) },
            query);
        if (candidate.squaredDistance < best.squaredDistance)
        {
          best = candidate;
          nearest = t;
        }
      }
      continue;
    }
    // Nearest child last, so that it is looked at first.
    const std::vector<Box>& children = this->Levels[next.level - 1];
    const Index first = next.box * ChildrenPerNode;
    const Index last = std::min<Index>(first + ChildrenPerNode, children.size());
    const std::size_t start = pending.size();
    for (Index child = first; child < last; ++child)
    {
      const double distance = this->squaredDistance(children[child], query);
      if (distance < best.squaredDistance)
      {
        pending.push_back({ distance, next.level - 1, child });
      }
    }
    std::sort(pending.begin() + start, pending.end(), farther);
  }

  if (nearest == NoIndex)
  {
    throw std::invalid_argument("A point is too far from the surface to measure its distance.");
  }
  Result result;
  result.point = snapped({ nearest, best.weights });
  result.position = this->Mesh->positionOf(result.point);
  result.distance = norm(query - result.position);
  return result;
}

}
