// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/JoinedCurves.h"

#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"
#include "solve/SeedFront.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

namespace geodesic
{
namespace
{

/** Where a curve ends, whatever triangle that is given in: the curve's value, and the vertices that
 * carry the point, in ascending order, with their weights. */
struct EndPlace
{
  double value;
  std::array<std::pair<Index, double>, 3> carriers;

  bool operator==(const EndPlace&) const = default;
};

struct HashOfPlace
{
  std::size_t operator()(const EndPlace& place) const
  {
    std::size_t hash = std::hash<double>{}(place.value);
    for (const auto& [vertex, weight] : place.carriers)
    {
      // The golden ratio of 2^64, see Knuth, The Art of Computer Programming 3, section 6.4.
      hash = (hash ^ vertex ^ std::hash<double>{}(weight)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

EndPlace placeOf(const TriangleMesh& mesh, double value, const SurfacePoint& point)
{
  EndPlace place{ value, {} };
  place.carriers.fill({ NoIndex, 0.0 });
  const Triangle& corners = mesh.triangle(point.triangle);
  for (std::size_t c = 0; c < 3; ++c)
  {
    if (point.weights[c] > 0.0)
    {
      place.carriers[c] = { corners[c], point.weights[c] };
    }
  }
  std::sort(place.carriers.begin(), place.carriers.end());
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

class CurveJoiner
{
public:
  CurveJoiner(const TriangleMesh& mesh, std::span<const Seed> seeds)
    : Mesh(mesh)
    , Seeds(seeds)
  {
  }

  /** Finds out which curves continue each other. @return false when cancelled */
  bool link(const std::function<bool()>& goesOn)
  {
    if (!this->numberPlaces(goesOn))
    {
      return false;
    }
    this->leaveOutDoubled();
    std::vector<std::array<std::size_t, 2>> endsAt(this->NumberOfPlaces);
    std::vector<std::size_t> counts(this->NumberOfPlaces);
    this->Linked.assign(2 * this->Curves.size(), None);
    for (std::size_t end = 0; end < this->Linked.size(); ++end)
    {
      const Index place = this->Curves[end / 2].places[end % 2];
      const std::size_t count = counts[place]++;
      if (count < 2)
      {
        endsAt[place][count] = end;
      }
    }
    for (Index place = 0; place < this->NumberOfPlaces; ++place)
    {
      if (counts[place] == 2)
      {
        this->Linked[endsAt[place][0]] = endsAt[place][1];
        this->Linked[endsAt[place][1]] = endsAt[place][0];
      }
    }
    return goesOn();
  }

  /** @pre link() has been called */
  std::vector<JoinedCurve> joined(const std::function<bool()>& goesOn)
  {
    this->IsTaken.assign(this->Curves.size(), false);
    std::vector<JoinedCurve> all;
    for (std::size_t end = 0; end < this->Linked.size(); ++end)
    {
      if (!this->IsTaken[end / 2] && this->Linked[end] == None)
      {
        this->addFrom(end, all);
      }
      if ((end + 1) % PointsOfFrontReport == 0 && !goesOn())
      {
        return {};
      }
    }
    // Closed ones turn.
    for (std::size_t c = 0; c < this->Curves.size(); ++c)
    {
      if (!this->IsTaken[c])
      {
        all.push_back({ this->Curves[c].seed, 1, this->pointsOf(c) });
      }
    }
    std::sort(all.begin(), all.end(),
      [](const JoinedCurve& a, const JoinedCurve& b) { return a.seed < b.seed; });
    return all;
  }

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  struct Curve
  {
    /** The number of the seed. */
    Index seed;
    /** Numbers of the places where it begins and ends. */
    std::array<Index, 2> places;
  };

  const std::vector<SurfacePoint>& pointsOf(std::size_t curve) const
  {
    return this->Seeds[this->Curves[curve].seed].points;
  }

  /** @return false when cancelled */
  bool numberPlaces(const std::function<bool()>& goesOn)
  {
    std::unordered_map<EndPlace, Index, HashOfPlace> numbers;
    for (Index s = 0; s < this->Seeds.size(); ++s)
    {
      const Seed& seed = this->Seeds[s];
      if (seed.kind == Seed::Kind::Curve && !seed.points.empty())
      {
        const auto numberOf = [&](const SurfacePoint& point)
        {
          return numbers
            .emplace(placeOf(this->Mesh, seed.value, point), static_cast<Index>(numbers.size()))
            .first->second;
        };
        const Index first = numberOf(seed.points.front());
        this->Curves.push_back({ s, { first, numberOf(seed.points.back()) } });
      }
      if ((s + 1) % PointsOfFrontReport == 0 && !goesOn())
      {
        return false;
      }
    }
    this->NumberOfPlaces = static_cast<Index>(numbers.size());
    return true;
  }

  /** Leaves out segments between the same places as one before. */
  void leaveOutDoubled()
  {
    // The two places, and the number of the seed.
    std::vector<std::array<Index, 3>> segments;
    for (const Curve& curve : this->Curves)
    {
      if (this->Seeds[curve.seed].points.size() == 2)
      {
        const auto [least, most] = std::minmax(curve.places[0], curve.places[1]);
        segments.push_back({ least, most, curve.seed });
      }
    }
    std::sort(segments.begin(), segments.end());
    std::vector<bool> areDoubled(this->Seeds.size(), false);
    for (std::size_t i = 1; i < segments.size(); ++i)
    {
      areDoubled[segments[i][2]] =
        segments[i][0] == segments[i - 1][0] && segments[i][1] == segments[i - 1][1];
    }
    std::erase_if(this->Curves, [&](const Curve& curve) { return areDoubled[curve.seed]; });
  }

  /** Adds the curve that begins at an end or, if it bends, those that it would be joined from. */
  void addFrom(std::size_t end, std::vector<JoinedCurve>& all)
  {
    JoinedCurve joined{ this->Curves[end / 2].seed, 0, {} };
    std::vector<std::size_t> parts;
    for (; end != None; end = this->Linked[end ^ 1])
    {
      const std::size_t curve = end / 2;
      this->IsTaken[curve] = true;
      parts.push_back(curve);
      joined.seed = std::min(joined.seed, this->Curves[curve].seed);
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
      all.push_back({ this->Curves[curve].seed, 1, this->pointsOf(curve) });
    }
  }

  const TriangleMesh& Mesh;
  std::span<const Seed> Seeds;
  std::vector<Curve> Curves;
  Index NumberOfPlaces = 0;
  /** For each end, at twice the position of the curve and one more where it is the last point, the
   * end that it continues; None if there is none. */
  std::vector<std::size_t> Linked;
  std::vector<bool> IsTaken;
};

}

std::vector<JoinedCurve> joinedCurves(
  const TriangleMesh& mesh, std::span<const Seed> seeds, const std::function<bool()>& goesOn)
{
  CurveJoiner joiner(mesh, seeds);
  return joiner.link(goesOn) ? joiner.joined(goesOn) : std::vector<JoinedCurve>();
}

}
