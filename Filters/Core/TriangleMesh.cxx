#include "TriangleMesh.h"

#include "SpatialOrder.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

namespace geodesic
{
namespace
{

/** Flags the points that triangles use, after checking that they can be used. */
std::vector<std::uint8_t> usedPoints(
  std::span<const Vector3> points, std::span<const Triangle> triangles)
{
  std::vector<std::uint8_t> used(points.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (Index point : triangles[t])
    {
      if (point >= points.size())
      {
        throw std::invalid_argument("Triangle " + std::to_string(t) + " uses point " +
          std::to_string(point) + ", but the surface has " + std::to_string(points.size()) +
          " points. Clean the surface.");
      }
      used[point] = 1;
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (used[i] && !isFinite(points[i]))
    {
      std::ostringstream message;
      message << "Point " << i << " is at (" << points[i].x << ", " << points[i].y << ", "
              << points[i].z << "), which is no finite position, and cells use it. Remove it, for "
              << "example with Threshold.";
      throw std::invalid_argument(message.str());
    }
  }
  return used;
}

Index lowestCorner(const Triangle& t)
{
  return std::min({ t[0], t[1], t[2] });
}

bool repeatsCorner(const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

float roundedUp(double length)
{
  const float rounded = static_cast<float>(length);
  return rounded < length ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
                          : rounded;
}

}

TriangleMesh::TriangleMesh(
  std::span<const Vector3> points, std::span<const Triangle> triangles, CoincidentPoints coincident)
{
  if (points.size() > RingEntry::MaximumVertices)
  {
    throw std::length_error("The surface has " + std::to_string(points.size()) +
      " points; one process holds at most " + std::to_string(RingEntry::MaximumVertices) +
      ". Spread it over more ranks.");
  }
  this->numberVertices(points, triangles, coincident);
  this->orderTriangles(triangles);
  this->Rings = VertexRings(this->Positions, this->Triangles);
  if (this->Triangles.size() < triangles.size())
  {
    this->forgetBareVertices();
  }
  this->measureEdges();
}

void TriangleMesh::numberVertices(
  std::span<const Vector3> points, std::span<const Triangle> triangles, CoincidentPoints coincident)
{
  const std::vector<Index> order = spatialOrder(points, usedPoints(points, triangles));
  this->VertexOfPoint.assign(points.size(), NoIndex);
  this->Positions.reserve(order.size());
  this->PointOfVertex.reserve(order.size());
  for (Index point : order)
  {
    const bool isSame = coincident == CoincidentPoints::Merge && !this->Positions.empty() &&
      this->Positions.back() == points[point];
    if (!isSame)
    {
      this->Positions.push_back(points[point]);
      this->PointOfVertex.push_back(point);
    }
    this->VertexOfPoint[point] = this->numberOfVertices() - 1;
  }
}

void TriangleMesh::orderTriangles(std::span<const Triangle> triangles)
{
  const auto asVertices = [this](const Triangle& t) -> Triangle {
    return { this->VertexOfPoint[t[0]], this->VertexOfPoint[t[1]], this->VertexOfPoint[t[2]] };
  };
  std::vector<Index> starts(std::size_t{ this->numberOfVertices() } + 1, 0);
  for (const Triangle& input : triangles)
  {
    const Triangle t = asVertices(input);
    if (!repeatsCorner(t))
    {
      ++starts[lowestCorner(t) + 1];
    }
  }
  for (std::size_t v = 1; v < starts.size(); ++v)
  {
    starts[v] += starts[v - 1];
  }
  this->Triangles.resize(starts.back());
  this->SourceOfTriangle.resize(starts.back());
  for (Index source = 0; source < triangles.size(); ++source)
  {
    const Triangle t = asVertices(triangles[source]);
    if (!repeatsCorner(t))
    {
      const Index place = starts[lowestCorner(t)]++;
      this->Triangles[place] = t;
      this->SourceOfTriangle[place] = source;
    }
  }
}

void TriangleMesh::forgetBareVertices()
{
  for (Index& vertex : this->VertexOfPoint)
  {
    vertex = vertex != NoIndex && this->ring(vertex).empty() ? NoIndex : vertex;
  }
}

void TriangleMesh::measureEdges()
{
  this->LongestEdgeAround.assign(this->numberOfVertices(), 0.0f);
  double sum = 0.0;
  for (const Triangle& t : this->Triangles)
  {
    double longest = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const double length = norm(this->Positions[t[c]] - this->Positions[t[(c + 1) % 3]]);
      sum += length;
      longest = std::max(longest, length);
    }
    for (Index v : t)
    {
      this->LongestEdgeAround[v] = std::max(this->LongestEdgeAround[v], roundedUp(longest));
    }
    this->LongestEdgeLength = std::max(this->LongestEdgeLength, longest);
  }
  if (!this->Triangles.empty())
  {
    this->MeanEdgeLength = sum / (3.0 * static_cast<double>(this->Triangles.size()));
  }
}

SurfacePoint TriangleMesh::pointAtVertex(Index vertex) const
{
  SurfacePoint point;
  point.triangle = this->trianglesWith({ &vertex, 1 }).front();
  for (int c = 0; c < 3; ++c)
  {
    point.weights[c] = this->Triangles[point.triangle][c] == vertex ? 1.0 : 0.0;
  }
  return point;
}

std::vector<Index> TriangleMesh::trianglesWith(std::span<const Index> corners) const
{
  const auto hasAll = [&](const Triangle& t)
  {
    return std::all_of(corners.begin(), corners.end(),
      [&](Index corner) { return std::find(t.begin(), t.end(), corner) != t.end(); });
  };
  const auto isBefore = [](const Triangle& t, Index lowest) { return lowestCorner(t) < lowest; };
  std::vector<Index> found;
  const std::span<const RingEntry> ring = this->ring(corners[0]);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Index next = ring[i].opensTriangle() ? ring[i + 1].neighbour() : ring[i].neighbour();
    const Triangle wanted{ corners[0], ring[i].neighbour(), next };
    if (!ring[i].opensTriangle() || !hasAll(wanted))
    {
      continue;
    }
    const Index lowest = lowestCorner(wanted);
    auto t = std::lower_bound(this->Triangles.begin(), this->Triangles.end(), lowest, isBefore);
    for (; t != this->Triangles.end() && lowestCorner(*t) == lowest; ++t)
    {
      if (std::is_permutation(t->begin(), t->end(), wanted.begin()))
      {
        found.push_back(static_cast<Index>(t - this->Triangles.begin()));
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Vector3 TriangleMesh::positionOf(const SurfacePoint& point) const
{
  const Triangle& corners = this->Triangles[point.triangle];
  return point.weights[0] * this->Positions[corners[0]] +
    point.weights[1] * this->Positions[corners[1]] + point.weights[2] * this->Positions[corners[2]];
}

}
