// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NastyCases.h"

#include "RandomDraws.h"
#include "Solving.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>

namespace geodesic::testing
{
namespace
{

/** As often of each order of magnitude. */
double magnitude(double lowest, double highest, Random& random)
{
  return std::pow(10.0, between(lowest, highest, random));
}

Vector3 randomPosition(Random& random)
{
  const double x = between(0.0, 1.0, random);
  const double y = between(0.0, 1.0, random);
  return { x, y, between(0.0, 1.0, random) };
}

Surface looseSoup(Random& random)
{
  Surface surface;
  for (Index t = 1 + below(60, random); t > 0; --t)
  {
    const auto first = static_cast<Index>(surface.points.size());
    for (int corner = 0; corner < 3; ++corner)
    {
      // Some are at the same place.
      surface.points.push_back(first > 0 && happens(0.3, random)
          ? surface.points[below(first, random)]
          : randomPosition(random));
    }
    surface.triangles.push_back({ first, first + 1, first + 2 });
  }
  return surface;
}

Surface soup(Random& random)
{
  Surface surface;
  const Index points = 3 + below(20, random);
  for (Index i = 0; i < points; ++i)
  {
    surface.points.push_back(randomPosition(random));
  }
  for (Index t = 1 + below(40, random); t > 0; --t)
  {
    const Index a = below(points, random);
    const Index b = below(points, random);
    surface.triangles.push_back({ a, b, below(points, random) });
  }
  return surface;
}

Surface flatSoup(Random& random)
{
  Surface surface = soup(random);
  const double stretch = magnitude(0.0, 4.0, random);
  for (Vector3& p : surface.points)
  {
    p = { stretch * p.x, p.y, 0.0 };
  }
  return surface;
}

Surface jittered(Random& random)
{
  const Index columns = 2 + below(10, random);
  const Index rows = 2 + below(10, random);
  // One draw a statement: compilers differ in which argument they evaluate first.
  const auto number = static_cast<unsigned>(random());
  return jitteredGrid(columns, rows, columns, rows, between(0.0, 0.4, random), number);
}

Surface slivers(Random& random)
{
  Surface surface = jittered(random);
  const double height = magnitude(-9.0, -1.0, random);
  const double flat = magnitude(-6.0, -1.0, random);
  for (Vector3& p : surface.points)
  {
    p = { p.x, flat * p.y, between(0.0, height, random) };
  }
  return surface;
}

Surface folds(Random& random)
{
  Surface surface = jittered(random);
  const bool isTight = happens(0.5, random);
  for (Vector3& p : surface.points)
  {
    const double part = std::fmod(p.x, 2.0);
    p = { part < 1.0 ? part : 2.0 - part, p.y, isTight ? 0.0 : 1e-3 * p.x };
  }
  return surface;
}

Surface doubled(Random& random)
{
  Surface surface = jittered(random);
  const std::size_t triangles = surface.triangles.size();
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const Triangle t = surface.triangles[below(triangles, random)];
    surface.triangles.push_back(happens(0.5, random) ? t : Triangle{ t[1], t[0], t[2] });
  }
  return surface;
}

Surface books(Random& random)
{
  Surface surface;
  const bool isFlat = happens(0.3, random);
  for (Index edge = 0; edge < 3; ++edge)
  {
    surface.points.push_back({ 1.0 * edge, 0.1 * edge, 0.0 });
  }
  for (Index edge = 0; edge + 1 < 3; ++edge)
  {
    for (Index page = 2 + below(49, random); page > 0; --page)
    {
      const Vector3 p = randomPosition(random);
      const Vector3 way{ 2.0 * p.x - 1.0, p.y - 0.5, isFlat ? 0.0 : p.z - 0.5 };
      surface.points.push_back(surface.points[edge] + way);
      const auto last = static_cast<Index>(surface.points.size() - 1);
      surface.triangles.push_back({ edge, edge + 1, last });
      // Pages that go on to the next edge close rings of sheets.
      if (happens(0.3, random))
      {
        surface.triangles.push_back({ edge + 1, (edge + 2) % 3, last });
      }
    }
  }
  return surface;
}

Surface foldedFan(Random& random)
{
  const double height = between(1.0, 3.0, random);
  const Index around = 3 + below(happens(0.1, random) ? 498 : 30, random);
  Surface surface = cone(around, 1, 1.0, height);
  for (Vector3& p : surface.points)
  {
    p = happens(0.1, random) ? surface.points[below(surface.points.size(), random)] : p;
  }
  return surface;
}

Surface crossingStrip(Random& random)
{
  Surface surface;
  for (Index i = 3 + below(200, random); i > 0; --i)
  {
    const bool turns = i > 3 && happens(0.1, random);
    const double x = 0.1 * i;
    surface.points.push_back(
      turns ? randomPosition(random) : Vector3{ x, i % 2 * between(0.01, 1.0, random), 0.0 });
    if (const auto last = static_cast<Index>(surface.points.size() - 1); last >= 2)
    {
      surface.triangles.push_back({ last - 2, last - 1, last });
    }
  }
  return surface;
}

Surface crumbs(Random& random)
{
  Surface surface = jittered(random);
  const auto points = static_cast<Index>(surface.points.size());
  for (int i = 0; i < 10; ++i)
  {
    surface.points.push_back(randomPosition(random));
    const Index a = below(points, random);
    const Index b = below(points, random);
    surface.triangles.push_back({ a, a, b });
  }
  surface.points.back().y = std::numeric_limits<double>::quiet_NaN();
  return surface;
}

Surface notFinite(Random& random)
{
  Surface surface = jittered(random);
  surface.points[surface.triangles[below(surface.triangles.size(), random)][0]].z =
    happens(0.5, random) ? std::numeric_limits<double>::quiet_NaN()
                         : std::numeric_limits<double>::infinity();
  return surface;
}

Surface nastySurface(NastyKind kind, Random& random)
{
  switch (kind)
  {
    case NastyKind::LooseSoup:
      return looseSoup(random);
    case NastyKind::Soup:
      return soup(random);
    case NastyKind::FlatSoup:
      return flatSoup(random);
    case NastyKind::Slivers:
      return slivers(random);
    case NastyKind::Folds:
      return folds(random);
    case NastyKind::Doubled:
      return doubled(random);
    case NastyKind::Books:
      return books(random);
    case NastyKind::Fan:
      return foldedFan(random);
    case NastyKind::Strip:
      return crossingStrip(random);
    case NastyKind::Crumbs:
      return crumbs(random);
    case NastyKind::NotFinite:
      return notFinite(random);
    case NastyKind::Count:
      break;
  }
  return {};
}

void resize(Surface& surface, Random& random)
{
  const double scale = happens(0.15, random) ? magnitude(-60.0, 60.0, random) : 1.0;
  const double away = happens(0.1, random) ? 1e7 : 0.0;
  for (Vector3& p : surface.points)
  {
    p = scale * (p + Vector3{ away, 0.3 * away, -away });
  }
}

/** From corner to corner along edges. */
Seed randomCurve(const TriangleMesh& mesh, Random& random)
{
  Index vertex = mesh.triangle(below(mesh.numberOfTriangles(), random))[0];
  std::vector<SurfacePoint> points{ mesh.pointAtVertex(vertex) };
  for (Index steps = 1 + below(5, random); steps > 0; --steps)
  {
    const auto ring = mesh.ring(vertex);
    vertex = ring[below(ring.size(), random)].neighbour();
    points.push_back(mesh.pointAtVertex(vertex));
  }
  return Seed::alongCurve(points);
}

void addSeeds(NastyCase& made, Random& random)
{
  const double kind = between(0.0, 1.0, random);
  Index count = kind < 0.02 ? 0 : kind < 0.6 ? 1 : 2 + below(20, random);
  // Seldom, as each takes its time.
  count = kind > 0.998 ? 10000 : count;
  const double curves = happens(0.1, random) ? 0.3 : 0.0;
  for (; count > 0; --count)
  {
    made.seeds.push_back(happens(curves, random) ? randomCurve(*made.mesh, random)
                                                 : Seed::atPoint(randomPoint(*made.mesh, random)));
  }
}

}

