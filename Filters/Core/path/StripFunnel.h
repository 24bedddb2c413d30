// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_StripFunnel_h
#define geodesic_StripFunnel_h

#include "base/PlanePoint.h"
#include "path/PathPoint.h"
#include "path/Strip.h"
#include "path/WeightedMesh.h"

#include <cstddef>
#include <span>
#include <vector>

namespace geodesic
{

/** A part of a path that is straight when the faces it crosses are laid flat. */
struct StraightPiece
{
  PathPoint start;
  PathPoint end;
  /** The faces that the piece crosses, with the crossings; none if it runs along one edge. */
  Strip strip;
  /** In mesh length units. */
  double length = 0.0;

  /** The point of the path after start, and the one before end. */
  PathPoint second() const
  {
    return this->strip.size() < 2 ? this->end : this->strip[1].crossingPoint();
  }
  PathPoint lastButOne() const
  {
    return this->strip.size() < 2 ? this->start : this->strip.back().crossingPoint();
  }
};

/** The edge by which a face of a strip is entered, laid flat. */
struct Portal
{
  PlanePoint left;
  PlanePoint right;
};

/**
 * The shortest path between two points inside a strip of faces. The strip is laid flat and searched
 * by a funnel: D. T. Lee, F. P. Preparata, Euclidean shortest paths in the presence of rectilinear
 * barriers, Networks 14 (1984).
 */
class StripFunnel
{
public:
  /**
   * @param strip at least one face; the first contains @p start, the last @p end. It must live as
   *              long as this, as must the surface
   * @throws SearchCancelled
   * Time O(number of faces).
   */
  StripFunnel(
    const WeightedMesh& surface, const PathPoint& start, const PathPoint& end, const Strip& strip);

  /** The length of the path: the sum of those of its pieces. */
  double length() const;
  /** The straight pieces of the path, which join at vertices of the strip. No piece begins and ends
   * at the same vertex; there is none if start and end are the same vertex. */
  std::vector<StraightPiece> pieces() const;

private:
  /** A vertex at which the path bends. */
  struct Bend
  {
    Index vertex;
    PlanePoint flat;
    /** The first face whose entry has this vertex as an end. */
    std::size_t face;
  };
  /** A part of the path between bends. */
  struct Part
  {
    PathPoint from;
    PathPoint to;
    PlanePoint flatFrom;
    PlanePoint flatTo;
    std::span<const StripFace> strip;
  };
  class Funnel;

  /** Finds the bends. */
  void findBends();
  /** Calls @p visit with each part that has a length. */
  template <class Visit>
  void visitParts(const Visit& visit) const;
  double lengthOf(const Part& part) const;

  const WeightedMesh& Surface;
  PathPoint Start;
  PathPoint End;
  PlanePoint FlatStart;
  PlanePoint FlatEnd;
  /** Without the faces at both ends in which the path has no length. */
  std::span<const StripFace> Faces;
  /** Those by which the second and all later faces are entered. */
  std::vector<Portal> Portals;
  std::vector<Bend> Bends;
};

}

#endif
