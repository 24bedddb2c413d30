// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "global/GlobalPoints.h"

#include "base/Interruption.h"
#include "filter/VtkVersions.h"
#include "input/PointIdentity.h"
#include "mesh/Carriers.h"
#include "mesh/CurveOrder.h"
#include "mesh/TriangleMesh.h"
#include "pieces/SharedPoints.h"
#include "request/PointResolver.h"
#include "search/NearestOrder.h"
#include "search/PointSearch.h"
#include "solve/SeedFront.h"

#include "vtkIdList.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace geodesic::distributed
{
namespace
{

/** The nearest point of one rank's piece to a position. */
struct Projection
{
  /** Of the position, in the caller's list. */
  std::size_t number;
  Vector3 query;
  NearestOrder::Candidate nearest;
  SurfacePoint point;
};

/** Returns the projections of many positions in the order of orderAlongCurve(). */
std::vector<Projection> localProjections(const DistributedSurface& surface,
  std::span<const double> coordinates, const std::string& property, Precision precision,
  const ThreadTeam& team)
{
  const TriangleMesh& mesh = surface.mesh();
  const PointSearch& search = surface.piece().closestPoints();
  const std::vector<Vector3> positions = bridge::positionsAt(coordinates, property);
  constexpr std::size_t many = 256;
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), Index{ 0 });
  if (positions.size() >= many)
  {
    order = orderAlongCurve(positions);
  }
  const bool hasPoints = mesh.numberOfTriangles() > 0;
  if (hasPoints && team.numberOfRanges(positions.size()) > 1)
  {
    // Else the first thread that needs it makes it, while the others wait.
    search.tree();
  }
  std::vector<Projection> projections(positions.size());
  team.run(positions.size(),
    [&](std::size_t /*range*/, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        Interruption::checkAt(i);
        Projection& projection = projections[i];
        projection.number = order[i];
        projection.query = positions[order[i]];
        if (hasPoints)
        {
          const auto nearest = search.closestPoint(projection.query);
          projection.nearest.distance = nearest.distance;
          projection.point = precision == Precision::Single
            ? bridge::snappedAsSingle(mesh, nearest.point)
            : nearest.point;
          projection.nearest.position = mesh.positionOf(projection.point);
        }
      }
    });
  return projections;
}

/** Returns for each projection the rank whose point is the nearest. All ranks must have projected
 * the same positions, in the same order. Collective. */
std::vector<int> nearestRanks(RankGroup& ranks, const std::vector<Projection>& own)
{
  std::vector<double> flat;
  for (const Projection& p : own)
  {
    const auto& [distance, position] = p.nearest;
    flat.insert(flat.end(), { distance, position.x, position.y, position.z });
  }
  const std::vector<std::vector<double>> all = ranks.gatherByRank(flat);
  std::vector<int> nearest(own.size(), 0);
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    const NearestOrder order(own[i].query);
    const auto candidateOf = [&](int rank)
    {
      const double* p = all[rank].data() + 4 * i;
      return NearestOrder::Candidate{ p[0], { p[1], p[2], p[3] } };
    };
    for (int rank = 1; rank < ranks.size(); ++rank)
    {
      nearest[i] = order.isBefore(candidateOf(rank), candidateOf(nearest[i])) ? rank : nearest[i];
    }
  }
  return nearest;
}

/** A point and the vertices that carry it, in a row of numbers that ranks send each other. */
class CarriedPoint
{
public:
  static constexpr std::size_t Size = 14;
  using Row = std::array<double, Size>;

  static Row rowOf(std::size_t number, const Vector3& position, const TriangleMesh& mesh,
    const SharedPoints& shared, const SurfacePoint& point)
  {
    Row row{ static_cast<double>(number), position.x, position.y, position.z };
    for (int c = 0; c < 3; ++c)
    {
      const GlobalVertex carrier = shared.globalOf(mesh.triangle(point.triangle)[c]);
      double* entry = row.data() + 4 + 3 * c;
      entry[0] = carrier.rank;
      entry[1] = carrier.vertex;
      entry[2] = point.weights[c];
      row.back() = std::max(row.back(), mesh.longestEdgeAround(mesh.triangle(point.triangle)[c]));
    }
    return row;
  }

  explicit CarriedPoint(const double* row)
    : Values(row)
  {
  }

