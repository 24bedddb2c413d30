// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomMeshes.h"

#include "ExactDistances.h"
#include "RandomDraws.h"
#include "Solving.h"
#include "mesh/Carriers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace geodesic::testing
{
namespace
{

Vector3 randomVector(double size, Random& random)
{
  return { between(-size, size, random), between(-size, size, random),
    between(-size, size, random) };
}

/** Moves each point of a surface round the origin in or out by up to a part of its distance. */
void roughen(Surface& surface, double part, Random& random)
{
  for (Vector3& p : surface.points)
  {
    p = (1.0 + between(-part, part, random)) * p;
  }
}

Surface blob(Random& random)
{
  Surface surface = icosphere(3);
  roughen(surface, between(0.0, 0.3, random), random);
  return surface;
}

Surface terrain(Random& random)
{
  Surface surface = delaunayPlane(300, random());
  const double height = between(0.0, 0.05, random);
  for (Vector3& p : surface.points)
  {
    p.z = between(-height, height, random);
  }
  return surface;
}

Surface grid(Random& random)
{
  const Index columns = 5 + below(20, random);
  const Index rows = 5 + below(20, random);
  return planeGrid(columns, rows, columns * between(0.5, 2.0, random), rows);
}

Surface bumpyTorus(Random& random)
{
  Surface surface = torus(30, 12, 1.0, between(0.2, 0.6, random));
  roughen(surface, between(0.0, 0.1, random), random);
  return surface;
}

Surface withHoles(Random& random)
{
  Surface surface = blob(random);
  const double part = between(0.02, 0.2, random);
  std::erase_if(surface.triangles, [&](const Triangle&) { return happens(part, random); });
  return surface;
}

Surface nonManifold(Random& random)
{
  Surface surface = terrain(random);
  const std::size_t triangles = surface.triangles.size();
  const auto addPoint = [&](const Vector3& p)
  {
    surface.points.push_back(p);
    return static_cast<Index>(surface.points.size() - 1);
  };
  // Fins on edges, which then have three to five triangles.
  for (int i = 0; i < 30; ++i)
  {
    const Triangle t = surface.triangles[below(triangles, random)];
    const Vector3 middle = 0.5 * (surface.points[t[0]] + surface.points[t[1]]);
    for (Index fins = 1 + below(3, random); fins > 0; --fins)
    {
      surface.triangles.push_back({ t[0], t[1], addPoint(middle + randomVector(0.1, random)) });
    }
  }
  // Sheets that touch the surface in a point.
  for (int i = 0; i < 5; ++i)
  {
    const Index tip = surface.triangles[below(triangles, random)][0];
    const Index a = addPoint(surface.points[tip] + randomVector(0.2, random));
    const Index b = addPoint(surface.points[tip] + randomVector(0.2, random));
    surface.triangles.push_back({ tip, a, b });
  }
  return surface;
}

Surface needles(Random& random)
{
  Surface surface = delaunayPlane(300, random());
  const double stretch = between(2.0, 10.0, random);
  for (Vector3& p : surface.points)
  {
    p.x *= stretch;
  }
  return surface;
}

Surface strip(Random& random)
{
  return planeGrid(200, 1, 200.0, between(0.2, 5.0, random));
}

Surface fan(Random& random)
{
  return cone(40 + below(200, random), 2, 1.0, between(1.05, 3.0, random));
}

Surface careless(Random& random)
{
  Surface surface = terrain(random);
  for (Triangle& t : surface.triangles)
  {
    if (happens(0.5, random))
    {
      std::swap(t[0], t[1]);
    }
  }
  for (int i = 0; i < 20; ++i)
  {
    const Triangle t = surface.triangles[below(surface.triangles.size(), random)];
    surface.triangles.push_back({ t[1], t[0], t[2] });
    surface.triangles.push_back({ t[0], t[0], t[2] });
    surface.points.push_back(randomVector(1.0, random));
  }
  return surface;
}

Surface parts(Random& random)
{
  Surface surface = joined(blob(random), terrain(random));
  return joined(surface, bumpyTorus(random));
}

/** Whether a front can leave the point, as far as the case's barriers are near it. */
bool isFree(const RandomCase& of, const SurfacePoint& point)
{
  const bool isClosed = !of.closedTriangles.empty() && of.closedTriangles[point.triangle];
  const Carriers carriers = carriersOf(*of.mesh, point);
  return !isClosed &&
    std::none_of(carriers.begin(), carriers.end(),
      [&](Index v) { return !of.excluded.empty() && of.excluded[v]; });
}

}

std::span<const MeshKind> meshKinds()
{
  static constexpr std::array kinds{ MeshKind::Closed, MeshKind::Terrain, MeshKind::Grid,
    MeshKind::Torus, MeshKind::Holes, MeshKind::NonManifold, MeshKind::Needles, MeshKind::Graded,
    MeshKind::Parts, MeshKind::Fan, MeshKind::Strip, MeshKind::Careless };
  return kinds;
}

std::string nameOf(MeshKind kind)
{
  static constexpr std::array names{ "closed", "terrain", "grid", "torus", "holes", "non-manifold",
    "needles", "graded", "parts", "fan", "strip", "careless" };
  return names[static_cast<std::size_t>(kind)];
}

Surface randomSurface(MeshKind kind, unsigned seed)
{
  Random random(seed);
  switch (kind)
  {
    case MeshKind::Closed:
      return blob(random);
    case MeshKind::Terrain:
      return terrain(random);
    case MeshKind::Grid:
      return grid(random);
    case MeshKind::Torus:
      return bumpyTorus(random);
    case MeshKind::Holes:
      return withHoles(random);
    case MeshKind::NonManifold:
      return nonManifold(random);
    case MeshKind::Needles:
      return needles(random);
    case MeshKind::Graded:
      return delaunayPlane(400, random(), 4.0);
    case MeshKind::Parts:
      return parts(random);
    case MeshKind::Fan:
      return fan(random);
    case MeshKind::Strip:
      return strip(random);
    case MeshKind::Careless:
      return careless(random);
  }
  return {};
}

SolveOptions RandomCase::options() const
{
  SolveOptions options;
  options.cost = this->cost;
  options.excluded = this->excluded;
  options.closedTriangles = this->closedTriangles;
  return options;
}

std::string RandomCase::description() const
{
  return nameOf(this->kind) + ", " + std::to_string(this->mesh->numberOfVertices()) +
    " vertices, " + std::to_string(this->seeds.size()) + " seeds" +
    (this->cost.empty() ? "" : ", costs") + (this->excluded.empty() ? "" : ", excluded vertices") +
    (this->closedTriangles.empty() ? "" : ", closed triangles");
}

RandomCase randomCase(unsigned seed, const CaseLimits& limits, std::span<const MeshKind> kinds)
{
  Random random(seed);
  RandomCase made;
  made.kind = kinds[seed % kinds.size()];
  made.mesh = meshOf(randomSurface(made.kind, random()));
  const Index vertices = made.mesh->numberOfVertices();
  if (limits.mayHaveCosts && happens(0.3, random))
  {
    std::lognormal_distribution<double> cost(0.0, 0.7);
    made.cost.resize(vertices);
    std::generate(made.cost.begin(), made.cost.end(), [&] { return cost(random); });
  }
  if (limits.mayHaveBarriers && happens(0.3, random))
  {
    made.excluded.resize(vertices);
    std::generate(made.excluded.begin(), made.excluded.end(), [&] { return happens(0.1, random); });
  }
  if (limits.mayHaveBarriers && happens(0.3, random))
  {
    made.closedTriangles.resize(made.mesh->numberOfTriangles());
    std::generate(made.closedTriangles.begin(), made.closedTriangles.end(),
      [&] { return happens(0.1, random); });
  }
  const unsigned wanted = limits.mostSeeds > 1 ? 2 + below(limits.mostSeeds - 1, random) : 1;
  while (made.seeds.size() < wanted)
  {
    const SurfacePoint point = randomPoint(*made.mesh, random);
    if (isFree(made, point))
    {
      made.seeds.push_back(Seed::atPoint(point));
    }
  }
  return made;
}

}
