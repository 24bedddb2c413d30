// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WorstSurfaces.h"

#include "ExactDistances.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>

namespace geodesic::testing
{
namespace
{

/** Unit sphere with two poles, points 0 and 1; from one point of its equator to the other side. */
WorstSurface sphereOfLatitudes(Index around, Index rings)
{
  constexpr double pi = std::numbers::pi;
  Surface surface;
  surface.points = { { 0.0, 0.0, -1.0 }, { 0.0, 0.0, 1.0 } };
  for (Index ring = 1; ring <= rings; ++ring)
  {
    const double latitude = pi * ring / (rings + 1) - pi / 2.0;
    for (Index i = 0; i < around; ++i)
    {
      const double longitude = 2.0 * pi * i / around;
      surface.points.push_back({ std::cos(longitude) * std::cos(latitude),
        std::sin(longitude) * std::cos(latitude), std::sin(latitude) });
    }
  }
  addRingCells(surface, 2, around, rings);
  const Index last = 2 + (rings - 1) * around;
  for (Index i = 0; i < around; ++i)
  {
    const Index next = (i + 1) % around;
    surface.triangles.push_back({ 0, 2 + next, 2 + i });
    surface.triangles.push_back({ 1, last + i, last + next });
  }
  const Index equator = 2 + rings / 2 * around;
  return { surface, equator, equator + around / 2 };
}

/** Triangles on one edge; a path between two of them. */
WorstSurface booklet(Index count)
{
  return { pages(count), 2, 2 + count / 2 };
}

/** Triangles round point 0; a straight path between the two points crosses many of them. */
WorstSurface fan(Index triangles)
{
  return { disc(triangles), 1, 1 + triangles / 2 - triangles / 7 };
}

WorstSurface strip(Index squares)
{
  return { planeGrid(squares, 1, squares, 1.0), 0, 2 * squares + 1 };
}

/** The surface of a unit cube, its sides regular grids: all ties that symmetry makes. */
Surface cube(Index cells)
{
  Surface surface;
  std::map<std::array<Index, 3>, Index> numbers;
  const auto pointAt = [&](const std::array<Index, 3>& at)
  {
    const auto [found, isNew] = numbers.emplace(at, static_cast<Index>(surface.points.size()));
    if (isNew)
    {
      const double step = 1.0 / static_cast<double>(cells);
      surface.points.push_back({ step * at[0], step * at[1], step * at[2] });
    }
    return found->second;
  };
  for (Index axis = 0; axis < 3; ++axis)
  {
    for (const Index level : { Index{ 0 }, cells })
    {
      for (Index i = 0; i < cells * cells; ++i)
      {
        const auto corner = [&](Index right, Index up)
        {
          std::array<Index, 3> at{};
          at[axis] = level;
          at[(axis + 1) % 3] = i / cells + (level == 0 ? up : right);
          at[(axis + 2) % 3] = i % cells + (level == 0 ? right : up);
          return pointAt(at);
        };
        surface.triangles.push_back({ corner(0, 0), corner(1, 0), corner(1, 1) });
        surface.triangles.push_back({ corner(0, 0), corner(1, 1), corner(0, 1) });
      }
    }
  }
  return surface;
}

WorstSurface atEnds(Surface surface)
{
  const Index last = static_cast<Index>(surface.points.size()) - 1;
  return { std::move(surface), 0, last };
}

WorstSurface scan(const Surface& whole, bool tiny)
{
  return atEnds(tiny ? icosphere(2) : whole);
}

}

Surface ordinarySurface(std::size_t points)
{
  const Index cells = static_cast<Index>(std::lround(std::sqrt(points))) - 1;
  return hillyGrid(cells, cells);
}

Surface trianglesApart(Index triangles)
{
  const Index columns = static_cast<Index>(std::ceil(std::sqrt(triangles)));
  Surface surface;
  for (Index i = 0; i < triangles; ++i)
  {
    const Vector3 corner{ 2.0 * (i % columns), 2.0 * (i / columns), 0.0 };
    surface.points.push_back(corner);
    surface.points.push_back(corner + Vector3{ 1.0, 0.0, 0.0 });
    surface.points.push_back(corner + Vector3{ 0.0, 1.0, 0.0 });
    surface.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  return surface;
}

Surface flattened(Surface surface, double Vector3::*axis, double factor)
{
  for (Vector3& point : surface.points)
  {
    point.*axis /= factor;
  }
  return surface;
}

WorstSurface worstSurface(const std::string& name, bool tiny)
{
  static const std::map<std::string, std::function<WorstSurface(bool)>> makers{
    { "hilly grid 10k",
      [](bool small) { return atEnds(small ? hillyGrid(9, 9) : hillyGrid(100, 100)); } },
    { "hilly grid 40k",
      [](bool small) { return atEnds(small ? hillyGrid(9, 9) : hillyGrid(199, 199)); } },
    { "hilly grid 160k",
      [](bool small) { return atEnds(small ? hillyGrid(29, 29) : hillyGrid(399, 399)); } },
    { "shaken grid 40k",
      [](bool small)
      {
        const Index cells = small ? 9 : 199;
        return atEnds(jitteredGrid(cells, cells, cells, cells, 0.3, 1));
      } },
    { "Bunny 35k", [](bool small) { return scan(bunny(), small); } },
    { "Spot 3k", [](bool small) { return scan(spot(), small); } },
    { "icosphere 160k", [](bool small) { return atEnds(icosphere(small ? 2 : 7)); } },
    { "Delaunay plane 160k",
      [](bool small) { return atEnds(delaunayPlane(small ? 200 : 160000, 1)); } },
    { "torus 40k",
      [](bool small)
      { return atEnds(small ? torus(20, 10, 1.0, 0.4) : torus(320, 125, 1.0, 0.4)); } },
    { "torus 2k",
      [](bool small)
      { return atEnds(small ? torus(20, 10, 1.0, 0.4) : torus(71, 28, 1.0, 0.4)); } },
    { "box with fillets 40k", [](bool small) { return atEnds(boxWithFillets(small ? 3 : 40)); } },
    { "box with fillets 2k", [](bool small) { return atEnds(boxWithFillets(small ? 3 : 8)); } },
    { "torus 10k",
      [](bool small)
      { return atEnds(small ? torus(20, 10, 1.0, 0.4) : torus(160, 64, 1.0, 0.4)); } },
    { "torus 250k",
      [](bool small)
      { return atEnds(small ? torus(20, 10, 1.0, 0.4) : torus(800, 313, 1.0, 0.4)); } },
    { "icosphere 10k", [](bool small) { return atEnds(icosphere(small ? 2 : 5)); } },
    { "icosphere 2.6M", [](bool small) { return atEnds(icosphere(small ? 3 : 9)); } },
    { "Delaunay plane 10k",
      [](bool small) { return atEnds(delaunayPlane(small ? 200 : 10000, 1)); } },
    { "thin grid 10k",
      [](bool small)
      { return atEnds(jitteredGrid(small ? 40 : 320, small ? 4 : 31, 1.0, 1.0, 0.4, 1)); } },
    { "thin grid 160k",
      [](bool small)
      { return atEnds(jitteredGrid(small ? 40 : 1265, small ? 4 : 126, 1.0, 1.0, 0.4, 1)); } },
    { "cube 10k", [](bool small) { return atEnds(cube(small ? 4 : 41)); } },
    { "saddles 10k", [](bool small) { return atEnds(roughGrid(small ? 9 : 99)); } },
    { "hilly grid 1M",
      [](bool small) { return atEnds(small ? hillyGrid(49, 49) : hillyGrid(999, 999)); } },
    { "parts 100k", [](bool small) { return atEnds(trianglesApart(small ? 100 : 100000)); } },
    { "strip 100k", [](bool small) { return strip(small ? 100 : 100000); } },
    { "fan 100k", [](bool small) { return fan(small ? 100 : 100000); } },
    { "strip 300k", [](bool small) { return strip(small ? 100 : 300000); } },
    { "sphere of latitudes 1M",
      [](bool small) { return small ? sphereOfLatitudes(20, 9) : sphereOfLatitudes(1000, 999); } },
    { "pages 100k", [](bool small) { return booklet(small ? 100 : 100000); } },
  };
  const auto found = makers.find(name);
  if (found == makers.end())
  {
    throw std::invalid_argument("There is no surface " + name);
  }
  return found->second(tiny);
}

}
