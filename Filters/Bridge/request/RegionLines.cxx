// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "request/RegionLines.h"

#include "march/FastMarchingSolver.h"
#include "path/SurfaceCurve.h"
#include "request/PointResolver.h"
#include "split/LineChains.h"

#include "vtkDataObject.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace geodesic::bridge
{
namespace
{

/** A warning names no more chains of lines than this. */
constexpr std::size_t MostNamed = 5;

bool shareFace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b)
{
  const Carriers corners = unionOf(PathPoint::at(mesh, a), PathPoint::at(mesh, b));
  return corners.size() <= 3 && mesh.hasTriangleWith({ corners.begin(), corners.end() });
}

std::vector<LinePoints> pointsOnSurface(const InputSurface& surface, vtkDataObject* data)
{
  if (!data)
  {
    return {};
  }
  const PointSource source(data);
  checkHasLines(source);
  const std::vector<Vector3> positions = positionsAt(source.coordinates, "Lines");
  std::vector<SurfacePoint> points;
  points.reserve(positions.size());
  for (const Vector3& position : positions)
  {
    points.push_back(
      snappedAsSingle(*surface.mesh(), surface.closestPoints().closestPoint(position).point));
  }
  std::vector<LinePoints> lines;
  for (const std::vector<std::size_t>& numbers : source.lines)
  {
    LinePoints& line = lines.emplace_back();
    for (const std::size_t number : numbers)
    {
      line.push_back(points[number]);
    }
  }
  return lines;
}

/** "Line 2", "Lines 2 to 5" or "Lines 2, 4 and 7". */
void writeNames(std::ostream& message, const std::vector<std::size_t>& lines)
{
  const bool areConsecutive = lines.back() - lines.front() + 1 == lines.size();
  message << (lines.size() == 1 ? "Line " : "Lines ") << lines.front();
  if (areConsecutive && lines.size() > 2)
  {
    message << " to " << lines.back();
    return;
  }
  for (std::size_t i = 1; i < lines.size(); ++i)
  {
    message << (i + 1 < lines.size() ? ", " : " and ") << lines[i];
  }
}

}

bool RegionLines::update(const std::shared_ptr<const InputSurface>& surface, vtkDataObject* source,
  const std::function<bool()>& goesOn)
{
  std::vector<LinePoints> lines = pointsOnSurface(*surface, source);
  const bool isSameSurface = surface == this->Surface;
  if (!isSameSurface)
  {
    *this = RegionLines();
    this->Surface = surface;
  }
  std::vector<SurfacePath> paths;
  for (std::size_t line = 0; line < lines.size(); ++line)
  {
    const bool isKept = line < this->Points.size() && this->Points[line] == lines[line];
    if (!isKept && !goesOn())
    {
      // The kept paths have been taken out.
      this->Points.clear();
      this->Paths.clear();
      return false;
    }
    paths.push_back(isKept ? std::move(this->Paths[line]) : this->joined(lines[line], line));
  }
  this->Points = std::move(lines);
  this->Paths = std::move(paths);
  return true;
}

SurfacePath RegionLines::joined(const LinePoints& points, std::size_t line)
{
  const TriangleMesh& mesh = *this->Surface->mesh();
  const auto gap = std::adjacent_find(points.begin(), points.end(),
    [&](const SurfacePoint& a, const SurfacePoint& b) { return !shareFace(mesh, a, b); });
  if (gap == points.end())
  {
    SurfacePath path;
    for (const SurfacePoint& point : points)
    {
      path.push_back(PathPoint::at(mesh, point));
    }
    return path;
  }
  if (!this->Solver)
  {
    this->Solver = std::make_shared<FastMarchingSolver>(this->Surface->mesh());
  }
  return joinedCurve(*this->Solver, points, "Lines' line " + std::to_string(line));
}

void checkHasLines(const PointSource& source)
{
  if (source.lines.empty() && !source.coordinates.empty())
  {
    throw std::invalid_argument("Lines has " + std::to_string(source.coordinates.size() / 3) +
      " points but no line. Give polylines, for example a Geodesic Path.");
  }
}

std::string linesThatSeparateNothing(
  std::span<const std::pair<Index, Index>> ends, const std::vector<bool>& separates)
{
  std::ostringstream message;
  std::size_t count = 0;
  for (const LineChain& chain : chainsOf(ends))
  {
    const bool isSeparating = std::any_of(
      chain.lines.begin(), chain.lines.end(), [&](std::size_t line) { return separates[line]; });
    if (isSeparating || ++count > MostNamed)
    {
      continue;
    }
    const bool isOne = chain.lines.size() == 1;
    message << (count > 1 ? " " : "");
    writeNames(message, chain.lines);
    message
      << " of Lines " << (isOne ? "separates" : "separate")
      << " nothing: " << (isOne ? "it is " : "they are ")
      << (chain.isClosed
             ? "closed, but both sides are connected round a handle, or the surface ends "
               "there; cut the handle by a second loop."
             : "open, and both sides are connected round its end or round a handle; close the "
               "line, or lead its ends to the border or to other lines.");
  }
  if (count > MostNamed)
  {
    message << " There are " << count - MostNamed << " more such lines.";
  }
  return message.str();
}

}
