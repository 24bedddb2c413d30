// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BvhBounds_h
#define geodesic_BvhBounds_h

#include "base/Vector3.h"

#include <array>
#include <cstddef>
#include <span>

namespace geodesic
{

/**
 * Bounds a run of triangles by a box with the axes' directions, and by a flat cylinder round the
 * box's centre whose axis is the mean of the run's normals. A smooth surface fills the cylinder far
 * better: its height falls with the square of the run's size. Numbers are rounded outwards.
 */
struct BvhBounds
{
  /** @param corners three a triangle, of at least one triangle */
  static BvhBounds ofTriangles(std::span<const Vector3> corners);
  /** Bounds all that at least one other bounds bound. Looser than of the same triangles. */
  static BvhBounds ofRuns(std::span<const BvhBounds> runs);

  Vector3 centre() const;
  Vector3 axis() const { return { this->axisParts[0], this->axisParts[1], this->axisParts[2] }; }

  std::array<float, 3> low;
  std::array<float, 3> high;
  /** Not longer than 1; 0 where normals cancel, and then the cylinder is a ball. */
  std::array<float, 3> axisParts;
  /** From the centre, in the direction of the axis. */
  float alongLow;
  float alongHigh;
  float radius;
};

/** The bounds of four runs, side by side so that the processor takes several at a time. */
class FourBvhBounds
{
public:
  static constexpr std::size_t Runs = 4;

  void set(std::size_t run, const BvhBounds& bounds);

  /** Squares of distances from a query to each run. */
  struct SquaredDistances
  {
    /** No point of the run is nearer. */
    std::array<double, Runs> least;
    std::array<double, Runs> toCentre;
  };
  SquaredDistances squaredDistances(const Vector3& query) const;

  std::array<double, 3> low(std::size_t run) const;
  std::array<double, 3> high(std::size_t run) const;

private:
  using Numbers = std::array<float, Runs>;

  /** Of as many runs as a Real has numbers, from @p first on. */
  template <class Real>
  void squaredDistances(const Vector3& query, std::size_t first, SquaredDistances& result) const;

  std::array<Numbers, 3> Low{};
  std::array<Numbers, 3> High{};
  std::array<Numbers, 3> Axis{};
  Numbers AlongLow{};
  Numbers AlongHigh{};
  Numbers Radius{};
};

}

#endif
