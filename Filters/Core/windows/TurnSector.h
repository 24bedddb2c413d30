// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TurnSector_h
#define geodesic_TurnSector_h

#include "base/Index.h"

#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace geodesic
{

class EdgeTable;
class TriangleMesh;
struct Arrival;
struct LaidTriangle;
struct PlanePoint;

/**
 * Where paths can go on from a vertex at which they turn: no shortest path makes an angle of less
 * than a half turn on either side of the vertex. That is a sector of a full turn less than the
 * angles of the vertex' triangles, so most triangles have no part in it. Elsewhere other paths are
 * shorter, whichever of several shortest paths to the vertex is taken.
 * J. Mitchell, D. Mount, C. Papadimitriou, The discrete geodesic problem, SIAM J. Comput. 16
 * (1987).
 */
class TurnSector
{
public:
  /** What a triangle has of the sector: the directions from @p first to @p last, as angles from
   * the side to the vertex @p side on. Where @p side is none, it has all. */
  struct Part
  {
    Index triangle = NoIndex;
    Index side = NoIndex;
    double first = 0.0;
    double last = std::numbers::pi;

    /** How much of the edge opposite the vertex lies in these directions.
     * @param source  the vertex, in the plane of that edge's half-edge */
    struct Lit
    {
      double first;
      double last;
    };
    Lit litOf(const LaidTriangle& laid, const PlanePoint& source) const;
  };

  /**
   * Finds the sector of a vertex. Time O(k) with k triangles.
   * @param arrival   how a shortest path comes there
   * @param distance  its length, by which rounding is judged
   * @return false if paths may go anywhere: where not all triangles are one fan of edges of at most
   *         two, or where rounding hides the direction
   * @pre paths can cross all triangles of the vertex
   */
  bool find(const TriangleMesh& mesh, const EdgeTable& edges, Index vertex, const Arrival& arrival,
    double distance);

  /** The parts of the triangles that have any. */
  std::span<const Part> parts() const { return this->Parts; }

private:
  /** How goRound() ended. */
  enum class End
  {
    Border,
    FullTurn,
    /** At an edge of more than two triangles, or one without length. */
    Unknown
  };

  /**
   * Adds the triangles round a vertex, from one on in the direction away from one of its sides.
   * @param side   the vertex at the other end of that side
   * @param angle  between the arriving path and that side
   * @param end    the triangle behind the last one, should it come there
   */
  End goRound(const TriangleMesh& mesh, const EdgeTable& edges, Index vertex, Index triangle,
    Index side, double angle, Index end);
  /** Keeps of the parts from a number on what lies between two angles. */
  void cut(std::size_t begin, double first, double last);

  std::vector<Part> Parts;
  /** The angle to which goRound() came, and past how many triangles. */
  double Angle = 0.0;
  std::size_t Visited = 0;
};

}

#endif
