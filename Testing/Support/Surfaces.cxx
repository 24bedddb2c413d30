// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <unordered_map>

namespace geodesic::testing
{
namespace
{

/** Adds the two triangles of the cell a b c d, given round its border. */
void addCell(Surface& surface, Index a, Index b, Index c, Index d)
{
  surface.triangles.push_back({ a, b, c });
  surface.triangles.push_back({ a, c, d });
}

/**
 * Cuts each triangle in four.
 * @param place  returns where the middle of an edge goes
 */
template <class Place>
Surface cutInFour(const Surface& surface, const Place& place)
{
  Surface finer{ surface.points, {} };
  std::unordered_map<std::uint64_t, Index> middles;
  const auto middle = [&](Index a, Index b)
  {
    const std::uint64_t edge = std::uint64_t{ std::min(a, b) } << 32 | std::max(a, b);
    const auto [found, isNew] = middles.emplace(edge, static_cast<Index>(finer.points.size()));
    if (isNew)
    {
      finer.points.push_back(place(0.5 * (surface.points[a] + surface.points[b])));
    }
    return found->second;
  };
  finer.triangles.reserve(4 * surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles)
  {
    const Index ab = middle(a, b);
    const Index bc = middle(b, c);
    const Index ca = middle(c, a);
    finer.triangles.insert(
      finer.triangles.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
  }
  return finer;
}

Vector3 onUnitSphere(const Vector3& point)
{
  return (1.0 / norm(point)) * point;
}

}

void addRingCells(Surface& surface, Index first, Index around, Index rings)
{
  for (Index ring = 0; ring + 1 < rings; ++ring)
  {
    for (Index i = 0; i < around; ++i)
    {
      const Index low = first + ring * around;
      const Index next = (i + 1) % around;
      addCell(surface, low + i, low + next, low + around + next, low + around + i);
    }
  }
}

Surface planeGrid(Index columns, Index rows, double width, double height)
{
  Surface surface;
  for (Index j = 0; j <= rows; ++j)
  {
    for (Index i = 0; i <= columns; ++i)
    {
      surface.points.push_back({ width * i / columns, height * j / rows, 0.0 });
    }
  }
  for (Index j = 0; j < rows; ++j)
  {
    for (Index i = 0; i < columns; ++i)
    {
      const Index low = j * (columns + 1) + i;
      addCell(surface, low, low + 1, low + columns + 2, low + columns + 1);
    }
  }
  return surface;
}

Surface jitteredGrid(
  Index columns, Index rows, double width, double height, double fraction, unsigned seed)
{
  Surface surface = planeGrid(columns, rows, width, height);
  const double amount = fraction * std::min(width / columns, height / rows);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-amount, amount);
  for (Index j = 1; j < rows; ++j)
  {
    for (Index i = 1; i < columns; ++i)
    {
      Vector3& point = surface.points[j * (columns + 1) + i];
      point.x += move(random);
      point.y += move(random);
    }
  }
  return surface;
}

Surface hillyGrid(Index columns, Index rows)
{
  Surface surface = planeGrid(columns, rows, columns, rows);
  for (Vector3& point : surface.points)
  {
    point.z = 3.0 * std::sin(point.x / 9.0) * std::cos(point.y / 7.0);
  }
  return surface;
}

Surface roughGrid(Index cells)
{
  Surface surface = planeGrid(cells, cells, cells, cells);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> height(-0.7, 0.7);
  for (Vector3& point : surface.points)
  {
    point.z = height(random);
  }
  return surface;
}

Surface icosphere(int levels)
{
  const double golden = std::numbers::phi;
  const Vector3 corners[12] = { { -1, golden, 0 }, { 1, golden, 0 }, { -1, -golden, 0 },
    { 1, -golden, 0 }, { 0, -1, golden }, { 0, 1, golden }, { 0, -1, -golden }, { 0, 1, -golden },
    { golden, 0, -1 }, { golden, 0, 1 }, { -golden, 0, -1 }, { -golden, 0, 1 } };
  const Triangle faces[20] = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };

  Surface surface;
  for (const Vector3& corner : corners)
  {
    surface.points.push_back(onUnitSphere(corner));
  }
  surface.triangles.assign(std::begin(faces), std::end(faces));
  for (int level = 0; level < levels; ++level)
  {
    surface = cutInFour(surface, onUnitSphere);
  }
  return surface;
}

Surface subdivided(Surface surface, int times)
{
  for (int i = 0; i < times; ++i)
  {
    surface = cutInFour(surface, [](const Vector3& middle) { return middle; });
  }
  return surface;
}

Surface torus(Index around, Index across, double majorRadius, double minorRadius)
{
  Surface surface;
  const double step = 2.0 * std::numbers::pi;
  for (Index j = 0; j < across; ++j)
  {
    for (Index i = 0; i < around; ++i)
    {
      const double u = step * i / around;
      const double v = step * j / across;
      const double r = majorRadius + minorRadius * std::cos(v);
      surface.points.push_back({ r * std::cos(u), r * std::sin(u), minorRadius * std::sin(v) });
    }
  }
  addRingCells(surface, 0, around, across);
  for (Index i = 0; i < around; ++i)
  {
    const Index last = (across - 1) * around;
    const Index next = (i + 1) % around;
    addCell(surface, last + i, last + next, next, i);
  }
  return surface;
}

Surface cylinder(Index around, Index along, double radius, double height)
{
  Surface surface;
  for (Index j = 0; j <= along; ++j)
  {
    for (Index i = 0; i < around; ++i)
    {
      const double angle = 2.0 * std::numbers::pi * i / around;
      surface.points.push_back(
        { radius * std::cos(angle), radius * std::sin(angle), height * j / along });
    }
  }
  addRingCells(surface, 0, around, along + 1);
  return surface;
}

