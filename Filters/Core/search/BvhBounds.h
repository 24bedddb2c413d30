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
 * Bounds a run of consecutive triangles by an axis-aligned box, and by a flat cylinder round the
 * box's centre whose axis is the mean of the run's normals. A smooth surface fills the cylinder far
 * better: its height falls with the square of the run's size. Numbers are rounded outwards.
 */
struct BvhBounds
{
  /** @param corners three for each triangle; at least one triangle */
  static BvhBounds ofTriangles(std::span<const Vector3> corners);
  /**
   * Bounds everything in the given bounds, of which there is at least one. The result is looser
   * than that of ofTriangles() for the same triangles.
   */
  static BvhBounds ofRuns(std::span<const BvhBounds> runs);

  Vector3 centre() const;
  Vector3 axis() const { return { this->axisParts[0], this->axisParts[1], this->axisParts[2] }; }

  std::array<float, 3> low;
  std::array<float, 3> high;
  /** The cylinder's axis, not longer than 1; 0 where normals cancel: the cylinder is then a ball.
   */
  std::array<float, 3> axisParts;
  /** The cylinder's ends, measured from the centre along the axis. */
  float alongLow;
  float alongHigh;
  float radius;
};

/** The bounds of four runs, stored side by side for vector instructions. */
class FourBvhBounds
{
public:
  static constexpr std::size_t Runs = 4;

  void set(std::size_t run, const BvhBounds& bounds);

  /** Squared distances from a query to each run. */
  struct SquaredDistances
  {
    /** A lower bound of the squared distance to any point of the run. */
    std::array<double, Runs> least;
    /** To the centre of the run's box. */
    std::array<double, Runs> toCentre;
  };
  SquaredDistances squaredDistances(const Vector3& query) const;

  std::array<double, 3> low(std::size_t run) const;
  std::array<double, 3> high(std::size_t run) const;

private:
  using Numbers = std::array<float, Runs>;

  /** Writes the distances of as many runs as a Real has lanes, from run @p first on. */
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