  std::size_t number() const { return static_cast<std::size_t>(this->Values[0]); }

  GlobalPoint point(const TriangleMesh& mesh, const SharedPoints& shared) const
  {
    GlobalPoint point{ { this->Values[1], this->Values[2], this->Values[3] },
      this->local(mesh, shared), {}, {}, 0.0 };
    this->carry(point);
    return point;
  }

  /** Sets the corners, the weights and the longest edge of a point. */
  void carry(GlobalPoint& point) const
  {
    for (int c = 0; c < 3; ++c)
    {
      const double* entry = this->Values + 4 + 3 * c;
      point.corners[c] = { static_cast<int>(entry[0]), static_cast<Index>(entry[1]) };
      point.weights[c] = entry[2];
    }
    point.longestEdge = this->Values[Size - 1];
  }

private:
  /** The point on this rank's piece; empty if no triangle of the piece has all carriers. */
  std::vector<SurfacePoint> local(const TriangleMesh& mesh, const SharedPoints& shared) const
  {
    Carriers carriers;
    std::array<double, 3> weights{};
    for (int c = 0; c < 3; ++c)
    {
      const double* entry = this->Values + 4 + 3 * c;
      if (entry[2] > 0.0)
      {
        weights[static_cast<std::size_t>(carriers.size())] = entry[2];
        carriers.addNew(shared.find({ static_cast<int>(entry[0]), static_cast<Index>(entry[1]) }));
      }
    }
    if (carriers.contains(NoIndex))
    {
      return {};
    }
    const Index triangle = mesh.firstTriangleWith({ carriers.begin(), carriers.end() });
    if (triangle == NoIndex)
    {
      return {};
    }
    SurfacePoint point{ triangle, { 0.0, 0.0, 0.0 } };
    const Triangle& corners = mesh.triangle(triangle);
    for (int i = 0; i < carriers.size(); ++i)
    {
      point.weights[std::find(corners.begin(), corners.end(), carriers[i]) - corners.begin()] =
        weights[static_cast<std::size_t>(i)];
    }
    return { point };
  }

  const double* Values;
};

/** Returns the points that any rank sends, in the order of their numbers. Collective. */
std::vector<GlobalPoint> shareRows(RankGroup& ranks, const DistributedSurface& surface,
  const std::vector<double>& ownRows, std::size_t count, std::vector<bool>& isKnown)
{
  std::vector<GlobalPoint> points(count);
  isKnown.assign(count, false);
  const std::vector<double> rows = ranks.gather(ownRows);
  for (std::size_t i = 0; i < rows.size(); i += CarriedPoint::Size)
  {
    Interruption::checkAt(i / CarriedPoint::Size);
    const CarriedPoint carried(rows.data() + i);
    points[carried.number()] = carried.point(surface.mesh(), surface.shared());
    isKnown[carried.number()] = true;
  }
  return points;
}

void appendRow(std::vector<double>& rows, const CarriedPoint::Row& row)
{
  rows.insert(rows.end(), row.begin(), row.end());
}

/** Returns for each id the vertex that has it and that this rank owns, or NoIndex. */
std::vector<Index> ownedVerticesWith(
  const DistributedSurface& surface, vtkIdList* ids, const std::vector<vtkIdType>& globalIds)
{
  std::vector<Index> vertices(ids->GetNumberOfIds(), NoIndex);
  std::unordered_multimap<vtkIdType, std::size_t> wanted;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    wanted.emplace(ids->GetId(i), i);
  }
  for (Index point = 0; point < globalIds.size(); ++point)
  {
    const Index vertex = surface.mesh().vertexOfPoint(point);
    const auto [first, last] = wanted.equal_range(globalIds[point]);
    for (auto found = first; found != last; ++found)
    {
      if (vertex != NoIndex && surface.shared().owns(vertex))
      {
        vertices[found->second] = vertex;
      }
    }
  }
  return vertices;
}

}

