// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The functions of IntrinsicTriangles that add vertices.

#include "base/Interruption.h"
#include "mesh/IntrinsicTriangles.h"
#include "mesh/TriangleMesh.h"
#include "mesh/TriangleShape.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace geodesic
{

double IntrinsicTriangles::mostLength() const
{
  constexpr double inMeanEdges = 1.3;
  constexpr double inSpacings = 2.0;
  double area = 0.0;
  for (HalfEdge h = 0; h < this->Lengths.size(); h += 3)
  {
    area += 0.25 * fourAreas(this->Lengths[h], this->Lengths[h + 1], this->Lengths[h + 2]);
  }
  const double spacing = std::sqrt(area / static_cast<double>(this->Mesh.numberOfVertices()));
  return std::max(inMeanEdges * this->Mesh.meanLongestEdge(), inSpacings * spacing);
}

bool IntrinsicTriangles::refine()
{
  this->MostLength = this->mostLength();
  std::vector<Index> triangles(this->Corners.size());
  std::iota(triangles.begin(), triangles.end(), 0);
  const std::size_t mostVertices = 2 * std::size_t{ this->Mesh.numberOfVertices() };
  const std::size_t mostSteps = MostStepsOfTriangle / 4 * triangles.size();
  // Round by round, so that triangles become smaller everywhere alike.
  while (!triangles.empty())
  {
    this->Touched.clear();
    for (const Index triangle : triangles)
    {
      Interruption::checkAt(triangle);
      const HalfEdge side = this->sideToHalve(triangle);
      if (side == NoIndex)
      {
        continue;
      }
      if (this->numberOfVertices() >= mostVertices || this->Steps.size() >= mostSteps)
      {
        return false;
      }
      this->halve(side);
      this->flipWaiting();
    }
    std::swap(triangles, this->Touched);
  }
  return true;
}

IntrinsicTriangles::HalfEdge IntrinsicTriangles::sideToHalve(Index triangle) const
{
  const HalfEdge first = 3 * triangle;
  HalfEdge longest = first;
  for (const HalfEdge h : { first + 1, first + 2 })
  {
    longest = this->Lengths[h] > this->Lengths[longest] ? h : longest;
  }
  const double length = this->Lengths[longest];
  const double other = this->Lengths[following(longest)];
  const double third = this->Lengths[preceding(longest)];
  const Index a = this->cornerOf(following(longest));
  const Index b = this->cornerOf(preceding(longest));
  const double least = std::min(this->LeastEdges[a], this->LeastEdges[b]);
  // Beside edges that are far shorter, triangles must grow step by step: a front that enters the
  // small ones by large ones comes again and again, each time a little nearer to the truth.
  constexpr double graded = 8.0;
  const bool isGraded = length > graded * least;
  const double leastHeight = isGraded ? 0.25 : 0.1;
  constexpr double partOfGraded = 0.77;
  const double mostLength = (isGraded ? partOfGraded : 1.0) * this->MostLength;
  const double areas = fourAreas(length, other, third);
  const double square = length * length;
  // A half of a triangle without area has none either.
  constexpr double flat = 1e-9;
  const bool isThin = areas < 2.0 * leastHeight * square;
  const double shortest = std::min(other, third);
  const bool isLong = length > 2.0 * std::max(least, shortest);
  // Where the opposite corner lies nearer to the middle than to either end, the line to the middle
  // would be shorter than all sides, and the triangles beside it thin for that: they would be
  // halved in turn, and so on.
  const double squareToMiddle = 0.5 * (other * other + third * third) - 0.25 * square;
  // Rounding must not tell where both are alike.
  constexpr double rounding = 1.0 + 1e-9;
  const bool isCap = squareToMiddle <= rounding * shortest * shortest;
  const bool isToBeHalved =
    areas > flat * square && ((isThin && isLong && !isCap) || length > mostLength);
  return isToBeHalved && this->Twins[longest] != Fixed ? longest : NoIndex;
}

void IntrinsicTriangles::halve(HalfEdge h)
{
  const Index a = this->cornerOf(following(h));
  const Index b = this->cornerOf(preceding(h));
  if (this->hasTwin(h) && this->cornerOf(following(this->Twins[h])) == a)
  {
    this->reverse(this->Twins[h] / 3);
  }
  const HalfEdge twin = this->Twins[h];
  const double half = 0.5 * this->Lengths[h];
  const Index middle = this->numberOfVertices();
  this->LeastEdges.push_back(std::min(this->LeastEdges[a], this->LeastEdges[b]));
  const HalfEdge behind = this->divide(h, middle);
  if (twin == Border)
  {
    this->Twins[h] = Border;
    this->Twins[behind] = Border;
  }
  else
  {
    const HalfEdge behindTwin = this->divide(twin, middle);
    this->join(h, behindTwin, half);
    this->join(behind, twin, half);
  }
  this->Changed.set(a, b, Removed);
  this->Changed.set(a, middle, half);
  this->Changed.set(b, middle, half);
}

IntrinsicTriangles::HalfEdge IntrinsicTriangles::divide(HalfEdge h, Index middle)
{
  const Index old = h / 3;
  const auto added = static_cast<Index>(this->Corners.size());
  const Index a = this->cornerOf(following(h));
  const Index b = this->cornerOf(preceding(h));
  const Index c = this->cornerOf(h);
  const PlanePoint apex = this->apexOf(h);
  const double length = this->Lengths[h];
  const double half = 0.5 * length;
  const double toMiddle = std::hypot(apex.x - half, apex.y);
  const HalfEdge bc = following(h);
  const double lengthOfBc = this->Lengths[bc];
  const HalfEdge twinOfBc = this->Twins[bc];

  // The old triangle keeps a and its side to c; the new one is middle, b, c.
  this->Corners.push_back({ c, middle, b });
  this->Lengths.resize(this->Lengths.size() + 3);
  this->Twins.resize(this->Twins.size() + 3);
  this->FirstStep.push_back(NoStep);
  this->LastStep.push_back(NoStep);
  this->Corners[old][preceding(h) % 3] = middle;
  const HalfEdge behind = 3 * added;
  this->Lengths[h] = half;
  this->Lengths[behind] = half;
  this->join(behind + 1, twinOfBc, lengthOfBc);
  this->join(behind + 2, bc, toMiddle);
  this->Lengths[bc] = toMiddle;
  this->Changed.set(c, middle, toMiddle);
  this->note({ { a, b, c, middle }, length, apex, { half, 0.0 }, { old, added } });
  this->Touched.insert(this->Touched.end(), { old, added });
  this->Waiting.insert(this->Waiting.end(), { bc, preceding(h), behind + 1 });
  return behind;
}

}
