#include "SeedCorners.h"

#include "TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace geodesic
{
namespace
{

void check(const TriangleMesh& mesh, const Seed& seed, Index number)
{
  const auto& weights = seed.point.weights;
  const double sum = weights[0] + weights[1] + weights[2];
  const bool inside =
    std::all_of(weights.begin(), weights.end(), [](double w) { return w >= 0.0; });
  const std::string name = "Seed " + std::to_string(number);
  if (seed.point.triangle >= mesh.numberOfTriangles())
  {
    throw std::invalid_argument(name + " lies in triangle " + std::to_string(seed.point.triangle) +
      ", but the mesh has " + std::to_string(mesh.numberOfTriangles()) + " triangles.");
  }
  if (!inside || !(std::abs(sum - 1.0) < 1e-6))
  {
    throw std::invalid_argument(name + " has barycentric weights " + std::to_string(weights[0]) +
      ", " + std::to_string(weights[1]) + ", " + std::to_string(weights[2]) +
      "; each must be at least 0 and their sum 1.");
  }
  if (!(seed.value >= 0.0 && std::isfinite(seed.value)))
  {
    throw std::invalid_argument(name + " has the value " + std::to_string(seed.value) +
      "; it must be finite and at least 0.");
  }
}

/** The corners of every triangle on the edge from @p a to @p b. */
std::vector<Index> cornersRoundEdge(const TriangleMesh& mesh, Index a, Index b)
{
  std::vector<Index> corners{ a, b };
  const std::span<const RingEntry> ring = mesh.ring(a);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    if (ring[i].opensTriangle())
    {
      const Index first = ring[i].neighbour();
      const Index second = ring[i + 1].neighbour();
      if (first == b || second == b)
      {
        corners.push_back(first == b ? second : first);
      }
    }
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::vector<Index> cornersRound(const TriangleMesh& mesh, const SurfacePoint& point)
{
  const Triangle& triangle = mesh.triangle(point.triangle);
  std::vector<Index> carriers;
  for (int c = 0; c < 3; ++c)
  {
    if (point.weights[c] > 0.0)
    {
      carriers.push_back(triangle[c]);
    }
  }
  return carriers.size() == 2 ? cornersRoundEdge(mesh, carriers[0], carriers[1]) : carriers;
}

}

std::vector<SeedCorner> seedCorners(const TriangleMesh& mesh, std::span<const Seed> seeds)
{
  std::vector<SeedCorner> corners;
  for (Index s = 0; s < seeds.size(); ++s)
  {
    check(mesh, seeds[s], s);
    const SurfacePoint& point = seeds[s].point;
    const Vector3 position = mesh.positionOf(point);
    const std::vector<Index> vertices = cornersRound(mesh, point);
    for (Index vertex : vertices)
    {
      const double distance = vertices.size() == 1 ? 0.0 : norm(mesh.position(vertex) - position);
      corners.push_back({ vertex, s, distance });
    }
  }
  return corners;
}

}