std::vector<GlobalPoint> globalPointsAt(RankGroup& ranks, const DistributedSurface& surface,
  std::span<const double> coordinates, const std::string& property, Precision precision,
  const ThreadTeam& team)
{
  std::vector<Projection> own;
  ranks.together([&] { own = localProjections(surface, coordinates, property, precision, team); });
  if (own.empty())
  {
    return {};
  }
  const std::vector<int> nearest = nearestRanks(ranks, own);
  std::vector<double> rows;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    if (nearest[i] == ranks.rank())
    {
      appendRow(rows,
        CarriedPoint::rowOf(
          own[i].number, own[i].nearest.position, surface.mesh(), surface.shared(), own[i].point));
    }
  }
  std::vector<bool> isKnown;
  return shareRows(ranks, surface, rows, own.size(), isKnown);
}

void restate(RankGroup& ranks, const DividedMesh& mesh, std::vector<GlobalPoint>& points)
{
  std::vector<double> own;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (const SurfacePoint& local : points[i].local)
    {
      appendRow(own, CarriedPoint::rowOf(i, points[i].position, mesh.mesh(), mesh.shared(), local));
    }
  }
  // The rows come by increasing rank. They are read from the end, so that the lowest rank that has
  // a point decides.
  const std::vector<double> rows = ranks.gather(own);
  for (std::size_t i = rows.size(); i > 0; i -= CarriedPoint::Size)
  {
    const CarriedPoint carried(rows.data() + i - CarriedPoint::Size);
    carried.carry(points[carried.number()]);
  }
}

std::vector<double> pointsOfAll(RankGroup& ranks, const std::vector<double>& own)
{
  std::vector<double> points;
  std::set<std::array<double, 3>> ofLowerRanks;
  for (const std::vector<double>& ofRank : ranks.gatherByRank(own))
  {
    std::set<std::array<double, 3>> ofThis;
    for (std::size_t i = 0; i < ofRank.size(); i += 3)
    {
      const std::array point{ ofRank[i], ofRank[i + 1], ofRank[i + 2] };
      if (!ofLowerRanks.contains(point))
      {
        points.insert(points.end(), point.begin(), point.end());
        ofThis.insert(point);
      }
    }
    ofLowerRanks.merge(ofThis);
  }
  return points;
}

std::vector<GlobalPoint> globalPointsOf(RankGroup& ranks, const DistributedSurface& surface,
  vtkDataObject* source, const std::string& property)
{
  std::vector<double> own;
  ranks.together(
    [&]
    {
      if (source)
      {
        own = bridge::PointSource(source).coordinates;
      }
    });
  return globalPointsAt(ranks, surface, pointsOfAll(ranks, own), property, Precision::Single);
}

std::vector<GlobalPoint> globalPointsWith(RankGroup& ranks, const DistributedSurface& surface,
  const bridge::InputBlocks& blocks, vtkIdList* ids, const std::string& role)
{
  if (ids->GetNumberOfIds() == 0)
  {
    return {};
  }
  const TriangleMesh& mesh = surface.mesh();
  std::vector<Index> vertices;
  ranks.together(
    [&]
    {
      if (ranks.size() == 1)
      {
        vertices = bridge::verticesWithIds(surface.piece(), ids, role);
        return;
      }
      if (!blocks.haveGlobalPointIds())
      {
        throw std::invalid_argument(role +
          " point ids are global ids on several ranks, and the "
          "input has none. Make them " +
          bridge::MakeGlobalIds + ".");
      }
      vertices = ownedVerticesWith(surface, ids, bridge::globalPointIdsOf(blocks));
    });
  std::vector<double> rows;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    if (vertices[i] != NoIndex)
    {
      appendRow(rows,
        CarriedPoint::rowOf(
          i, mesh.position(vertices[i]), mesh, surface.shared(), mesh.pointAtVertex(vertices[i])));
    }
  }
  std::vector<bool> isKnown;
  std::vector<GlobalPoint> points = shareRows(ranks, surface, rows, vertices.size(), isKnown);
  const auto missing = std::find(isKnown.begin(), isKnown.end(), false);
  if (missing != isKnown.end())
  {
    throw std::invalid_argument(role + " point id " +
      std::to_string(ids->GetId(missing - isKnown.begin())) +
      " does not exist: on no rank does a point of the surface have this global id. Choose "
      "another.");
  }
  return points;
}

Triangle targetAt(const TriangleMesh& mesh, const std::vector<SurfacePoint>& local)
{
  return local.empty() ? Triangle{ NoIndex, NoIndex, NoIndex } : bridge::targetAt(mesh, local[0]);
}

}
