// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceField_h
#define geodesic_FaceField_h

#include "base/PlanePoint.h"

#include <array>
#include <vector>

namespace geodesic
{

/**
 * A distance field inside a face, from its values at the corners: the distance from a source in the
 * face's plane, inside or outside of the face, or a straight front. Of the sources that have the
 * right distances from two corners it is the one whose distance from the third corner differs
 * least; the front is straight if the slope of the values differs even less from 1. Where neither
 * fits, as under costs, the field is taken as straight, which is linear interpolation.
 */
class FaceField
{
public:
  /** @param corners  in counterclockwise order
   * @param values   at least 0 */
  FaceField(const std::array<PlanePoint, 3>& corners, const std::array<double, 3>& values);

  /** By how much the value of a corner differs from the model. */
  double roundError() const { return this->RoundError; }
  double straightError() const { return this->StraightError; }

  bool isRound() const { return this->RoundError <= this->StraightError; }
  /** Whether the source lies in the face, so that the face has a seed. */
  bool hasSource() const { return this->HasSource; }
  const PlanePoint& source() const { return this->Source; }
  double area() const { return this->Area; }

  /** A part of a level through the face. */
  struct Arc
  {
    /** From one end to the other. */
    std::vector<PlanePoint> points;
    double length;
    /** The area between the arc and the straight line between its ends. */
    double segment;
  };
  /** The arc between two points of the border at which the field has one value. What is nearer is
   * on its left. */
  Arc arc(const PlanePoint& from, const PlanePoint& to) const;
  /** The circle of a radius round the source. */
  Arc circle(double radius) const;

private:
  void findSource(const std::array<double, 3>& values);
  /** How far inside the face a point is; negative outside. */
  double depth(const PlanePoint& point) const;
  Arc arcOver(const PlanePoint& from, const PlanePoint& to, double angle) const;

  std::array<PlanePoint, 3> Corners;
  PlanePoint Source{};
  double Area;
  double Size;
  double RoundError;
  double StraightError;
  bool HasSource = false;
};

/**
 * Where the values along an edge are a level: fractions of the way from its first end, in
 * increasing order. There is one if the ends are on different sides of the level, none or two if
 * both are above it, none if both are below.
 * @param first,second values at the ends; at least 0 if @p isRound
 * @param isRound      whether the values are distances from a point; else they are linear
 */
std::vector<double> placesOnEdge(
  double first, double second, double length, bool isRound, double level);

}

#endif
