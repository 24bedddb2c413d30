// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/Strip.h"

#include <algorithm>
#include <utility>

namespace geodesic
{
namespace
{

/** A point of an edge counts as the edge's end if it is nearer to it than this fraction. */
constexpr double VertexFraction = 1e-12;

/** Appends the face that lies beyond the edge from @p a to @p b of the last one. */
void enterFace(Strip& strip, Index a, Index b, Index apex)
{
  if (strip.size() > 1 && strip.back().isEnteredBy(a, b))
  {
    strip.pop_back();
    if (strip.back().hasCorner(apex))
    {
      return;
    }
  }
  // The end that two consecutive edges share stays on its side.
  const bool swaps = strip.size() > 1 && (b == strip.back().left || a == strip.back().right);
  strip.push_back(swaps ? StripFace{ b, a, apex } : StripFace{ a, b, apex });
}

}

PathPoint StripFace::crossingPoint() const
{
  if (this->crossing < VertexFraction)
  {
    return PathPoint::atVertex(this->left);
  }
  if (this->crossing > 1.0 - VertexFraction)
  {
    return PathPoint::atVertex(this->right);
  }
  return PathPoint::onEdge(this->left, this->right, this->crossing);
}

void appendFace(Strip& strip, const Triangle& face)
{
  if (strip.empty())
  {
    strip.push_back({ face[0], face[1], face[2] });
    return;
  }
  const auto* apex = std::find_if(face.begin(), face.end(),
    [last = strip.back()](Index corner) { return !last.hasCorner(corner); });
  if (apex != face.end())
  {
    const auto i = apex - face.begin();
    enterFace(strip, face[(i + 1) % 3], face[(i + 2) % 3], *apex);
  }
}

void appendStrip(Strip& strip, const Strip& other)
{
  if (other.empty())
  {
    return;
  }
  appendFace(strip, other[0].corners());
  std::for_each(other.begin() + 1, other.end(),
    [&](const StripFace& face) { enterFace(strip, face.left, face.right, face.apex); });
}

}
