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
 * face's plane, inside or outside of the face, or a straight front, times the face's cost, which is
 * the mean of its corners' costs. So the march sees it. Of the sources that have the right
 * distances from two corners it is the one whose distance from the third corner differs least; the
 * front is straight if the slope of the values differs even less from the cost, also with a corner
 * on the other side of a line of seeds through the face.
 *
 * A seed in a face of varying cost is another case: the march begins with length times the mean of
 * the costs at both ends (solve/CostedStart.h). Where the values are those of such a seed, the
 * field is this product, with the cost linear in the face. Lengths and errors are in the face's
 * plane.
 */
class FaceField
{
public:
  /** @param corners  in counterclockwise order
   * @param values   at least 0
   * @param costs    of the corners, above 0 */
  FaceField(const std::array<PlanePoint, 3>& corners, const std::array<double, 3>& values,
    const std::array<double, 3>& costs = { 1.0, 1.0, 1.0 });

  /** By how much the value of a corner differs from the model, as a length. */
  double roundError() const { return this->RoundError; }
  double straightError() const { return this->StraightError; }

  bool isRound() const { return this->RoundError <= this->StraightError; }
  /** Whether the source lies inside of the face, so that the face has a seed. */
  bool hasSource() const { return this->HasSource; }
  /** Whether the source is a seed in the face or on its border, and the cost varies in the face. */
  bool isSeedOfVaryingCost() const { return this->IsSeedOfVaryingCost; }
  /** Whether a straight line of seeds crosses the face and the side opposite to a corner. */
  bool hasLineAcross(int corner) const
  {
    return !this->isRound() && this->CornerBeyondLine >= 0 && this->CornerBeyondLine != corner;
  }
  const PlanePoint& source() const { return this->Source; }
  double costAtSource() const { return this->CostAtSource; }
  double cost() const { return this->Cost; }
  double area() const { return this->Area; }
  /** Whether the front leaves the face over the side opposite to a corner. */
  bool flowsOut(int corner) const;

  /** A part of a level through the face. */
  struct Arc
  {
    /** From one end to the other. */
    std::vector<PlanePoint> points;
    double length;
    /** The area between the arc and the straight line between its ends. */
    double segment;
  };
  /** The arc between two points of the border at which the field has a level. What is nearer is on
   * its left. */
  Arc arc(const PlanePoint& from, const PlanePoint& to, double level) const;
  /** The closed curve of a level round the source. */
  Arc circle(double level) const;
  /** The distance from the source to where the field has a level, in the direction of a unit
   * vector. */
  double radius(double level, const PlanePoint& direction) const;

private:
  void findLine(const std::array<double, 3>& lengths);
  void findSource(const std::array<double, 3>& lengths);
  void findSeed(const std::array<double, 3>& values, const std::array<double, 3>& costs);
  bool approachSeed(PlanePoint& seed, const std::array<double, 3>& values,
    const std::array<double, 3>& costs) const;
  double costAt(const PlanePoint& point) const;
  /** How far inside the face a point is; negative outside. */
  double depth(const PlanePoint& point) const;
  Arc arcOver(const PlanePoint& from, const PlanePoint& to, double angle, double level) const;

  std::array<PlanePoint, 3> Corners;
  PlanePoint Source{};
  /** Of the values and of the cost, both linear in the face. */
  PlanePoint Slope{};
  PlanePoint CostSlope{};
  double Cost;
  double CostAtSource;
  double Area;
  double Size;
  double RoundError;
  double StraightError;
  /** The one that a line of seeds has alone on one side; -1 if none. */
  int CornerBeyondLine = -1;
  bool HasSource = false;
  bool IsSeedOfVaryingCost = false;
};

}

#endif
