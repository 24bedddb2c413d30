// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FarthestVertices_h
#define geodesic_FarthestVertices_h

#include "base/Index.h"
#include "base/Vector3.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

class TriangleMesh;

/** Whether one position comes before another: by x, then by y, then by z. */
bool isBefore(const Vector3& a, const Vector3& b);

/**
 * The vertices of the largest distance, while distances fall.
 *
 * Vertices that are about as far as the farthest one, from a *level* on, are tied: of these the
 * first by position comes first, whatever rounding has made of their distances.
 *
 * A heap holds the vertices beyond a floor with the distances that they had when they were put
 * there; one that fell is put in again where it comes up. Below the floor nothing is kept: where
 * the heap is empty, all distances are looked through, and the floor falls by a tenth at least.
 * Time O(log n) for each vertex that comes up, and O(n) for each floor.
 */
class FarthestVertices
{
public:
  /** Distances that differ by less, in parts of the larger one, are equal: fields of different
   * orders and pieces agree to 5e-11. */
  static constexpr double TiePart = 1e-9;

  /**
   * @param distances  of all vertices; may fall between calls, and must never rise
   * @param isOpen     one flag for each vertex: zero where it never counts
   */
  FarthestVertices(const TriangleMesh& mesh, std::span<const double> distances,
    std::span<const std::uint8_t> isOpen);

  /** The largest distance; 0 where there is none above. */
  double farthest();
  /** Takes the vertices at @p level or farther as tied. @pre no vertex of the last level is left */
  void setLevel(double level);
  /** The first by position of the tied vertices that are still at the level; NoIndex if there is
   * none. */
  Index firstAtLevel();
  /**
   * Far vertices of which none will probably be nearer to another one: each is farther from those
   * before it than its own distance, in straight lines. Tied ones come in their order.
   * @param first  the first of them, with a finite distance
   * @param most   how many, with the first one, at least 1
   * @param cost   of each vertex; empty for 1
   */
  std::vector<Index> apartFrom(
    Index first, std::size_t most, std::span<const double> cost = {}) const;

private:
  struct Waiting
  {
    double distance;
    Index vertex;
    bool operator<(const Waiting& other) const { return this->distance < other.distance; }
  };
  struct Tied
  {
    Vector3 position;
    Index vertex;
    /** The largest comes first. */
    bool operator<(const Tied& other) const
    {
      return isBefore(other.position, this->position) ||
        (this->position == other.position && other.vertex < this->vertex);
    }
  };

  /** Lowers the floor and fills the heap again. @return false if no distance is above 0 */
  bool lowerFloor();
  /** Some of the farthest vertices, the farthest first; those that are tied by position. */
  std::vector<Index> farthestOnes(std::size_t most) const;
  void wait(Index vertex);
  void tie(Index vertex);
  Waiting takeFarthest();
  bool isAtLevel(const Tied& tied) const { return this->Distances[tied.vertex] >= this->Level; }
  /** Sorts the tied vertices that are still at the level, the first one last. */
  void sortTied();

  const TriangleMesh& Mesh;
  std::span<const double> Distances;
  std::span<const std::uint8_t> IsOpen;
  double Floor;
  double Level;
  std::vector<Waiting> Heap;
  std::vector<Tied> AtLevel;
  /** How often a first one was looked for at this level. Often one is all, so that sorting pays
   * from the second time on only. */
  std::size_t Looks = 0;
};

}

#endif
