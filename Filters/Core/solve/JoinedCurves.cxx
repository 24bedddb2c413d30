// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/JoinedCurves.h"

#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace geodesic
{
namespace
{

/** What tells a place on the surface, whatever triangle it is given in: the vertices that carry it,
 * in ascending order, and their weights. */
using Place = std::array<std::pair<Index, double>, 3>;

Place placeOf(const TriangleMesh& mesh, const SurfacePoint& point)
{
  Place place;
  place.fill({ NoIndex, 0.0 });
  const Triangle& corners = mesh.triangle(point.triangle);
  for (std::size_t c = 0; c < 3; ++c)
  {
    if (point.weights[c] > 0.0)
    {
      place[c] = { corners[c], point.weights[c] };
    }
  }
  std::sort(place.begin(), place.end());
  return place;
}

/** The direction of the surface at a point: the mean of its triangles', by area. */
Vector3 normalAt(const TriangleMesh& mesh, const SurfacePoint& point)
{
  const Carriers carriers = carriersOf(mesh, point);
  Vector3 sum;
  mesh.visitTrianglesWith({ carriers.begin(), carriers.end() },
    [&](Index, std::size_t, const Triangle& t)
    {
      const Vector3& a = mesh.position(t[0]);
      const Vector3 normal = cross(mesh.position(t[1]) - a, mesh.position(t[2]) - a);
      sum = dot(sum, normal) < 0.0 ? sum - normal : sum + normal;
    });
  const double length = norm(sum);
  return length > 0.0 ? 1.0 / length * sum : Vector3{};
}

/** Whether a curve turns on the surface, from its beginning, by less than some 10 degrees. That it
 * follows the surface up and down is no turn. */
bool isStraightOn(const TriangleMesh& mesh, const std::vector<SurfacePoint>& points)
{
  constexpr double leastCosine = 0.985;
  Vector3 here = mesh.positionOf(points[0]);
  Vector3 next = mesh.positionOf(points[1]);
  Vector3 way = next - here;
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
  {
    here = std::exchange(next, mesh.positionOf(points[i + 1]));
    const Vector3 normal = normalAt(mesh, points[i]);
    const auto along = [&](const Vector3& v) { return v - dot(v, normal) * normal; };
    const Vector3 out = along(next - here);
    // What begins in a point has no direction as yet.
    way = norm(way) > 0.0 ? along(way) : out;
    if (!(dot(way, out) >= leastCosine * norm(way) * norm(out)))
    {
      return false;
    }
  }
  return true;
}

/** An end of a curve. */
struct CurveEnd
{
  double value;
  Place place;
  /** Twice the position in the list of curves, and one more for the last point. */
  std::size_t number;
};

class CurveJoiner
{
public:
  CurveJoiner(const TriangleMesh& mesh, std::span<const Seed> seeds)
    : Mesh(mesh)
    , Seeds(seeds)
  {
    for (Index s = 0; s < seeds.size(); ++s)
    {
      if (seeds[s].kind == Seed::Kind::Curve && !seeds[s].points.empty())
      {
        this->Curves.push_back(s);
      }
    }
    this->leaveOutDoubled();
    this->link();
  }

  std::vector<JoinedCurve> joined()
  {
    this->IsTaken.assign(this->Curves.size(), false);
    std::vector<JoinedCurve> all;
    for (std::size_t end = 0; end < this->Linked.size(); ++end)
    {
      if (!this->IsTaken[end / 2] && this->Linked[end] == None)
      {
        this->addFrom(end, all);
      }
    }
    // Closed ones turn.
    for (std::size_t c = 0; c < this->Curves.size(); ++c)
    {
      if (!this->IsTaken[c])
      {
        all.push_back({ this->Curves[c], 1, this->pointsOf(c) });
      }
    }
    std::sort(all.begin(), all.end(),
      [](const JoinedCurve& a, const JoinedCurve& b) { return a.seed < b.seed; });
    return all;
  }

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  const std::vector<SurfacePoint>& pointsOf(std::size_t curve) const
  {
    return this->Seeds[this->Curves[curve]].points;
  }

  /** Leaves out segments with the ends and the value of one before. */
  void leaveOutDoubled()
  {
    using Key = std::tuple<double, Place, Place, Index>;
    std::vector<Key> segments;
    for (const Index s : this->Curves)
    {
      const Seed& seed = this->Seeds[s];
      if (seed.points.size() == 2)
      {
        const Place first = placeOf(this->Mesh, seed.points.front());
        const Place last = placeOf(this->Mesh, seed.points.back());
        segments.emplace_back(seed.value, std::min(first, last), std::max(first, last), s);
      }
    }
    std::sort(segments.begin(), segments.end());
    std::vector<Index> doubled;
    for (std::size_t i = 1; i < segments.size(); ++i)
    {
      const auto& [valueBefore, firstBefore, lastBefore, before] = segments[i - 1];
      const auto& [value, first, last, seed] = segments[i];
      if (std::tie(valueBefore, firstBefore, lastBefore) == std::tie(value, first, last))
      {
        doubled.push_back(seed);
      }
    }
    std::sort(doubled.begin(), doubled.end());
    std::erase_if(
      this->Curves, [&](Index s) { return std::binary_search(doubled.begin(), doubled.end(), s); });
  }

  void link()
  {
    this->Linked.assign(2 * this->Curves.size(), None);
    std::vector<CurveEnd> ends;
    for (std::size_t c = 0; c < this->Curves.size(); ++c)
    {
      const double value = this->Seeds[this->Curves[c]].value;
      ends.push_back({ value, placeOf(this->Mesh, this->pointsOf(c).front()), 2 * c });
      ends.push_back({ value, placeOf(this->Mesh, this->pointsOf(c).back()), 2 * c + 1 });
    }
    std::sort(ends.begin(), ends.end(),
      [](const CurveEnd& a, const CurveEnd& b)
      { return std::tie(a.value, a.place, a.number) < std::tie(b.value, b.place, b.number); });
    for (std::size_t first = 0; first < ends.size();)
    {
      std::size_t last = first + 1;
      while (last < ends.size() && ends[last].value == ends[first].value &&
        ends[last].place == ends[first].place)
      {
        ++last;
      }
      if (last - first == 2)
      {
        this->Linked[ends[first].number] = ends[first + 1].number;
        this->Linked[ends[first + 1].number] = ends[first].number;
      }
      first = last;
    }
  }

  /** Adds the curve that begins at an end or, if it bends, those that it would be joined from. */
  void addFrom(std::size_t end, std::vector<JoinedCurve>& all)
  {
    JoinedCurve joined{ this->Curves[end / 2], 0, {} };
    std::vector<std::size_t> parts;
    for (; end != None; end = this->Linked[end ^ 1])
    {
      const std::size_t curve = end / 2;
      this->IsTaken[curve] = true;
      parts.push_back(curve);
      joined.seed = std::min(joined.seed, this->Curves[curve]);
      std::vector<SurfacePoint> points = this->pointsOf(curve);
      if (end % 2 == 1)
      {
        std::reverse(points.begin(), points.end());
      }
      joined.points.insert(
        joined.points.end(), points.begin() + (joined.points.empty() ? 0 : 1), points.end());
    }
    joined.numberOfSeeds = parts.size();
    if (parts.size() == 1 || isStraightOn(this->Mesh, joined.points))
    {
      all.push_back(std::move(joined));
      return;
    }
    for (const std::size_t curve : parts)
    {
      all.push_back({ this->Curves[curve], 1, this->pointsOf(curve) });
    }
  }

  const TriangleMesh& Mesh;
  std::span<const Seed> Seeds;
  /** The numbers of the seeds. */
  std::vector<Index> Curves;
  /** For each end the one that it continues; None if there is none. */
  std::vector<std::size_t> Linked;
  std::vector<bool> IsTaken;
};

}

std::vector<JoinedCurve> joinedCurves(const TriangleMesh& mesh, std::span<const Seed> seeds)
{
  return CurveJoiner(mesh, seeds).joined();
}

}
