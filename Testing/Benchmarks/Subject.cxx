// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Subject.h"

#include "ExactDistances.h"
#include "RoundedTube.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>

namespace geodesic::testing
{
namespace
{

bool AreTiny = false;

Vector3 positionIn(const Surface& surface, const SurfacePoint& point)
{
  const Triangle& t = surface.triangles[point.triangle];
  return point.weights[0] * surface.points[t[0]] + point.weights[1] * surface.points[t[1]] +
    point.weights[2] * surface.points[t[2]];
}

/** The truth where it depends on the positions of both points alone. */
template <class Distance>
KnownSurface knownBy(Surface surface, Distance distance)
{
  const auto shared = std::make_shared<const Surface>(surface);
  return { std::move(surface),
    [shared, distance](const SurfacePoint& source)
    {
      const Vector3 from = positionIn(*shared, source);
      std::vector<double> distances;
      for (const Vector3& to : shared->points)
      {
        distances.push_back(distance(from, to));
      }
      return distances;
    } };
}

KnownSurface planar(Surface surface)
{
  for (const Triangle& t : surface.triangles)
  {
    const Vector3& a = surface.points[t[0]];
    if (!(cross(surface.points[t[1]] - a, surface.points[t[2]] - a).z > 0.0))
    {
      throw std::logic_error("a triangle of a plane is inverted");
    }
  }
  return knownBy(
    std::move(surface), [](const Vector3& a, const Vector3& b) { return norm(b - a); });
}

KnownSurface spherical(Surface surface)
{
  return knownBy(std::move(surface),
    [](const Vector3& a, const Vector3& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); });
}

KnownSurface sphere(int levels)
{
  return spherical(icosphere(AreTiny ? levels / 3 : levels));
}

KnownSurface sphereWithPointsShuffled()
{
  std::vector<Index> newId;
  return spherical(withPointsShuffled(icosphere(AreTiny ? 2 : 8), 1, newId));
}

KnownSurface sphereWithAllShuffled()
{
  std::vector<Index> newId;
  return spherical(shuffled(icosphere(AreTiny ? 2 : 8), 1, newId));
}

KnownSurface randomPlane()
{
  return planar(delaunayPlane(AreTiny ? 200 : 160000, 1));
}

KnownSurface thinGrid()
{
  return planar(
    AreTiny ? jitteredGrid(50, 5, 1.0, 1.0, 0.4, 1) : jitteredGrid(1265, 126, 1.0, 1.0, 0.4, 1));
}

KnownSurface roundedTube()
{
  constexpr double longToShort = 1000.0;
  const Index perSide = 4;
  const auto tube = std::make_shared<const RoundedTube>(perSide, AreTiny ? 3 : 60, longToShort, 1);
  return { tube->surface(),
    [tube](const SurfacePoint& source) { return tube->distancesFrom(source); } };
}

/** Exact distances on the polyhedron take as long as hundreds of solves. */
KnownSurface scan()
{
  const auto shared = std::make_shared<const Surface>(AreTiny ? icosphere(2) : bunny());
  return { *shared,
    [shared](const SurfacePoint& source) { return exactDistancesFrom(*shared, source); } };
}

KnownSurface untoldTorus()
{
  return { AreTiny ? torus(20, 10, 1.0, 0.4) : torus(800, 313, 1.0, 0.4), {} };
}

using Maker = std::function<KnownSurface()>;

const std::vector<std::pair<std::string, Maker>> Makers{
  { "icosphere 10k", [] { return sphere(5); } },
  { "Bunny 35k", scan },
  { "icosphere 160k", [] { return sphere(7); } },
  { "Delaunay plane 160k", randomPlane },
  { "thin grid 160k", thinGrid },
  { "rounded tube 66k", roundedTube },
  { "torus 250k", untoldTorus },
  { "icosphere 650k", [] { return sphere(8); } },
  { "shuffled points 650k", sphereWithPointsShuffled },
  { "all shuffled 650k", sphereWithAllShuffled },
  { "icosphere 2.6M", [] { return sphere(9); } },
};

}

SetUp setUp(const Surface& surface, unsigned threads)
{
  const ThreadTeam team(threads);
  const auto mesh = std::make_shared<const TriangleMesh>(
    surface.points, surface.triangles, CoincidentPoints::Separate, team, &updateMeasurer());
  return { mesh, std::make_shared<const UpdateBounds>(*mesh, team) };
}

Subject::Subject(KnownSurface known)
  : surface(std::move(known.surface))
  , truth(std::move(known.truth))
  , made(setUp(surface))
  , mesh(made.mesh)
  , tree(mesh)
  , solver(mesh, made.bounds)
  , dijkstra(*mesh)
{
}

Vector3 Subject::randomPosition()
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Index triangle = this->random() % this->mesh->numberOfTriangles();
  const double root = std::sqrt(uniform(this->random));
  const double part = uniform(this->random);
  return this->mesh->positionOf({ triangle, { 1.0 - root, root * (1.0 - part), root * part } });
}

SurfacePoint Subject::pointAt(const Vector3& position) const
{
  return this->tree.closestPoint(position).point;
}

Index Subject::vertexNear(const SurfacePoint& point) const
{
  const auto most = std::max_element(point.weights.begin(), point.weights.end());
  return this->mesh->triangle(point.triangle)[most - point.weights.begin()];
}

std::vector<std::string> subjectNames()
{
  std::vector<std::string> names;
  for (const auto& [name, maker] : Makers)
  {
    names.push_back(name);
  }
  return names;
}

Subject& subject(const std::string& name)
{
  static std::map<std::string, Subject> known;
  const auto found = known.find(name);
  if (found != known.end())
  {
    return found->second;
  }
  const auto maker =
    std::find_if(Makers.begin(), Makers.end(), [&](const auto& m) { return m.first == name; });
  return known.emplace(name, maker->second()).first->second;
}

void useTinySubjects()
{
  AreTiny = true;
}

bool areSubjectsTiny()
{
  return AreTiny;
}

}
