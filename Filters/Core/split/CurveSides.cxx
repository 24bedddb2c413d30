// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "split/CurveSides.h"

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
struct Side
{
  Edge edge;
  Index region;
  /** Whether the face's corners come in the order smaller point, larger point. */
  bool isForward;

  friend auto operator<=>(const Side&, const Side&) = default;
};

/** Collects what lies beside each other along curves. */
class Collector
{
public:
  Collector(
    const RegionMesh& mesh, const RegionCut& cut, std::size_t curves, const std::string& name)
    : Mesh(mesh)
    , Cut(cut)
    , Name(name)
    , OnCurve(mesh.mesh().numberOfVertices(), false)
  {
    std::vector<Edge> ends;
    std::vector<std::vector<Index>> points;
    for (std::size_t curve = 0; curve < curves; ++curve)
    {
      points.push_back(cut.pointsOf(curve));
      ends.emplace_back(points.back().front(), points.back().back());
    }
    this->Chains = chainsOf(ends);
    for (Index chain = 0; chain < this->Chains.size(); ++chain)
    {
      for (const std::size_t curve : this->Chains[chain].lines)
      {
        this->addStretches(points[curve], chain);
      }
    }
    this->leaveOutTwice();
  }

  const std::vector<LineChain>& chains() const { return this->Chains; }
  bool isOnCurve(Index vertex) const { return this->OnCurve[vertex]; }
  /** One of the regions at each vertex; NoIndex for those that no face has. */
  const std::vector<Index>& regionsAt() const { return this->RegionAt; }

  RegionGraph graph()
  {
    RegionGraph graph;
    for (const double area : this->Cut.areas())
    {
      graph.regions.push_back({ area, 0.0 });
    }
    this->measureBorder(graph);
    this->addCrossings(graph);
    this->addLinks(graph);
    return graph;
  }

private:
  void addStretches(const std::vector<Index>& points, Index chain)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (points[i] < this->OnCurve.size())
      {
        this->OnCurve[points[i]] = true;
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

  std::vector<Side> sides() const
  {
    const TriangleMesh& mesh = this->Mesh.mesh();
    std::vector<Side> sides;
    const auto add = [&](const Triangle& corners, Index region, Edge edge)
    {
      const auto at = std::find(corners.begin(), corners.end(), edge.first) - corners.begin();
      sides.push_back({ edge, region, corners[(at + 1) % 3] == edge.second });
    };
    for (const RegionCut::Piece& piece : this->Cut.pieces())
    {
      for (int c = 0; c < 3 && !this->Mesh.edges().isRepeated(piece.triangle); ++c)
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
        if (this->Cut.regionOf(triangle) != NoIndex && !this->Mesh.edges().isRepeated(triangle))
        {
          add(mesh.triangle(triangle), this->Cut.regionOf(triangle), last);
        }
      }
    }
    std::sort(sides.begin(), sides.end());
    return sides;
  }

  void addCrossings(RegionGraph& graph) const
  {
    const std::vector<Side> sides = this->sides();
    auto side = sides.begin();
    for (auto first = this->Stretches.begin(); first != this->Stretches.end();)
    {
      const Edge edge = first->edge;
      const auto last = std::find_if(
        first, this->Stretches.end(), [&](const Stretch& s) { return s.edge != edge; });
      side = std::find_if(side, sides.end(), [&](const Side& s) { return s.edge >= edge; });
      const auto end =
        std::find_if(side, sides.end(), [&](const Side& s) { return s.edge != edge; });
      const auto count = end - side;
      if (count > 2)
      {
        throw std::invalid_argument(nameOfLines(this->Name, this->Chains[first->chain]) +
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

  void measureBorder(RegionGraph& graph) const
  {
    const TriangleMesh& mesh = this->Mesh.mesh();
    const std::vector<Index>& border = this->Mesh.border();
    for (const Index halfEdge : border)
    {
      const Index region = this->Cut.regionOf(EdgeTable::triangleOf(halfEdge));
      if (region != NoIndex)
      {
        const auto [a, b] = this->Mesh.endsOf(halfEdge);
        graph.regions[region].border += norm(mesh.position(a) - mesh.position(b));
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
          graph.regions[piece.region].border += norm(ends[0] - ends[1]);
        }
      }
    }
  }

  /** Regions that meet at a vertex beside the curves lie on the same sides. */
  void addLinks(RegionGraph& graph)
  {
    const TriangleMesh& mesh = this->Mesh.mesh();
    this->RegionAt.assign(mesh.numberOfVertices(), NoIndex);
    const auto visit = [&](const Triangle& corners, Index region)
    {
      for (const Index corner : corners)
      {
        if (corner >= mesh.numberOfVertices())
        {
          continue;
        }
        Index& known = this->RegionAt[corner];
        if (known == NoIndex)
        {
          known = region;
        }
        else if (known != region && !this->OnCurve[corner])
        {
          graph.links.emplace_back(std::minmax(known, region));
        }
      }
    };
    for (Index triangle = 0; triangle < mesh.numberOfTriangles(); ++triangle)
    {
      if (this->Cut.regionOf(triangle) != NoIndex)
      {
        visit(mesh.triangle(triangle), this->Cut.regionOf(triangle));
      }
    }
    for (const RegionCut::Piece& piece : this->Cut.pieces())
    {
      visit(piece.corners, piece.region);
    }
    sortUnique(graph.links);
  }

  const RegionMesh& Mesh;
  const RegionCut& Cut;
  const std::string& Name;
  std::vector<LineChain> Chains;
  /** Sorted; at most one for each chain and edge. */
  std::vector<Stretch> Stretches;
  std::vector<bool> OnCurve;
  std::vector<Index> RegionAt;
};

}

std::vector<std::int8_t> curveSides(const std::shared_ptr<const RegionMesh>& mesh,
  std::span<const SurfacePath> curves, const std::string& name)
{
  const RegionCut cut(mesh, curves);
  Collector collector(*mesh, cut, curves.size(), name);
  const RegionGraph graph = collector.graph();
  const std::vector<std::int8_t> ofRegions = regionSigns(graph, collector.chains(), name);
  std::vector<std::int8_t> signs;
  for (Index vertex = 0; vertex < mesh->mesh().numberOfVertices(); ++vertex)
  {
    const Index region = collector.regionsAt()[vertex];
    const bool isBeside = region != NoIndex && !collector.isOnCurve(vertex);
    signs.push_back(isBeside ? ofRegions[region] : 1);
  }
  return signs;
}

}
