// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey/CentreSearch.h"

#include "base/Interruption.h"
#include "base/NumberText.h"
#include "mesh/TriangleMesh.h"
#include "solve/DistanceSolver.h"
#include "solve/Partition.h"
#include "survey/FarthestVertices.h"
#include "survey/OpenVertices.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>

namespace geodesic
{
namespace
{

/** The bounds of a vertex's eccentricity. */
struct Bounds
{
  double least = 0.0;
  double most = DistanceField::Unreached;
  /** Whether the vertex had a field of its own. */
  bool isMeasured = false;
};

/** Searches one part after the other. */
class Searcher
{
public:
  Searcher(DistanceSolver& solver, const CentreRequest& request)
    : Solver(solver)
    , Mesh(solver.mesh())
    , Request(request)
    , Eccentricities(this->Mesh.numberOfVertices())
  {
  }

  std::vector<PartExtent> search()
  {
    Partition onePiece;
    const std::vector<std::uint8_t> isOpen =
      openVertices(this->Mesh, this->Request.options, {}, onePiece);
    std::vector<Index> order;
    for (Index vertex = 0; vertex < isOpen.size(); ++vertex)
    {
      Interruption::checkAt(vertex);
      if (isOpen[vertex])
      {
        order.push_back(vertex);
      }
    }
    std::size_t compared = 0;
    std::sort(order.begin(), order.end(),
      [&](Index a, Index b)
      {
        Interruption::checkAt(compared++);
        return this->comesFirst(a, b);
      });
    std::vector<std::uint8_t> isKnown(isOpen.size(), 0);
    std::vector<PartExtent> parts;
    std::size_t done = 0;
    for (const Index first : order)
    {
      if (isKnown[first])
      {
        continue;
      }
      this->Done = static_cast<double>(done) / static_cast<double>(order.size());
      parts.push_back(this->searchPart(first));
      if (this->IsCancelled)
      {
        return {};
      }
      for (const Index vertex : this->Part)
      {
        isKnown[vertex] = 1;
      }
      isKnown[first] = 1;
      done += this->Part.size();
    }
    return parts;
  }

private:
  bool comesFirst(Index a, Index b) const
  {
    return isBefore(this->Mesh.position(a), this->Mesh.position(b)) ||
      (this->Mesh.position(a) == this->Mesh.position(b) && a < b);
  }

  PartExtent searchPart(Index first)
  {
    PartExtent extent;
    extent.radius = DistanceField::Unreached;
    this->Part.clear();
    Index farthest = this->measure(first, extent);
    extent.numberOfVertices = this->Part.size();
    while (!this->IsCancelled && extent.numberOfFields < this->Request.mostFields)
    {
      this->bound(extent);
      const bool isCentred = this->isNear(extent.leastRadius, extent.radius);
      const bool isSpanned = this->isNear(extent.diameter, extent.mostDiameter);
      if (isCentred && isSpanned)
      {
        break;
      }
      const std::size_t turn = extent.numberOfFields % 3;
      Index next = farthest;
      if (turn != 1 || this->Eccentricities[farthest].isMeasured)
      {
        next = isSpanned || (turn != 2 && !isCentred) ? this->LeastLower : this->MostUpper;
      }
      farthest = this->measure(next, extent);
    }
    this->bound(extent);
    return extent;
  }

  /** Whether two bounds are as near as asked for. */
  bool isNear(double less, double more) const
  {
    constexpr double rounding = 1e-12;
    return more - less <= (this->Request.error + rounding) * more;
  }

  /** Takes the field from a vertex, and what follows from it. Returns the vertex farthest from it.
   */
  Index measure(Index vertex, PartExtent& extent)
  {
    SolveOptions options = this->Request.options;
    options.keepsSurface = this->HasMarched;
    options.onProgress = [&](std::size_t) { return this->report(extent.numberOfFields); };
    const Seed seed = Seed::atPoint(this->Mesh.pointAtVertex(vertex));
    const DistanceField& field = this->Solver.solve({ &seed, 1 }, options);
    this->HasMarched = true;
    this->IsCancelled |= field.stopReason() == StopReason::Cancelled;
    ++extent.numberOfFields;
    if (this->Part.empty())
    {
      this->Part.assign(field.reached().begin(), field.reached().end());
    }
    Index farthest = vertex;
    for (const Index other : this->Part)
    {
      const double distance = field.distance(other);
      const double most = field.distance(farthest);
      if (distance > most || (distance == most && this->comesFirst(other, farthest)))
      {
        farthest = other;
      }
    }
    const double eccentricity = field.distance(farthest);
    for (const Index other : this->Part)
    {
      const double distance = field.distance(other);
      Bounds& bounds = this->Eccentricities[other];
      bounds.least = std::max({ bounds.least, distance, eccentricity - distance });
      bounds.most = std::min(bounds.most, eccentricity + distance);
    }
    this->Eccentricities[vertex] = { eccentricity, eccentricity, true };
    if (eccentricity < extent.radius)
    {
      extent.radius = eccentricity;
      extent.centre = vertex;
    }
    if (eccentricity >= extent.diameter)
    {
      extent.diameter = eccentricity;
      extent.ends[0] = vertex;
      extent.ends[1] = farthest;
    }
    return farthest;
  }

  /** Sets the bounds of the whole part, and the vertices that they come from. */
  void bound(PartExtent& extent)
  {
    this->LeastLower = this->MostUpper = this->Part.front();
    for (const Index vertex : this->Part)
    {
      const Bounds& own = this->Eccentricities[vertex];
      const double least = this->Eccentricities[this->LeastLower].least;
      const double most = this->Eccentricities[this->MostUpper].most;
      if (own.least < least || (own.least == least && this->comesFirst(vertex, this->LeastLower)))
      {
        this->LeastLower = vertex;
      }
      if (own.most > most || (own.most == most && this->comesFirst(vertex, this->MostUpper)))
      {
        this->MostUpper = vertex;
      }
    }
    extent.leastRadius = std::min(extent.radius, this->Eccentricities[this->LeastLower].least);
    extent.mostDiameter = std::max(extent.diameter, this->Eccentricities[this->MostUpper].most);
  }

  bool report(std::size_t fields)
  {
    const double ofPart =
      static_cast<double>(fields) / static_cast<double>(this->Request.mostFields);
    return !this->Request.onProgress || this->Request.onProgress(std::max(this->Done, ofPart));
  }

  DistanceSolver& Solver;
  const TriangleMesh& Mesh;
  const CentreRequest& Request;
  std::vector<Bounds> Eccentricities;
  std::vector<Index> Part;
  Index LeastLower = NoIndex;
  Index MostUpper = NoIndex;
  double Done = 0.0;
  bool HasMarched = false;
  bool IsCancelled = false;
};

}

std::vector<PartExtent> findCentres(DistanceSolver& solver, const CentreRequest& request)
{
  if (!(request.error >= 0.0))
  {
    throw std::invalid_argument(
      "The error of the search is " + textOf(request.error) + "; it must be at least 0.");
  }
  if (request.mostFields < 1)
  {
    throw std::invalid_argument("No field is allowed; allow 1 at least.");
  }
  return Searcher(solver, request).search();
}

}
