// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_StripFunnel_h
#define geodesic_StripFunnel_h

#include "base/PlanePoint.h"
#include "path/PathPoint.h"
#include "path/Strip.h"
#include "path/WeightedMesh.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace geodesic
{

/** A part of a path that is straight when the faces it crosses are laid flat. */
struct StraightPiece
{
  PathPoint start;
  PathPoint end;
  /** The faces that the piece crosses; none if it runs along one edge. */
  Strip strip;
  /** In mesh length units. */
  double length = 0.0;
  /** Where start and end lie in the plane of the strip, if it has two faces or more. */
  PlanePoint flatStart{};
  PlanePoint flatEnd{};
  /** The vertices between the ends of a row of edges, which the piece goes along instead of
   * straight through its strip. */
  std::vector<Index> through{};

  /** Where the piece enters a face of its strip, the second or a later one. */
  PathPoint crossing(const StripFace& face) const;
  /** The point of the path after start, and the one before end. */
  PathPoint second() const;
  PathPoint lastButOne() const;
};

/**
 * The shortest path between two points inside a strip of faces. Where a straight line leaves the
 * strip, the path bends at the vertex by which the line misses it most. Where that is not enough,
 * it is found by a funnel: D. T. Lee, F. P. Preparata, Euclidean shortest paths in the presence of
 * rectilinear barriers, Networks 14 (1984).
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
  /** The same, where a single piece takes over the strip, which may be long, instead of a copy.
   * @param strip  the one of the construction; neither it nor this is to be used then */
  std::vector<StraightPiece> takePieces(Strip&& strip) const;
  /** The faces along the straight line from start to end, see ChordWalk.h; nothing if the path is
   * that line, or there are no such faces. */
  std::optional<Strip> stripAlongChord() const;

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
  /** The entries of the faces @p first to @p last - 1, between two points in the plane. */
  struct Range
  {
    PlanePoint from;
    PlanePoint to;
    std::size_t first;
    std::size_t last;
  };
  /** Finds the bends within a range. @param looks  how many entries may still be looked at before a
   * funnel takes over */
  void findBends(const Range& range, std::size_t& looks);
  /** The same by a funnel. */
  void findBendsByFunnel(const Range& range);
  /** Calls @p visit with each part that has a length. */
  template <class Visit>
  void visitParts(const Visit& visit) const;
  double lengthOf(const Part& part) const;
  /** @param stripOf  gives the strip of a part that does not run along one edge */
  template <class StripOf>
  std::vector<StraightPiece> piecesWith(const StripOf& stripOf) const;

  const WeightedMesh& Surface;
  PathPoint Start;
  PathPoint End;
  PlanePoint FlatStart;
  PlanePoint FlatEnd;
  /** Without the faces at both ends in which the path has no length. */
  std::span<const StripFace> Faces;
  std::vector<Bend> Bends;
};

}

#endif
