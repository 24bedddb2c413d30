// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "split/CurveSides.h"

#include "base/Interruption.h"
#include "base/SortUnique.h"
#include "split/LineChains.h"
#include "split/RegionCut.h"
#include "split/RegionSigns.h"

#include <algorithm>
#include <stdexcept>

namespace geodesic
{
namespace
{

using Edge = std::pair<Index, Index>;

bool isSet(std::span<const std::uint8_t> flags, Index at)
{
  return !flags.empty() && flags[at] != 0;
}

/** The corners of a triangle that are excluded. */
Carriers excludedCorners(const TriangleMesh& mesh, Index triangle, const Walls& walls)
{
  Carriers excluded;
  for (const Index corner : mesh.triangle(triangle))
  {
    if (isSet(walls.excluded, corner))
    {
      excluded.add(corner);
    }
  }
  return excluded;
}

/** Whether no front comes into a triangle. */
bool isWithinWalls(const TriangleMesh& mesh, Index triangle, const Walls& walls)
{
  return isSet(walls.closed, triangle) || excludedCorners(mesh, triangle, walls).size() == 3;
}

/** The flags of closed triangles, set for all with the same three corners if any of them is closed.
 */
std::vector<std::uint8_t> closedWithTwins(
  const EdgeTable& edges, std::span<const std::uint8_t> closed)
{
  std::vector<std::uint8_t> all(closed.begin(), closed.end());
  if (!all.empty())
  {
    for (const auto& [repeated, original] : edges.repetitions())
    {
      all[original] |= all[repeated];
    }
    for (const auto& [repeated, original] : edges.repetitions())
    {
      all[repeated] = all[original];
    }
  }
  return all;
}

/** The curves, and then all that separates regions as they do. */
std::vector<SurfacePath> withWalls(
  const TriangleMesh& mesh, std::span<const SurfacePath> curves, const Walls& walls)
{
  std::vector<SurfacePath> lines(curves.begin(), curves.end());
  lines.insert(lines.end(), walls.lines.begin(), walls.lines.end());
  if (walls.excluded.empty() && walls.closed.empty())
  {
    return lines;
  }
  const auto add = [&](Index a, Index b) {
    lines.push_back({ PathPoint::atVertex(a), PathPoint::atVertex(b) });
  };
  for (Index triangle = 0; triangle < mesh.numberOfTriangles(); ++triangle)
  {
    Interruption::checkAt(triangle);
    const Carriers excluded = excludedCorners(mesh, triangle, walls);
    const Triangle& corners = mesh.triangle(triangle);
    if (isSet(walls.closed, triangle))
    {
      add(corners[0], corners[1]);
      add(corners[1], corners[2]);
      add(corners[2], corners[0]);
    }
    else if (excluded.size() == 2)
    {
      add(excluded[0], excluded[1]);
    }
  }
  return lines;
}

/** A part of a curve along an edge. */
struct Stretch
{
  Edge edge;
  Index chain;
  /** 1 if it runs from the edge's smaller point to the larger one, else -1. */
  int direction;

  friend auto operator<=>(const Stretch&, const Stretch&) = default;
};

/** A side of a face at a curve. */
struct SideAtCurve
{
  Edge edge;
  Index region;
  /** Whether the face's corners come in the order smaller point, larger point. */
  bool isForward;

  friend auto operator<=>(const SideAtCurve&, const SideAtCurve&) = default;
};

}

/** Collects what lies beside each other along curves. */
class CurveSides::Collector
{
public:
  /** @param lines  how many lines cut the regions: first the curves, then those of withWalls() */
  Collector(const RegionMesh& mesh, const RegionCut& cut, std::size_t curves, std::size_t lines,
    const std::string& name, const Walls& walls, std::span<const std::uint8_t> shared,
    CurveSides& sides)
    : Mesh(mesh)
    , Cut(cut)
    , Name(name)
    , Barriers(walls)
    , Shared(shared)
    , Sides(sides)
    , OnWall(mesh.mesh().numberOfVertices(), false)
  {
    std::vector<Edge> ends;
    std::vector<std::vector<Index>> points;
    for (std::size_t curve = 0; curve < curves; ++curve)
    {
      points.push_back(cut.pointsOf(curve));
      ends.emplace_back(points.back().front(), points.back().back());
    }
    sides.OnCurve.assign(mesh.mesh().numberOfVertices(), false);
    sides.Chains = chainsOf(ends);
    for (Index chain = 0; chain < sides.Chains.size(); ++chain)
    {
      for (const std::size_t curve : sides.Chains[chain].lines)
      {
        this->addStretches(points[curve], chain);
      }
    }
    this->leaveOutTwice();
    for (std::size_t line = curves; line < lines; ++line)
    {
      const std::vector<Index> along = cut.pointsOf(line);
      for (std::size_t i = 0; i < along.size(); ++i)
      {
        if (line < curves + walls.lines.size() && along[i] < this->OnWall.size())
        {
          this->OnWall[along[i]] = true;
        }
        if (i > 0)
        {
          this->WallEdges.push_back(std::minmax(along[i - 1], along[i]));
        }
      }
    }
    sortUnique(this->WallEdges);
    for (Index vertex = 0; vertex < this->OnWall.size(); ++vertex)
    {
      this->OnWall[vertex] = this->OnWall[vertex] || isSet(walls.excluded, vertex);
    }
  }

