// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/LabelPlaces.h"

#include "base/Platform.h"
#include "mesh/Carriers.h"
#include "mesh/SimpleFan.h"
#include "mesh/TriangleMesh.h"
#include "solve/Partition.h"
#include "solve/SeedFront.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

namespace geodesic
{
namespace
{

/** How often goesOn() is called. */
constexpr std::size_t PlacesOfReport = 512;
/** Round vertices with more triangles the normals are sorted. */
constexpr std::size_t MostOfFlat = 12;

/** The order of coordinates. */
bool isLess(const Vector3& a, const Vector3& b)
{
  return a.x != b.x ? a.x < b.x : std::tie(a.y, a.z) < std::tie(b.y, b.z);
}

/** The normal of a triangle, on the side from which its corners go round to the left, and twice its
 * area long. It is the same to the last bit with whichever corner the triangle begins. */
Vector3 normalOf(const TriangleMesh& mesh, const Triangle& corners)
{
  const auto at = [&](int corner) -> const Vector3&
  { return mesh.position(corners[static_cast<std::size_t>(corner)]); };
  int first = isLess(at(1), at(0)) ? 1 : 0;
  first = isLess(at(2), at(first)) ? 2 : first;
  const Vector3& a = at(first);
  // The product is turned round to the last bit with the order of the other two.
  return cross(at(first == 2 ? 0 : first + 1) - a, at(first == 0 ? 2 : first - 1) - a);
}

/** The sum of different normals, each turned to the side of those before it. They are sorted first:
 * where they differ by right angles the order decides, and it must not be that of triangles and
 * pieces. */
Vector3 alignedSum(std::vector<Vector3>& normals)
{
  std::sort(normals.begin(), normals.end(), isLess);
  normals.erase(std::unique(normals.begin(), normals.end()), normals.end());
  Vector3 sum{ 0.0, 0.0, 0.0 };
  for (const Vector3& normal : normals)
  {
    sum = sum + (dot(sum, normal) < 0.0 ? -1.0 : 1.0) * normal;
  }
  return sum;
}

/** Rings of vertices go round either way: -1 for one against the order of the corners of @p
 * triangle, which is one of those round the vertex; else 1. */
double turnOf(const TriangleMesh& mesh, Index vertex, Index triangle)
{
  const Triangle& corners = mesh.triangle(triangle);
  const auto at = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
  const Index next = corners[static_cast<std::size_t>((at + 1) % 3)];
  const Index last = corners[static_cast<std::size_t>((at + 2) % 3)];
  const std::span<const RingEntry> ring = mesh.ring(vertex);
  const auto isAgainst = [&](const RingEntry& first, const RingEntry& second)
  { return first.neighbour() == last && second.neighbour() == next; };
  return std::adjacent_find(ring.begin(), ring.end(), isAgainst) == ring.end() ? 1.0 : -1.0;
}

/** As alignedSum() of the normals at a vertex where the surface is so flat that their order hardly
 * changes a bit of it: each is within nearly 45 degrees of the sum, so that none has to be turned.
 * Nothing if it is not as flat as that. @param triangle  one of those round the vertex */
std::optional<Vector3> flatSumAt(const TriangleMesh& mesh, Index vertex, Index triangle)
{
  const std::span<const RingEntry> ring = mesh.ring(vertex);
  if (ring.size() > MostOfFlat + 1 || mesh.isIntrinsic() || !isSimpleFan(ring))
  {
    return std::nullopt;
  }
  std::array<Vector3, MostOfFlat> normals;
  auto last = normals.begin();
  Vector3 sum{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
  {
    *last = normalOf(mesh, { vertex, ring[i].neighbour(), ring[i + 1].neighbour() });
    if (std::find(normals.begin(), last, *last) == last)
    {
      sum = sum + *last;
      ++last;
    }
  }
  // Rounding must not tell whether two normals are at right angles.
  constexpr double within = 1.0 + 1e-6;
  const double square = within * dot(sum, sum);
  const bool isFlat = std::all_of(normals.begin(), last,
    [&](const Vector3& normal)
    {
      const double along = dot(normal, sum);
      return along > 0.0 && 2.0 * along * along > square * dot(normal, normal);
    });
  return isFlat ? std::optional(turnOf(mesh, vertex, triangle) * sum) : std::nullopt;
}

/** Appends the normals of this piece's triangles at a point: those of which it is a corner, or on
 * an edge, or that it lies in. All pieces together have those of the whole surface, some of them
 * several times: ghost triangles are in several pieces. On an intrinsic mesh a corner without a
 * position makes a normal of NaN, which does not count. */
void appendNormalsAt(
  const TriangleMesh& mesh, const SurfacePoint& point, std::vector<Vector3>& normals)
{
  const Carriers carriers = carriersOf(mesh, point);
  if (carriers.size() == 3)
  {
    normals.push_back(normalOf(mesh, mesh.triangle(point.triangle)));
    return;
  }
  Index centre = carriers[0];
  Index other = carriers[carriers.size() - 1];
  if (mesh.ring(other).size() < mesh.ring(centre).size())
  {
    std::swap(centre, other);
  }
  const std::span<const RingEntry> ring = mesh.ring(centre);
  if (!isSimpleFan(ring))
  {
    for (const Index triangle : mesh.trianglesWith({ carriers.begin(), carriers.end() }))
    {
      normals.push_back(normalOf(mesh, mesh.triangle(triangle)));
    }
    return;
  }
  const double turn = turnOf(mesh, centre, point.triangle);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    if (ring[i].opensTriangle())
    {
      const Triangle triangle{ centre, ring[i].neighbour(), ring[i + 1].neighbour() };
      if (std::find(triangle.begin(), triangle.end(), other) != triangle.end())
      {
        normals.push_back(turn * normalOf(mesh, triangle));
      }
    }
  }
}

/** Whether other pieces may have triangles at a point, too. */
bool isShared(const TriangleMesh& mesh, const SurfacePoint& point, const Partition& partition)
{
  const std::span<const Index> shared = partition.sharedVertices();
  const Carriers carriers = carriersOf(mesh, point);
  return carriers.size() < 3 &&
    std::all_of(carriers.begin(), carriers.end(),
      [&](Index vertex) { return std::binary_search(shared.begin(), shared.end(), vertex); });
}

/** Appends the normals at a point that other pieces may share, as appendNormalsAt(); else their
 * aligned sum. */
void findNormalsAt(
  const TriangleMesh& mesh, const SurfacePoint& point, bool isShared, std::vector<Vector3>& normals)
{
  const Carriers carriers = carriersOf(mesh, point);
  if (const auto sum = isShared || carriers.size() > 1
      ? std::nullopt
      : flatSumAt(mesh, carriers[0], point.triangle))
  {
    normals.push_back(*sum);
    return;
  }
  appendNormalsAt(mesh, point, normals);
  if (mesh.isIntrinsic())
  {
    std::erase_if(normals, [](const Vector3& normal) { return !isFinite(normal); });
  }
  if (!isShared)
  {
    normals.assign(1, alignedSum(normals));
  }
}

/** A direction of length 1 with few digits, so that rounding hardly ever changes it: copies of a
 * point on several pieces may differ by so much. */
Vector3 roundedDirection(const Vector3& vector)
{
  constexpr double steps = 1 << 20;
  const double length = norm(vector);
  const auto rounded = [&](double x) { return std::round(x / length * steps) / steps; };
  return length > 0.0 ? Vector3{ rounded(vector.x), rounded(vector.y), rounded(vector.z) } : vector;
}

/** Asks the processor to fetch what labelPlaces() reads for starts that come soon: seeds lie
 * anywhere.
 */
GEODESIC_INLINED void prefetchLater(
  const TriangleMesh& mesh, const SeedFront& front, std::size_t start)
{
  constexpr std::size_t soon = 8;
  if (start + 2 * soon < front.starts.size())
  {
    mesh.prefetchRingStart(front.starts[start + 2 * soon].vertex);
    const FrontStart& next = front.starts[start + soon];
    mesh.prefetch(next.vertex);
    const std::span<const RingEntry> ring = mesh.ring(front.starts[start + soon / 2].vertex);
    for (const RingEntry& entry : ring.first(std::min(ring.size(), MostOfFlat + 1)))
    {
      prefetchToRead(&mesh.position(entry.neighbour()));
    }
    prefetchToRead(&mesh.rings().longestSides()[next.vertex]);
    if (const SurfacePoint& origin = front.labels[next.label].origin; origin.triangle != NoIndex)
    {
      prefetchToRead(&mesh.triangle(origin.triangle));
    }
  }
}

/** Calls visit(label, place, normals) for each label that starts on this piece, with the edge and
 * the cost there and the normals of findNormalsAt(), until goesOn() returns false. */
template <class Visit>
void visitPlaces(const TriangleMesh& mesh, const SeedFront& front, std::span<const double> cost,
  const Partition& partition, const std::function<bool()>& goesOn, const Visit& visit)
{
  const std::span<const float> sides =
    partition.isDivided() ? partition.longestSides() : mesh.rings().longestSides();
  std::vector<Vector3> normals;
  std::size_t visited = 0;
  for (auto start = front.starts.begin();
       start != front.starts.end() && (++visited % PlacesOfReport > 0 || goesOn());)
  {
    const Index label = start->label;
    LabelPlace place;
    prefetchLater(mesh, front, start - front.starts.begin());
    for (; start != front.starts.end() && start->label == label; ++start)
    {
      place.edge = std::max(place.edge, double{ sides[start->vertex] });
      place.cost = std::max(place.cost, cost.empty() ? 1.0 : cost[start->vertex]);
    }
    const Label& of = front.labels[label];
    normals.clear();
    if (of.shape == FrontShape::Round && of.origin.triangle != NoIndex)
    {
      findNormalsAt(mesh, of.origin, isShared(mesh, of.origin, partition), normals);
    }
    visit(label, place, normals);
  }
}

/** Puts together what all pieces know of the places. Collective. */
void gatherPlaces(const TriangleMesh& mesh, const SeedFront& front, std::span<const double> cost,
  const std::function<bool()>& goesOn, Partition& partition, std::vector<LabelPlace>& places)
{
  // For each label its number, edge, cost, the number of normals, and these.
  std::vector<double> own;
  constexpr std::size_t size = 4;
  own.reserve((size + 3) * front.labels.size());
  visitPlaces(mesh, front, cost, partition, goesOn,
    [&](Index label, const LabelPlace& place, const std::vector<Vector3>& normals)
    {
      own.insert(own.end(),
        { static_cast<double>(label), place.edge, place.cost,
          static_cast<double>(normals.size()) });
      for (const Vector3& normal : normals)
      {
        own.insert(own.end(), { normal.x, normal.y, normal.z });
      }
    });
  std::vector<std::pair<std::size_t, Vector3>> normalOfLabel;
  const std::vector<double> all = partition.gather(own);
  for (std::size_t i = 0; i < all.size();)
  {
    const auto label = static_cast<std::size_t>(all[i]);
    LabelPlace& place = places[label];
    place.edge = std::max(place.edge, all[i + 1]);
    place.cost = std::max(place.cost, all[i + 2]);
    const std::size_t last = i + size + 3 * static_cast<std::size_t>(all[i + 3]);
    for (i += size; i < last; i += 3)
    {
      normalOfLabel.emplace_back(label, Vector3{ all[i], all[i + 1], all[i + 2] });
    }
  }
  // Each piece has its labels in order.
  std::stable_sort(normalOfLabel.begin(), normalOfLabel.end(),
    [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Vector3> normals;
  for (std::size_t i = 0; i < normalOfLabel.size();)
  {
    const std::size_t label = normalOfLabel[i].first;
    for (normals.clear(); i < normalOfLabel.size() && normalOfLabel[i].first == label; ++i)
    {
      normals.push_back(normalOfLabel[i].second);
    }
    places[label].normal = roundedDirection(alignedSum(normals));
  }
}

}

std::vector<LabelPlace> labelPlaces(const TriangleMesh& mesh, const SeedFront& front,
  std::span<const double> cost, const std::function<bool()>& goesOn, Partition& partition)
{
  std::vector<LabelPlace> places(front.labels.size());
  if (partition.isDivided())
  {
    gatherPlaces(mesh, front, cost, goesOn, partition, places);
  }
  else
  {
    visitPlaces(mesh, front, cost, partition, goesOn,
      [&](Index label, const LabelPlace& place, const std::vector<Vector3>& normals)
      {
        places[label] = place;
        if (!normals.empty())
        {
          places[label].normal = roundedDirection(normals[0]);
        }
      });
  }
  for (std::size_t number = 0; number < places.size(); ++number)
  {
    LabelPlace& place = places[number];
    place.position = front.labels[number].position;
    place.value = place.cost > 0.0 ? front.labels[number].value / place.cost : 0.0;
  }
  return places;
}

}
