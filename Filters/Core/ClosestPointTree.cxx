#include "ClosestPointTree.h"

#include "ShearedRay.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
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

/** A triangle in space, to be searched for its point nearest to a query. */
class SearchedTriangle
{
public:
  SearchedTriangle(const std::array<Vector3, 3>& corners, const Vector3& query)
    : Corners(corners)
    , Query(query)
    , Side1(corners[1] - corners[0])
    , Side2(corners[2] - corners[0])
    , Normal(cross(this->Side1, this->Side2))
    , SquaredNormal(dot(this->Normal, this->Normal))
    , Height(dot(query - corners[0], this->Normal))
  {
  }

  /** Tells by the distance to its plane that the triangle is farther away than a known distance. */
  bool isBeyond(double squaredDistance) const
  {
    // The normal of a needle is too uncertain.
    constexpr double leastSquaredSine = 1e-8;
    return this->Height * this->Height > squaredDistance * this->SquaredNormal &&
      this->SquaredNormal >
      leastSquaredSine * dot(this->Side1, this->Side1) * dot(this->Side2, this->Side2);
  }

  OnTriangle nearest() const
  {
    if (!(this->SquaredNormal > 0.0))
    {
      return this->nearestOnSides({ true, true, true });
    }
    const Vector3 toQuery = this->Query - this->Corners[0];
    const double w1 = dot(cross(toQuery, this->Side2), this->Normal) / this->SquaredNormal;
    const double w2 = dot(cross(this->Side1, toQuery), this->Normal) / this->SquaredNormal;
    const double w0 = 1.0 - w1 - w2;
    if (w0 >= 0.0 && w1 >= 0.0 && w2 >= 0.0)
    {
      return { { w0, w1, w2 }, this->Height * this->Height / this->SquaredNormal };
    }
    return this->nearestOnSides({ !(w0 >= 0.0), !(w1 >= 0.0), !(w2 >= 0.0) });
  }

private:
  /** On the sides opposite to some corners. */
  OnTriangle nearestOnSides(const std::array<bool, 3>& isSearched) const
  {
    OnTriangle best{ {}, std::numeric_limits<double>::infinity() };
    for (int corner = 0; corner < 3; ++corner)
    {
      if (isSearched[corner])
      {
        const OnTriangle found =
          onSide(this->Corners, (corner + 1) % 3, (corner + 2) % 3, this->Query);
        best = found.squaredDistance < best.squaredDistance ? found : best;
      }
    }
    return best;
  }

  const std::array<Vector3, 3>& Corners;
  const Vector3& Query;
  Vector3 Side1;
  Vector3 Side2;
  Vector3 Normal;
  double SquaredNormal;
  double Height;
};

/** How far a number is outside an interval. */
double outside(double x, double low, double high)
{
  return std::max(std::max(low - x, x - high), 0.0);
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
    const Index last = std::min(first + TrianglesPerLeaf, triangles);
    leaves.push_back({ this->boxOfTriangles(first, last),
      this->slabOfTriangles(this->normalOfTriangles(first, last), first, last) });
  }
  std::size_t trianglesPerNode = TrianglesPerLeaf;
  while (this->Levels.back().size() > 1)
  {
    const std::vector<Bounds>& below = this->Levels.back();
    trianglesPerNode *= ChildrenPerNode;
    std::vector<Bounds> level;
    for (std::size_t child = 0; child < below.size(); child += ChildrenPerNode)
    {
      Box box = below[child].box;
      Vector3 across;
      for (std::size_t i = child; i < std::min(child + ChildrenPerNode, below.size()); ++i)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          box.low[axis] = std::min(box.low[axis], below[i].box.low[axis]);
          box.high[axis] = std::max(box.high[axis], below[i].box.high[axis]);
        }
        across = across + below[i].slab.direction();
      }
      const std::size_t first = level.size() * trianglesPerNode;
      const std::size_t last = std::min<std::size_t>(first + trianglesPerNode, triangles);
      level.push_back({ box,
        this->slabOfTriangles(across, static_cast<Index>(first), static_cast<Index>(last)) });
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

std::array<Vector3, 3> ClosestPointTree::cornersOf(Index triangle) const
{
  const Triangle& corners = this->Mesh->triangle(triangle);
  return { this->Mesh->position(corners[0]), this->Mesh->position(corners[1]),
    this->Mesh->position(corners[2]) };
}

Vector3 ClosestPointTree::normalOfTriangles(Index first, Index last) const
{
  Vector3 sum;
  for (Index t = first; t < last; ++t)
  {
    const auto& [a, b, c] = this->Mesh->triangle(t);
    const Vector3& start = this->Mesh->position(a);
    sum = sum + cross(this->Mesh->position(b) - start, this->Mesh->position(c) - start);
  }
  return sum;
}