  void collect()
  {
    for (const double area : this->Cut.areas())
    {
      this->Sides.Graph.regions.push_back({ area, 0.0 });
    }
    this->measureBorder();
    if (!this->WallEdges.empty())
    {
      this->measureWalls();
    }
    this->addCrossings();
    this->addLinks();
  }

private:
  void addStretches(const std::vector<Index>& points, Index chain)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (points[i] < this->Sides.OnCurve.size())
      {
        this->Sides.OnCurve[points[i]] = true;
      }
      if (i > 0 && points[i] != points[i - 1])
      {
        const Edge edge = std::minmax(points[i - 1], points[i]);
        this->Stretches.push_back({ edge, chain, points[i - 1] == edge.first ? 1 : -1 });
      }
    }
  }

  /** A chain that takes an edge twice has gone to its other side and back. */
  void leaveOutTwice()
  {
    std::sort(this->Stretches.begin(), this->Stretches.end());
    std::vector<Stretch> odd;
    for (auto first = this->Stretches.begin(); first != this->Stretches.end();)
    {
      const auto last = std::find_if(first, this->Stretches.end(),
        [&](const Stretch& s) { return s.edge != first->edge || s.chain != first->chain; });
      if ((last - first) % 2 == 1)
      {
        int direction = 0;
        std::for_each(first, last, [&](const Stretch& s) { direction += s.direction; });
        odd.push_back({ first->edge, first->chain, direction > 0 ? 1 : -1 });
      }
      first = last;
    }
    this->Stretches = std::move(odd);
  }

  std::vector<SideAtCurve> sidesOfFaces() const
  {
    const TriangleMesh& mesh = this->Mesh.mesh();
    std::vector<SideAtCurve> sides;
    const auto add = [&](const Triangle& corners, Index region, Edge edge)
    {
      const auto at = std::find(corners.begin(), corners.end(), edge.first) - corners.begin();
      sides.push_back({ edge, region, corners[(at + 1) % 3] == edge.second });
    };
    for (const RegionCut::Piece& piece : this->Cut.pieces())
    {
      const bool isLeftOut =
        this->Mesh.edges().isRepeated(piece.triangle) || this->isWithinWalls(piece.triangle);
      for (int c = 0; c < 3 && !isLeftOut; ++c)
      {
        const Edge edge = std::minmax(piece.corners[c], piece.corners[(c + 1) % 3]);
        const auto found = std::lower_bound(this->Stretches.begin(), this->Stretches.end(), edge,
          [](const Stretch& stretch, const Edge& e) { return stretch.edge < e; });
        if (found != this->Stretches.end() && found->edge == edge)
        {
          add(piece.corners, piece.region, edge);
        }
      }
    }
    Edge last{ NoIndex, NoIndex };
    for (const Stretch& stretch : this->Stretches)
    {
      if (stretch.edge == last || stretch.edge.second >= mesh.numberOfVertices())
      {
        continue;
      }
      last = stretch.edge;
      for (Index triangle : mesh.trianglesWith(std::array{ last.first, last.second }))
      {
        if (this->Cut.regionOf(triangle) != NoIndex && !this->Mesh.edges().isRepeated(triangle) &&
          !this->isWithinWalls(triangle))
        {
          add(mesh.triangle(triangle), this->Cut.regionOf(triangle), last);
        }
      }
    }
    std::sort(sides.begin(), sides.end());
    return sides;
  }

  void addCrossings()
  {
    RegionGraph& graph = this->Sides.Graph;
    const std::vector<SideAtCurve> sides = this->sidesOfFaces();
    auto side = sides.begin();
    for (auto first = this->Stretches.begin(); first != this->Stretches.end();)
    {
      const Edge edge = first->edge;
      const auto last = std::find_if(
        first, this->Stretches.end(), [&](const Stretch& s) { return s.edge != edge; });
      side = std::find_if(side, sides.end(), [&](const SideAtCurve& s) { return s.edge >= edge; });
      const auto end =
        std::find_if(side, sides.end(), [&](const SideAtCurve& s) { return s.edge != edge; });
      const auto count = end - side;
      if (count > 2)
      {
        throw std::invalid_argument(nameOfLines(this->Name, this->Sides.Chains[first->chain]) +
          " has no two sides: " + std::to_string(count) +
          " faces meet at an edge on it. Lead it where at most 2 do, or turn Signed off.");
      }
      if (count > 0)
      {
        const bool isTurned = count == 2 && side->isForward == std::next(side)->isForward;
        RegionGraph::Crossing crossing{
          { side->region, count == 2 ? std::next(side)->region : NoIndex }, {}
        };
        for (auto stretch = first; stretch != last; ++stretch)
        {
          const bool firstIsLeft = side->isForward == (stretch->direction == 1);
          crossing.passages.push_back({ stretch->chain, isTurned ? 0 : (firstIsLeft ? 1 : -1) });
        }
        graph.crossings.push_back(std::move(crossing));
      }
      first = last;
    }
    sortUnique(graph.crossings);
  }

  void measureBorder()
  {
    const TriangleMesh& mesh = this->Mesh.mesh();
    const std::vector<Index>& border = this->Mesh.border();
    for (const Index halfEdge : border)
    {
      const Index region = this->Cut.regionOf(EdgeTable::triangleOf(halfEdge));
      if (region != NoIndex)
      {
        const auto [a, b] = this->Mesh.endsOf(halfEdge);
        this->addBorder(halfEdge, region, norm(mesh.position(a) - mesh.position(b)));
      }
    }
    for (const RegionCut::Piece& piece : this->Cut.pieces())
    {
      for (Index halfEdge = 3 * piece.triangle; halfEdge < 3 * piece.triangle + 3; ++halfEdge)
      {
        if (!std::binary_search(border.begin(), border.end(), halfEdge))
        {
          continue;
        }
        // The points of the piece that have no part of the corner opposite to the border.
        const Index opposite = mesh.triangle(piece.triangle)[halfEdge % 3];
        std::vector<Vector3> ends;
        for (const Index corner : piece.corners)
        {
          const PathPoint point = this->Cut.pointAt(corner);
          if (weightOf(point, opposite) == 0.0)
          {
            ends.push_back(point.position(mesh));
          }
        }
        if (ends.size() == 2)
        {
          this->addBorder(halfEdge, piece.region, norm(ends[0] - ends[1]));
        }
      }
    }
  }

  bool isWithinWalls(Index triangle) const
  {
    return geodesic::isWithinWalls(this->Mesh.mesh(), triangle, this->Barriers);
  }

  bool isWall(const Edge& edge) const
  {
    return std::binary_search(this->WallEdges.begin(), this->WallEdges.end(), edge);
  }

  bool isShared(Index vertex) const { return !this->Shared.empty() && this->Shared[vertex] != 0; }

  void addBorder(Index halfEdge, Index region, double length)
  {
    const Edge ends = this->Mesh.endsOf(halfEdge);
    const bool isWall = this->isWall(ends) || this->isWithinWalls(EdgeTable::triangleOf(halfEdge));
    if (this->isShared(ends.first) && this->isShared(ends.second))
    {
      this->Sides.SharedBorder.push_back({ ends, isWall ? NoIndex : region, length });
    }
    else if (!isWall)
    {
      this->Sides.Graph.regions[region].border += length;
    }
  }

  /** A wall is like a border: what it keeps out is on neither side. */
  void measureWalls()
  {
    const TriangleMesh& mesh = this->Mesh.mesh();
    const auto measure = [&](Index triangle, const Triangle& corners, Index region)
    {
      for (int c = 0; c < 3 && !this->isWithinWalls(triangle); ++c)
      {
        if (this->isWall(std::minmax(corners[c], corners[(c + 1) % 3])))
        {
          const Vector3 side = this->Cut.pointAt(corners[c]).position(mesh) -
            this->Cut.pointAt(corners[(c + 1) % 3]).position(mesh);
          this->Sides.Graph.regions[region].border += norm(side);
        }
      }
    };
    for (Index triangle = 0; triangle < mesh.numberOfTriangles(); ++triangle)
    {
      Interruption::checkAt(triangle);
      if (this->Cut.regionOf(triangle) != NoIndex && !this->Mesh.edges().isRepeated(triangle))
      {
        measure(triangle, mesh.triangle(triangle), this->Cut.regionOf(triangle));
      }
    }
    for (const RegionCut::Piece& piece : this->Cut.pieces())
    {
      if (!this->Mesh.edges().isRepeated(piece.triangle))
      {
        measure(piece.triangle, piece.corners, piece.region);
      }
    }
  }

  /** Regions that meet at a vertex beside the curves lie on the same sides. */
  void addLinks()
  {
    RegionGraph& graph = this->Sides.Graph;
    const TriangleMesh& mesh = this->Mesh.mesh();
    this->Sides.RegionAt.assign(mesh.numberOfVertices(), NoIndex);
    const auto visit = [&](const Triangle& corners, Index region)
    {
      for (const Index corner : corners)
      {
        if (corner >= mesh.numberOfVertices())
        {
          continue;
        }
        if (this->isShared(corner) && !this->OnWall[corner])
        {
          this->Sides.SharedRegions.emplace_back(corner, region);
        }
        Index& known = this->Sides.RegionAt[corner];
        if (known == NoIndex)
        {
          known = region;
        }
        else if (known != region && !this->Sides.OnCurve[corner] && !this->OnWall[corner] &&
          !this->isShared(corner))
        {
          graph.links.emplace_back(std::minmax(known, region));
        }
      }
    };
    for (Index triangle = 0; triangle < mesh.numberOfTriangles(); ++triangle)
    {
      Interruption::checkAt(triangle);
      if (this->Cut.regionOf(triangle) != NoIndex && !this->isWithinWalls(triangle))
      {
        visit(mesh.triangle(triangle), this->Cut.regionOf(triangle));
      }
    }
    for (const RegionCut::Piece& piece : this->Cut.pieces())
    {
      if (!this->isWithinWalls(piece.triangle))
      {
        visit(piece.corners, piece.region);
      }
    }
    sortUnique(graph.links);
    sortUnique(this->Sides.SharedRegions);
  }

  const RegionMesh& Mesh;
  const RegionCut& Cut;
  const std::string& Name;
  const Walls& Barriers;
  std::span<const std::uint8_t> Shared;
  CurveSides& Sides;
  /** Vertices at which regions stay apart, and which no front reaches. */
  std::vector<bool> OnWall;
  /** Sorted; between points of the cut. */
  std::vector<Edge> WallEdges;
  /** Sorted; at most one for each chain and edge. */
  std::vector<Stretch> Stretches;
};

