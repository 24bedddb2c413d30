// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LevelSides.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace geodesic::testing
{
namespace
{

using Edge = std::pair<Index, Index>;

/** A connected set of vertices with one sign of the function. */
struct Patch
{
  double area = 0.0;
  double border = 0.0;
  std::vector<std::size_t> curves;
};

/** A curve between two patches. */
struct Between
{
  Index minusPatch;
  Index plusPatch;
  bool isClosed;
  /** Whether the function is positive on the left. */
  bool leftIsPlus;
};

class Flood
{
public:
  Flood(const TriangleMesh& mesh, std::span<const double> values)
    : Mesh(mesh)
    , Values(values)
    , PatchOf(mesh.numberOfVertices(), NoIndex)
  {
    this->findPatches();
    this->measure();
  }

  Index patchOf(Index vertex) const { return this->PatchOf[vertex]; }

  void addCurve(const Between& curve)
  {
    this->Patches[curve.minusPatch].curves.push_back(this->Curves.size());
    this->Patches[curve.plusPatch].curves.push_back(this->Curves.size());
    this->Curves.push_back(curve);
  }

  std::optional<std::vector<std::int8_t>> signs() const
  {
    std::vector<std::int8_t> ofPatch(this->Patches.size(), 1);
    for (std::size_t curve = 0; curve < this->Curves.size(); ++curve)
    {
      const Between& between = this->Curves[curve];
      const std::vector<bool> plus = this->without(curve, between.plusPatch);
      if (plus[between.minusPatch])
      {
        return std::nullopt;
      }
      const std::vector<bool> minus = this->without(curve, between.minusPatch);
      const bool plusIsInside = between.isClosed ? this->isLess(plus, minus) : !between.leftIsPlus;
      const std::vector<bool>& inside = plusIsInside ? plus : minus;
      for (std::size_t patch = 0; patch < inside.size(); ++patch)
      {
        ofPatch[patch] = static_cast<std::int8_t>(inside[patch] ? -ofPatch[patch] : ofPatch[patch]);
      }
    }
    std::vector<std::int8_t> signs;
    for (const Index patch : this->PatchOf)
    {
      const bool isAlone = this->Patches[patch].curves.empty();
      signs.push_back(isAlone ? std::int8_t{ 0 } : ofPatch[patch]);
    }
    return signs;
  }

private:
  void findPatches()
  {
    for (Index start = 0; start < this->PatchOf.size(); ++start)
    {
      if (this->PatchOf[start] != NoIndex)
      {
        continue;
      }
      const auto patch = static_cast<Index>(this->Patches.size());
      this->Patches.emplace_back();
      this->PatchOf[start] = patch;
      std::vector<Index> waiting{ start };
      while (!waiting.empty())
      {
        const Index vertex = waiting.back();
        waiting.pop_back();
        for (const RingEntry& entry : this->Mesh.ring(vertex))
        {
          const Index other = entry.neighbour();
          if (this->PatchOf[other] == NoIndex && this->isPlus(other) == this->isPlus(vertex))
          {
            this->PatchOf[other] = patch;
            waiting.push_back(other);
          }
        }
      }
    }
  }

  bool isPlus(Index vertex) const { return this->Values[vertex] > 0.0; }

  void measure()
  {
    std::map<Edge, int> faces;
    for (const Triangle& t : this->Mesh.triangles())
    {
      for (int c = 0; c < 3; ++c)
      {
        ++faces[std::minmax(t[c], t[(c + 1) % 3])];
      }
      this->measureFace(t);
    }
    for (const auto& [edge, count] : faces)
    {
      const auto [a, b] = edge;
      const double length = norm(this->Mesh.position(a) - this->Mesh.position(b));
      if (count == 1)
      {
        const double part = this->PatchOf[a] == this->PatchOf[b] ? 0.5 : this->fraction(a, b);
        this->Patches[this->PatchOf[a]].border += part * length;
        this->Patches[this->PatchOf[b]].border += (1.0 - part) * length;
      }
    }
  }

  void measureFace(const Triangle& t)
  {
    const Vector3& p = this->Mesh.position(t[0]);
    const double area =
      0.5 * norm(cross(this->Mesh.position(t[1]) - p, this->Mesh.position(t[2]) - p));
    for (int c = 0; c < 3; ++c)
    {
      const Index a = t[c];
      const Index b = t[(c + 1) % 3];
      const Index d = t[(c + 2) % 3];
      if (this->isPlus(a) != this->isPlus(b) && this->isPlus(b) == this->isPlus(d))
      {
        const double part = this->fraction(a, b) * this->fraction(a, d);
        this->Patches[this->PatchOf[a]].area += part * area;
        this->Patches[this->PatchOf[b]].area += (1.0 - part) * area;
        return;
      }
    }
    this->Patches[this->PatchOf[t[0]]].area += area;
  }

  /** Where the function is zero on the way from a to b. */
  double fraction(Index a, Index b) const
  {
    return this->Values[a] / (this->Values[a] - this->Values[b]);
  }

  /** The patches that are connected with one if a curve may not be crossed. */
  std::vector<bool> without(std::size_t closed, Index start) const
  {
    std::vector<bool> isThere(this->Patches.size(), false);
    isThere[start] = true;
    std::vector<Index> waiting{ start };
    while (!waiting.empty())
    {
      const Index patch = waiting.back();
      waiting.pop_back();
      for (const std::size_t curve : this->Patches[patch].curves)
      {
        const Between& between = this->Curves[curve];
        const Index other = between.plusPatch == patch ? between.minusPatch : between.plusPatch;
        if (curve != closed && !isThere[other])
        {
          isThere[other] = true;
          waiting.push_back(other);
        }
      }
    }
    return isThere;
  }

  bool isLess(const std::vector<bool>& a, const std::vector<bool>& b) const
  {
    const auto sum = [&](const std::vector<bool>& set, double Patch::*measure)
    {
      double total = 0.0;
      for (std::size_t patch = 0; patch < set.size(); ++patch)
      {
        total += set[patch] ? this->Patches[patch].*measure : 0.0;
      }
      return total;
    };
    const double border = sum(a, &Patch::border) - sum(b, &Patch::border);
    const double whole = sum(a, &Patch::border) + sum(b, &Patch::border);
    return std::abs(border) > 1e-9 * whole ? border < 0.0
                                           : sum(a, &Patch::area) < sum(b, &Patch::area);
  }

  const TriangleMesh& Mesh;
  std::span<const double> Values;
  std::vector<Index> PatchOf;
  std::vector<Patch> Patches;
  std::vector<Between> Curves;
};

/** The edges that the curve crosses, in its order; a closed one has its first edge again. */
std::vector<Edge> traced(std::map<Edge, std::vector<Edge>>& next, const Edge& start)
{
  std::vector<Edge> edges{ start };
  while (!next[edges.back()].empty())
  {
    const Edge from = edges.back();
    const Edge to = next[from].back();
    next[from].pop_back();
    std::erase(next[to], from);
    edges.push_back(to);
  }
  return edges;
}

}

LevelSides levelSides(
  const TriangleMesh& mesh, std::span<const double> values, std::mt19937& random)
{
  std::map<Edge, std::vector<Edge>> next;
  for (const Triangle& t : mesh.triangles())
  {
    std::vector<Edge> crossed;
    for (int c = 0; c < 3; ++c)
    {
      const Edge edge = std::minmax(t[c], t[(c + 1) % 3]);
      if ((values[edge.first] > 0.0) != (values[edge.second] > 0.0))
      {
        crossed.push_back(edge);
      }
    }
    if (crossed.size() == 2)
    {
      next[crossed[0]].push_back(crossed[1]);
      next[crossed[1]].push_back(crossed[0]);
    }
  }
  LevelSides sides;
  Flood flood(mesh, values);
  // Open curves first, from their ends.
  for (const std::size_t faces : { 1, 2 })
  {
    for (const auto& [start, neighbours] : next)
    {
      if (neighbours.size() != faces)
      {
        continue;
      }
      std::vector<Edge> edges = traced(next, start);
      if (random() % 2 == 0)
      {
        std::reverse(edges.begin(), edges.end());
      }
      SurfacePath curve;
      for (const auto& [a, b] : edges)
      {
        curve.push_back(PathPoint::onEdge(a, b, values[a] / (values[a] - values[b])));
      }
      const Carriers corners = unionOf(curve[0], curve[1]);
      const Triangle face =
        mesh.triangle(mesh.trianglesWith({ corners.begin(), corners.end() }).front());
      const auto [a, b] = edges[0];
      const Index plus = values[a] > 0.0 ? a : b;
      const Vector3& corner = mesh.position(face[0]);
      const Vector3 normal =
        cross(mesh.position(face[1]) - corner, mesh.position(face[2]) - corner);
      const Vector3 along = curve[1].position(mesh) - curve[0].position(mesh);
      const Vector3 toPlus = mesh.position(plus) - curve[0].position(mesh);
      flood.addCurve({ flood.patchOf(plus == a ? b : a), flood.patchOf(plus),
        edges.front() == edges.back(), dot(cross(normal, along), toPlus) > 0.0 });
      sides.curves.push_back(std::move(curve));
    }
  }
  sides.signs = flood.signs();
  return sides;
}

std::vector<double> randomLevels(const TriangleMesh& mesh, std::mt19937& random)
{
  std::uniform_real_distribution<double> unit;
  const auto pick = [&] { return mesh.position(random() % mesh.numberOfVertices()); };
  const Vector3 centre = pick();
  const double radius = (0.2 + unit(random)) * norm(pick() - centre) + 1e-3;
  const Vector3 wave{ 8.0 * unit(random) / radius, 8.0 * unit(random) / radius,
    8.0 * unit(random) / radius };
  const double height = unit(random) < 0.5 ? 0.0 : 0.4 * unit(random);
  std::vector<double> values;
  for (const Vector3& p : mesh.positions())
  {
    values.push_back(norm(p - centre) / radius - 1.0 + height * std::sin(dot(wave, p - centre)));
  }
  return values;
}

}
