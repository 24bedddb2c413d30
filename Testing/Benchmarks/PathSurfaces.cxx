// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathSurfaces.h"

#include "ExactDistances.h"
#include "RoundedTube.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace geodesic::testing
{
namespace
{

/** A number for the whole suite, and one to try whether it runs. */
Index sized(Index number, Index tiny)
{
  return areSubjectsTiny() ? tiny : number;
}

KnownSurface curved(const Surface& surface)
{
  const auto shared = std::make_shared<const Surface>(surface);
  return { surface,
    [shared](const SurfacePoint& source) { return exactDistancesFrom(*shared, source); } };
}

/** The truth where a point's place in the plane follows from its position. */
template <class Distance>
KnownSurface unrolled(const Surface& surface, Distance distance)
{
  const auto shared = std::make_shared<const Surface>(surface);
  return { surface,
    [shared, distance](const SurfacePoint& source)
    {
      const Triangle& t = shared->triangles[source.triangle];
      const Vector3 from = source.weights[0] * shared->points[t[0]] +
        source.weights[1] * shared->points[t[1]] + source.weights[2] * shared->points[t[2]];
      std::vector<double> distances;
      for (const Vector3& to : shared->points)
      {
        distances.push_back(distance(from, to));
      }
      return distances;
    } };
}

/** One of the flat sides of a prism or a pyramid round the z axis. */
struct Side
{
  double number;
  /** Horizontally, from the axis to the middle of the side. */
  Vector3 middle;
};

Side sideAt(const Vector3& position, Index around)
{
  const double step = 2.0 * std::numbers::pi / around;
  const double angle = std::atan2(position.y, position.x);
  const double number = std::floor((angle < 0.0 ? angle + around * step : angle) / step);
  const double middle = (number + 0.5) * step;
  return { number, { std::cos(middle), std::sin(middle), 0.0 } };
}

double shortWayRound(double a, double b, double whole)
{
  const double way = std::abs(b - a);
  return std::min(way, whole - way);
}

KnownSurface planar(const Surface& surface)
{
  return unrolled(surface, [](const Vector3& a, const Vector3& b) { return norm(b - a); });
}

KnownSurface prism(Index around, Index along)
{
  const double chord = 2.0 * std::sin(std::numbers::pi / around);
  const auto turn = [=](const Vector3& p)
  {
    const Side side = sideAt(p, around);
    return (side.number + 0.5) * chord + side.middle.x * p.y - side.middle.y * p.x;
  };
  return unrolled(cylinder(around, along, 1.0, 4.0),
    [=](const Vector3& a, const Vector3& b)
    { return std::hypot(shortWayRound(turn(a), turn(b), around * chord), b.z - a.z); });
}

KnownSurface hat()
{
  const Index around = sized(200, 20);
  const double radius = 0.5;
  const double slope = 1.0;
  const double halfChord = radius * std::sin(std::numbers::pi / around);
  const double apothem = radius * std::cos(std::numbers::pi / around);
  const double sideAngle = 2.0 * std::asin(halfChord / slope);
  const double down = std::sqrt(slope * slope - radius * radius);
  const auto turn = [=](const Vector3& p)
  {
    const Side side = sideAt(p, around);
    const Vector3 middle{ apothem * side.middle.x, apothem * side.middle.y, -down };
    const double across = side.middle.x * p.y - side.middle.y * p.x;
    return (side.number + 0.5) * sideAngle + std::atan2(across, dot(p, middle) / norm(middle));
  };
  return unrolled(cone(around, sized(50, 5), radius, slope),
    [=](const Vector3& a, const Vector3& b)
    {
      const double angle = shortWayRound(turn(a), turn(b), around * sideAngle);
      const double chord = 2.0 * std::sin(0.5 * angle);
      return std::hypot(norm(a) - norm(b), chord * std::sqrt(norm(a) * norm(b)));
    });
}

KnownSurface roundedTube()
{
  constexpr double longToShort = 1000.0;
  const auto tube =
    std::make_shared<const RoundedTube>(4, static_cast<int>(sized(20, 3)), longToShort, 1);
  return { tube->surface(),
    [tube](const SurfacePoint& source) { return tube->distancesFrom(source); } };
}

KnownSurface bunnyCurved()
{
  return curved(areSubjectsTiny() ? icosphere(2) : bunny());
}

KnownSurface spotCurved()
{
  return curved(areSubjectsTiny() ? icosphere(1) : spot());
}

/** Irregular triangles on a smooth relief. */
KnownSurface hills()
{
  Surface surface = delaunayPlane(sized(1000000, 400), 1);
  for (Vector3& p : surface.points)
  {
    p.z = 0.05 * std::sin(17.0 * p.x) * std::sin(23.0 * p.y + 3.0 * p.x);
  }
  return { surface, {} };
}

struct Makers
{
  using List = std::vector<std::pair<std::string, std::function<KnownSurface()>>>;

  List curvedOnes{
    { "Bunny 35k", bunnyCurved },
    { "Spot 3k", spotCurved },
    { "torus 10k", [] { return curved(torus(sized(160, 20), sized(64, 10), 1.0, 0.4)); } },
    { "sphere 10k", [] { return curved(icosphere(static_cast<int>(sized(5, 2)))); } },
  };
  List flatOnes{
    { "Delaunay plane 10k", [] { return planar(delaunayPlane(sized(10000, 200), 1)); } },
    { "thin grid 10k",
      [] { return planar(jitteredGrid(sized(320, 40), sized(32, 4), 1.0, 1.0, 0.4, 1)); } },
    { "cylinder 10k", [] { return prism(sized(200, 20), sized(50, 5)); } },
    { "prism of 15 points", [] { return prism(3, 4); } },
    { "cone 10k", hat },
    { "rounded tube 9k", roundedTube },
  };
  List largeOnes{
    { "torus 1M",
      [] {
        return KnownSurface{ torus(sized(1600, 40), sized(626, 20), 1.0, 0.4), {} };
      } },
    { "hills 1M", hills },
  };
};

const Makers& makers()
{
  static const Makers all;
  return all;
}

std::vector<std::string> namesOf(const Makers::List& list)
{
  std::vector<std::string> names;
  for (const auto& [name, maker] : list)
  {
    names.push_back(name);
  }
  return names;
}

}

std::vector<std::string> curvedSurfaces()
{
  return namesOf(makers().curvedOnes);
}

std::vector<std::string> flatSurfaces()
{
  return namesOf(makers().flatOnes);
}

std::vector<std::string> largeSurfaces()
{
  return namesOf(makers().largeOnes);
}

Subject& pathSubject(const std::string& name)
{
  static std::map<std::string, Subject> known;
  const auto found = known.find(name);
  if (found != known.end())
  {
    return found->second;
  }
  for (const Makers::List* list : { &makers().curvedOnes, &makers().flatOnes, &makers().largeOnes })
  {
    for (const auto& [own, maker] : *list)
    {
      if (own == name)
      {
        return known.emplace(name, maker()).first->second;
      }
    }
  }
  throw std::out_of_range("no surface is called " + name);
}

}