Surface pages(Index count)
{
  Surface surface;
  surface.points = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  for (Index i = 0; i < count; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / count;
    surface.points.push_back({ std::cos(angle), std::sin(angle), 0.5 });
    surface.triangles.push_back({ 0, 1, 2 + i });
  }
  return surface;
}

Surface disc(Index around)
{
  return cone(around, 1, 1.0, 1.0);
}

Surface cone(Index around, Index along, double radius, double slope)
{
  Surface surface;
  surface.points.push_back({ 0.0, 0.0, 0.0 });
  const double height = std::sqrt(slope * slope - radius * radius);
  for (Index j = 1; j <= along; ++j)
  {
    const double part = static_cast<double>(j) / along;
    for (Index i = 0; i < around; ++i)
    {
      const double angle = 2.0 * std::numbers::pi * i / around;
      surface.points.push_back(
        { part * radius * std::cos(angle), part * radius * std::sin(angle), -part * height });
    }
  }
  for (Index i = 0; i < around; ++i)
  {
    surface.triangles.push_back({ 0, 1 + i, 1 + (i + 1) % around });
  }
  addRingCells(surface, 1, around, along);
  return surface;
}

Surface boxWithFillets(Index perHalf)
{
  constexpr Vector3 core{ 1.0, 0.7, 0.4 };
  constexpr double radius = 0.15;
  // Points of a cube's surface with coordinates from 0 to last, of which the middle ones are far
  // apart: each is pulled to where its normal meets the box.
  const Index last = 2 * perHalf + 1;
  const auto slope = [&](Index i)
  {
    const double steps = i <= perHalf ? static_cast<double>(i) - perHalf : i - perHalf - 1.0;
    return std::tan(std::numbers::pi / 4.0 * steps / perHalf);
  };
  Surface surface;
  std::map<std::array<Index, 3>, Index> numbers;
  const auto pointAt = [&](const std::array<Index, 3>& at)
  {
    const auto [found, isNew] = numbers.emplace(at, static_cast<Index>(surface.points.size()));
    if (isNew)
    {
      const Vector3 normal{ slope(at[0]), slope(at[1]), slope(at[2]) };
      const auto side = [&](Index i) { return i <= perHalf ? -1.0 : 1.0; };
      const Vector3 centre{ side(at[0]) * core.x, side(at[1]) * core.y, side(at[2]) * core.z };
      surface.points.push_back(centre + radius / norm(normal) * normal);
    }
    return found->second;
  };
  for (Index axis = 0; axis < 3; ++axis)
  {
    for (const Index level : { Index{ 0 }, last })
    {
      for (Index i = 0; i < last; ++i)
      {
        for (Index j = 0; j < last; ++j)
        {
          const auto corner = [&](Index right, Index up)
          {
            // Seen from outside, right and up change places on opposite sides.
            std::array<Index, 3> at{};
            at[axis] = level;
            at[(axis + 1) % 3] = i + (level == 0 ? up : right);
            at[(axis + 2) % 3] = j + (level == 0 ? right : up);
            return pointAt(at);
          };
          surface.triangles.push_back({ corner(0, 0), corner(1, 0), corner(1, 1) });
          surface.triangles.push_back({ corner(0, 0), corner(1, 1), corner(0, 1) });
        }
      }
    }
  }
  return surface;
}

Surface joined(const Surface& a, const Surface& b)
{
  Surface both = a;
  const Index shift = static_cast<Index>(a.points.size());
  both.points.insert(both.points.end(), b.points.begin(), b.points.end());
  for (const Triangle& t : b.triangles)
  {
    both.triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
  return both;
}

Surface withPointsShuffled(const Surface& surface, unsigned seed, std::vector<Index>& newId)
{
  std::mt19937 random(seed);
  newId.resize(surface.points.size());
  std::iota(newId.begin(), newId.end(), 0u);
  std::shuffle(newId.begin(), newId.end(), random);
  Surface result;
  result.points.resize(surface.points.size());
  for (std::size_t i = 0; i < newId.size(); ++i)
  {
    result.points[newId[i]] = surface.points[i];
  }
  for (const Triangle& t : surface.triangles)
  {
    result.triangles.push_back({ newId[t[0]], newId[t[1]], newId[t[2]] });
  }
  return result;
}

Surface shuffled(const Surface& surface, unsigned seed, std::vector<Index>& newId)
{
  Surface result = withPointsShuffled(surface, seed, newId);
  std::mt19937 random(seed);
  for (Triangle& t : result.triangles)
  {
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  }
  std::shuffle(result.triangles.begin(), result.triangles.end(), random);
  return result;
}

Surface readOff(const std::string& file)
{
  std::ifstream in(file);
  std::string magic;
  std::size_t points = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  in >> magic >> points >> faces >> edges;
  Surface surface;
  surface.points.resize(in ? points : 0);
  surface.triangles.resize(in ? faces : 0);
  for (Vector3& p : surface.points)
  {
    in >> p.x >> p.y >> p.z;
  }
  for (Triangle& t : surface.triangles)
  {
    int corners = 0;
    in >> corners >> t[0] >> t[1] >> t[2];
  }
  if (!in || magic != "OFF")
  {
    throw std::runtime_error(file + " is no OFF file of triangles");
  }
  return surface;
}

const Surface& spot()
{
  static const Surface surface = readOff(GEODESICS_OFF_DIRECTORY "/Spot.off");
  return surface;
}

const Surface& bunny()
{
  static const Surface surface = readOff(GEODESICS_OFF_DIRECTORY "/Bunny.off");
  return surface;
}

}
