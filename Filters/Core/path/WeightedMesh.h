// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WeightedMesh_h
#define geodesic_WeightedMesh_h

#include "mesh/TriangleMesh.h"
#include "path/PathPoint.h"
#include "path/SearchProgress.h"
#include "solve/ClosedTriangles.h"
#include "solve/Detours.h"
#include "solve/SolveOptions.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace geodesic
{

/** A mesh with the costs and barriers that paths on it must respect, and the progress of the search
 * for them. */
class WeightedMesh
{
public:
  /** @param options those with which the field was solved; they, the mesh and the progress must
   * live as long as this object */
  WeightedMesh(const TriangleMesh& mesh, const SolveOptions& options, SearchProgress& progress)
    : Mesh(mesh)
    , Options(options)
    , Closed(mesh, options.closedTriangles)
    , Progress(progress)
  {
  }

  const TriangleMesh& mesh() const { return this->Mesh; }
  /** Takes over what the solver of the field knows, or else it is found when it is needed. @param
   * known  null if it is not known; else it must live as long as this, or until this is called
   * again */
  void useDetours(const Detours* known) { this->KnownDetours = known; }
  /** See SearchProgress::add(). */
  void countSteps(std::size_t steps) const { this->Progress.add(steps); }
  /** The ring of a vertex. @throws IncompleteRing if the mesh lacks triangles of the surface there
   */
  std::span<const RingEntry> ring(Index vertex) const
  {
    if (this->Options.isIncomplete(vertex))
    {
      throw IncompleteRing(vertex);
    }
    return this->Mesh.ring(vertex);
  }

  bool isExcluded(Index vertex) const { return this->Options.isExcluded(vertex); }
  /** Whether entry @p i of the ring of @p vertex opens a triangle that is no barrier. */
  bool isOpen(Index vertex, std::size_t i) const { return this->Closed.isOpen(vertex, i); }
  /** Whether a path may run along the edge to entry @p i of the ring of @p vertex. */
  bool isOpenEdge(Index vertex, std::size_t i) const { return this->Closed.isOpenEdge(vertex, i); }
  /** Whether a path may cross the triangle that entry @p i of the ring of @p vertex opens: it is
   * open and, as for a front, no corner is excluded. */
  bool isCrossable(Index vertex, std::size_t i) const
  {
    if (!this->isOpen(vertex, i))
    {
      return false;
    }
    const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
    return !this->isExcluded(vertex) && !this->isExcluded(ring[i].neighbour()) &&
      !this->isExcluded(ring[i + 1].neighbour());
  }

  /** Whether there are costs; without them the cost is 1. */
  bool hasCosts() const { return !this->Options.cost.empty(); }
  double costOf(Index vertex) const { return this->hasCosts() ? this->Options.cost[vertex] : 1.0; }
  /** The cost of a face: the mean of its corners' costs. */
  double costOf(const Triangle& face) const
  {
    return this->hasCosts()
      ? (this->costOf(face[0]) + this->costOf(face[1]) + this->costOf(face[2])) / 3.0
      : 1.0;
  }

  /** Whether fronts cross a face as straight ones, see Detours. @param cost of the face */
  bool isBypassed(double cost, const Triangle& face) const
  {
    return this->hasCosts() && this->detours().isBypassed(cost, face[0], face[1], face[2]);
  }

private:
  const Detours& detours() const
  {
    return this->KnownDetours ? *this->KnownDetours : this->foundDetours();
  }
  const Detours& foundDetours() const;

  const TriangleMesh& Mesh;
  const SolveOptions& Options;
  const Detours* KnownDetours = nullptr;
  /** Found when they were needed first. */
  mutable std::optional<Detours> FoundDetours;
  ClosedTriangles Closed;
  SearchProgress& Progress;
};

/** The carrier of a point round which the faces of the point are sought: the first one, or where
 * that has many faces, the one with the shortest ring. */
inline Index centreOf(const WeightedMesh& surface, const Carriers& carriers)
{
  constexpr std::size_t many = 64;
  const auto sizeOf = [&](Index carrier) { return surface.mesh().ring(carrier).size(); };
  return sizeOf(carriers[0]) <= many ? carriers[0]
                                     : *std::min_element(carriers.begin(), carriers.end(),
                                         [&](Index a, Index b) { return sizeOf(a) < sizeOf(b); });
}

/** Calls @p visit with the third corner of each open face on both sides of an edge. @param centre
 * one of its ends, the one whose ring is looked through */
template <class Visit>
inline void visitApexes(const WeightedMesh& surface, Index centre, Index other, const Visit& visit)
{
  const std::span<const RingEntry> ring = surface.ring(centre);
  surface.countSteps(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    if (ring[i].neighbour() != other)
    {
      continue;
    }
    if (i > 0 && surface.isOpen(centre, i - 1))
    {
      visit(ring[i - 1].neighbour());
    }
    // The last entry of a ring opens no triangle.
    if (surface.isOpen(centre, i))
    {
      visit(ring[i + 1].neighbour());
    }
  }
}

/** Calls @p visit with each open face in which the point lies. */
template <class Visit>
inline void visitFaces(const WeightedMesh& surface, const PathPoint& point, Visit&& visit)
{
  const Carriers carriers = point.carriers();
  const Index centre = centreOf(surface, carriers);
  if (carriers.size() == 2)
  {
    const Index other = carriers[carriers[0] == centre ? 1 : 0];
    visitApexes(surface, centre, other,
      [&](Index apex) {
        visit(Triangle{ centre, apex, other });
      });
    return;
  }
  const std::span<const RingEntry> ring = surface.ring(centre);
  surface.countSteps(ring.size());
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
  {
    const Triangle face{ centre, ring[i].neighbour(), ring[i + 1].neighbour() };
    if (surface.isOpen(centre, i) && liesIn(point, face))
    {
      visit(face);
    }
  }
}

/**
 * The cost of a path: the length of each segment times the cost of the face in which it lies, of
 * several the least. Without costs, the path's length.
 */
double costOf(const WeightedMesh& surface, const SurfacePath& path);

}

#endif