CurveSides::CurveSides(const std::shared_ptr<const RegionMesh>& mesh,
  std::span<const SurfacePath> curves, const std::string& name, const Walls& walls,
  std::span<const std::uint8_t> shared)
{
  const std::vector<std::uint8_t> closed = closedWithTwins(mesh->edges(), walls.closed);
  const Walls all{ walls.lines, walls.excluded, closed };
  const std::vector<SurfacePath> lines = withWalls(mesh->mesh(), curves, all);
  const RegionCut cut(mesh, lines);
  Collector(*mesh, cut, curves.size(), lines.size(), name, all, shared, *this).collect();
}

std::vector<std::int8_t> CurveSides::signs(std::span<const std::int8_t> ofRegions) const
{
  std::vector<std::int8_t> signs;
  for (Index vertex = 0; vertex < this->RegionAt.size(); ++vertex)
  {
    const bool isBeside = this->RegionAt[vertex] != NoIndex && !this->OnCurve[vertex];
    signs.push_back(isBeside ? ofRegions[this->RegionAt[vertex]] : std::int8_t{ 1 });
  }
  return signs;
}

std::vector<std::int8_t> curveSides(const std::shared_ptr<const RegionMesh>& mesh,
  std::span<const SurfacePath> curves, const std::string& name, const Walls& walls)
{
  const CurveSides sides(mesh, curves, name, walls);
  return sides.signs(regionSigns(sides.graph(), sides.chains(), name));
}

}
