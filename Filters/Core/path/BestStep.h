// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BestStep_h
#define geodesic_BestStep_h

#include "base/Index.h"
#include "base/Vector3.h"
#include "path/PathPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace geodesic
{

/** The next point of a path, and the distance to the seed through it. */
struct PathStep
{
  PathPoint point;
  /** Distance from the point to the seed. */
  double left;
  /** The same from where the step begins. */
  double total;
};

/** What a step needs of a vertex to which it may lead. */
struct StepCorner
{
  Index vertex;
  /** The seed to which the path may go on from the vertex; NoIndex if it may not go there. */
  Index seed;
  /** Distance from the vertex to the seed. */
  double left;
  const Vector3* position;
};

/** A place q on an edge's line, phi(q), and phi(q) + |p q|. */
struct LeastOnEdge
{
  double place;
  double left;
  double total;
};

/** Where the total is least if phi is linear, without regard to the edge's ends.
 * @param first  phi at the first end
 * @param slope  of phi, between -1 and 1
 * @param foot, height  of p: its place and its distance on the edge's line */
inline LeastOnEdge leastOfStraight(double first, double slope, double foot, double height)
{
  const double cosine = std::sqrt((1.0 - slope) * (1.0 + slope));
  const double place = foot - height * slope / cosine;
  return { place, first + slope * place, first + slope * foot + cosine * height };
}

/** The flat source of phi on an edge, of the length c: at (x, -depth) from the edge's first end if
 * it is beside the edge's line, otherwise on that line, at x - depth or x + depth. */
class FlatSource
{
public:
  /** @param a, b  phi at the ends, less than @p c apart
   * @param inverse  1 / c */
  FlatSource(double a, double b, double c, double inverse)
    : X(0.5 * (c + (a - b) * (a + b) * inverse))
    , Depth(
        0.5 * inverse * std::sqrt((a + b + c) * std::abs(a + b - c) * (c + a - b) * (c - a + b)))
    , IsBeside(a + b - c > 0.0)
  {
  }

  /** The place at which the total is least, without regard to the ends.
   * @param foot, height  of p: its place and its distance on the edge's line */
  LeastOnEdge least(double foot, double height) const
  {
    if (this->IsBeside)
    {
      // The straight line from p to the source.
      const double away = foot - this->X;
      const double across = height + this->Depth;
      const double part = 1.0 / across;
      const double total = std::sqrt(away * away + across * across);
      return { (this->X * height + foot * this->Depth) * part, total * this->Depth * part, total };
    }
    const double place = std::clamp(foot, this->X - this->Depth, this->X + this->Depth);
    const double away = place - this->X;
    const double left = std::sqrt(std::max(0.0, (away - this->Depth) * (away + this->Depth)));
    return { place, left, left + std::sqrt((foot - place) * (foot - place) + height * height) };
  }

private:
  double X;
  double Depth;
  bool IsBeside;
};

/** What a step needs of the face that it crosses. */
struct StepFace
{
  double cost;
  /** Whether phi is linear on its edges, as fronts cross it as straight ones (see Detours), or that
   * of a flat source. */
  bool isStraight;
};

/** Of the steps from a position that are tried, the one with the least total. */
class BestStep
{
public:
  explicit BestStep(const Vector3& from)
    : From(from)
  {
  }

  /**
   * Tries the step to the best point inside an edge.
   * @return whether there is such a point: steps to the edge's ends have no lower total then
   */
  bool tryEdge(const StepCorner& a, const StepCorner& b, const StepFace& face)
  {
    if (a.seed == NoIndex || a.seed != b.seed)
    {
      return false;
    }
    const double fromA = a.left / face.cost;
    const double fromB = b.left / face.cost;
    const Vector3 edge = *b.position - *a.position;
    const double square = dot(edge, edge);
    if (!((fromA - fromB) * (fromA - fromB) < square))
    {
      return false;
    }
    const double length = std::sqrt(square);
    const double inverse = 1.0 / length;
    const Vector3 toPoint = this->From - *a.position;
    const double foot = dot(toPoint, edge) * inverse;
    const double height = norm(cross(toPoint, edge)) * inverse;
    const LeastOnEdge least = face.isStraight
      ? leastOfStraight(fromA, (fromB - fromA) * inverse, foot, height)
      : FlatSource(fromA, fromB, length, inverse).least(foot, height);
    const double fraction = least.place * inverse;
    if (!(fraction > VertexFraction && fraction < 1.0 - VertexFraction))
    {
      return false;
    }
    this->take({ a.vertex, b.vertex, fraction, face.cost * least.left, face.cost * least.total });
    return true;
  }

  /** Tries the step to a vertex. */
  void tryVertex(const StepCorner& corner, double cost)
  {
    if (corner.seed != NoIndex && corner.left < this->Found.total)
    {
      const double length = norm(this->From - *corner.position);
      this->take({ corner.vertex, NoIndex, 0.0, corner.left, corner.left + cost * length });
    }
  }

  bool hasStep() const { return this->Found.a != NoIndex; }
  /** Both infinite if there is no step. */
  double left() const { return this->Found.left; }
  double total() const { return this->Found.total; }
  std::optional<PathStep> step() const
  {
    if (!this->hasStep())
    {
      return std::nullopt;
    }
    const auto& [a, b, fraction, left, total] = this->Found;
    return PathStep{ b == NoIndex ? PathPoint::atVertex(a) : PathPoint::onEdge(a, b, fraction),
      left, total };
  }

private:
  /** A point of an edge counts as the edge's end if it is nearer to it than this fraction. */
  static constexpr double VertexFraction = 1e-9;

  /** A step to a point of the edge from a to b, or to the vertex a. */
  struct Candidate
  {
    Index a = NoIndex;
    Index b = NoIndex;
    double fraction = 0.0;
    double left = std::numeric_limits<double>::infinity();
    double total = std::numeric_limits<double>::infinity();
  };
  void take(const Candidate& candidate)
  {
    if (candidate.total < this->Found.total)
    {
      this->Found = candidate;
    }
  }

  Vector3 From;
  Candidate Found;
};

}

#endif