std::string nameOf(NastyKind kind)
{
  static constexpr std::array names{ "loose soup", "soup", "flat soup", "slivers", "folds",
    "doubled", "books", "fan", "strip", "crumbs", "not finite" };
  static_assert(names.size() == static_cast<std::size_t>(NastyKind::Count));
  return names[static_cast<std::size_t>(kind)];
}

SolveOptions NastyCase::options() const
{
  SolveOptions options;
  options.cost = this->cost;
  options.excluded = this->excluded;
  options.closedTriangles = this->closedTriangles;
  return options;
}

std::string NastyCase::description() const
{
  return nameOf(this->kind) + ", " + std::to_string(this->surface.triangles.size()) +
    " triangles, " + std::to_string(this->seeds.size()) + " seeds" +
    (this->cost.empty() ? "" : ", costs") + (this->excluded.empty() ? "" : ", excluded vertices") +
    (this->closedTriangles.empty() ? "" : ", closed triangles");
}

NastyCase nastyCase(unsigned number)
{
  Random random(number);
  NastyCase made;
  made.kind = static_cast<NastyKind>(number % static_cast<unsigned>(NastyKind::Count));
  made.surface = nastySurface(made.kind, random);
  resize(made.surface, random);
  const bool isWelded = made.kind == NastyKind::LooseSoup || happens(0.2, random);
  made.coincident = isWelded ? CoincidentPoints::Merge : CoincidentPoints::Separate;
  try
  {
    made.mesh = meshOf(made.surface, made.coincident);
  }
  catch (const std::invalid_argument& error)
  {
    made.refusal = error.what();
  }
  if (!made.mesh || made.mesh->numberOfTriangles() == 0)
  {
    return made;
  }
  addSeeds(made, random);
  const auto flags = [&](Index count)
  {
    std::vector<std::uint8_t> set(count);
    std::generate(set.begin(), set.end(), [&] { return happens(0.1, random); });
    return set;
  };
  if (happens(0.2, random))
  {
    made.cost.resize(made.mesh->numberOfVertices());
    std::generate(made.cost.begin(), made.cost.end(), [&] { return magnitude(-6.0, 6.0, random); });
  }
  if (happens(0.15, random))
  {
    made.excluded = flags(made.mesh->numberOfVertices());
  }
  if (happens(0.15, random))
  {
    made.closedTriangles = flags(made.mesh->numberOfTriangles());
  }
  return made;
}

}
