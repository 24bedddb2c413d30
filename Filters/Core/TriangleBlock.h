#ifndef geodesic_TriangleBlock_h
#define geodesic_TriangleBlock_h

#include "Index.h"
#include "Vector3.h"
#include "VertexRings.h"

#include <array>
#include <span>

namespace geodesic
{

/**
 * The sizes of a few triangles, number by number instead of triangle by triangle: so the compiler
 * lets the processor take several triangles at a time.
 */
class TriangleBlock
{
public:
  static constexpr std::size_t Size = 64;

  /** @param triangles at most Size of them */
  TriangleBlock(std::span<const Triangle> triangles, std::span<const Vector3> positions);

  /** @param measures one a triangle */
  void measure(std::span<TriangleMeasure> measures) const;
  /** Over all sides of all triangles. */
  double sumOfLengths() const;
  double longestSide() const;

private:
  using Numbers = std::array<double, Size>;

  std::size_t Triangles;
  /** Lengths of the sides opposite to the corners. */
  std::array<Numbers, 3> Sides;
  Numbers LongestSides;
  Numbers DoubleAreas;
};

}

#endif