ClosestPointTree::Slab ClosestPointTree::slabOfTriangles(
  const Vector3& across, Index first, Index last) const
{
  // Not beyond 1 when rounded. Without a direction the slab is all of space.
  constexpr double wantedLength = 1.0 - 1e-6;
  const double length = norm(across);
  const double scale = length > 0.0 && std::isfinite(length) ? wantedLength / length : 0.0;
  if (scale == 0.0)
  {
    return Slab();
  }
  Slab slab{ static_cast<float>(scale * across.x), static_cast<float>(scale * across.y),
    static_cast<float>(scale * across.z) };
  const Vector3 direction = slab.direction();
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (Index t = first; t < last; ++t)
  {
    for (Index v : this->Mesh->triangle(t))
    {
      const double along = dot(direction, this->Mesh->position(v) - this->Origin);
      low = std::min(low, along);
      high = std::max(high, along);
    }
  }
  slab.low = roundedDown(low);
  slab.high = -roundedDown(-high);
  return slab;
}

ClosestPointTree::Result ClosestPointTree::closestPoint(const Vector3& query) const
{
  if (this->Levels.empty())
  {
    throw std::invalid_argument("The surface has no triangle that a point could lie on.");
  }
  // No point of the run is nearer.
  const auto squaredDistance = [](const Bounds& bounds, const Vector3& p)
  {
    const auto& [low, high] = bounds.box;
    const Vector3 gap{ outside(p.x, low[0], high[0]), outside(p.y, low[1], high[1]),
      outside(p.z, low[2], high[2]) };
    const Slab& slab = bounds.slab;
    const double along = dot(slab.direction(), p);
    const double gapAlong = outside(along, slab.low, slab.high);
    return std::max(dot(gap, gap), gapAlong * gapAlong);
  };
  struct Pending
  {
    double squaredDistance;
    std::size_t level;
    Index box;
  };
  const auto farther = [](const Pending& a, const Pending& b)
  { return a.squaredDistance > b.squaredDistance; };

  const Vector3 fromOrigin = query - this->Origin;
  Index nearest = NoIndex;
  OnTriangle best{ {}, std::numeric_limits<double>::infinity() };
  std::vector<Pending> pending{ { 0.0, this->Levels.size() - 1, 0 } };
  while (!pending.empty())
  {
    std::pop_heap(pending.begin(), pending.end(), farther);
    const Pending next = pending.back();
    pending.pop_back();
    if (next.squaredDistance >= best.squaredDistance)
    {
      break;
    }
    if (next.level == 0)
    {
      const Index first = next.box * TrianglesPerLeaf;
      const Index last = std::min(first + TrianglesPerLeaf, this->Mesh->numberOfTriangles());
      for (Index t = first; t < last; ++t)
      {
        const std::array<Vector3, 3> corners = this->cornersOf(t);
        const SearchedTriangle triangle(corners, query);
        if (triangle.isBeyond(best.squaredDistance))
        {
          continue;
        }
        const OnTriangle candidate = triangle.nearest();
        if (candidate.squaredDistance < best.squaredDistance)
        {
          best = candidate;
          nearest = t;
        }
      }
      continue;
    }
    const std::vector<Bounds>& children = this->Levels[next.level - 1];
    const Index first = next.box * ChildrenPerNode;
    const Index last = std::min<Index>(first + ChildrenPerNode, children.size());
    for (Index child = first; child < last; ++child)
    {
      const double distance = squaredDistance(children[child], fromOrigin);
      if (distance < best.squaredDistance)
      {
        pending.push_back({ distance, next.level - 1, child });
        std::push_heap(pending.begin(), pending.end(), farther);
      }
    }
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

std::optional<ClosestPointTree::Result> ClosestPointTree::firstOnRay(
  const Vector3& origin, const Vector3& direction) const
{
  if (this->Levels.empty())
  {
    return {};
  }
  // The boxes are relative to Origin, the triangles are not.
  const ShearedRay toBoxes(origin - this->Origin, direction);
  const ShearedRay toTriangles(origin, direction);
  struct Pending
  {
    double entry;
    std::size_t level;
    Index box;
  };
  const auto farther = [](const Pending& a, const Pending& b) { return a.entry > b.entry; };

  Index nearest = NoIndex;
  ShearedRay::Crossing best{ {}, std::numeric_limits<double>::infinity() };
  std::vector<Pending> pending{ { 0.0, this->Levels.size() - 1, 0 } };
  while (!pending.empty())
  {
    const Pending next = pending.back();
    pending.pop_back();
    if (next.entry > best.along)
    {
      continue;
    }
    if (next.level == 0)
    {
      const Index first = next.box * TrianglesPerLeaf;
      const Index last = std::min(first + TrianglesPerLeaf, this->Mesh->numberOfTriangles());
      for (Index t = first; t < last; ++t)
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
    // Nearest child last, so that it is looked at first.
    const std::vector<Bounds>& children = this->Levels[next.level - 1];
    const Index first = next.box * ChildrenPerNode;
    const Index last = std::min<Index>(first + ChildrenPerNode, children.size());
    const std::size_t start = pending.size();
    for (Index child = first; child < last; ++child)
    {
      const Box& box = children[child].box;
      const double entry = toBoxes.entry(
        { box.low[0], box.low[1], box.low[2] }, { box.high[0], box.high[1], box.high[2] });
      if (entry <= best.along && entry < std::numeric_limits<double>::infinity())
      {
        pending.push_back({ entry, next.level - 1, child });
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
