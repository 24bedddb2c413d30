// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "split/RegionCut.h"

#include "base/DisjointSets.h"
#include "base/Interruption.h"
#include "base/SortUnique.h"
#include "split/PieceWeights.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace geodesic
{
namespace
{

/** Those of some pieces, sorted by triangle, that are in a triangle. */
std::span<const RegionCut::Piece> piecesIn(std::span<const RegionCut::Piece> pieces, Index triangle)
{
  const auto first = std::lower_bound(pieces.begin(), pieces.end(), triangle,
    [](const RegionCut::Piece& piece, Index t) { return piece.triangle < t; });
  const auto last = std::upper_bound(first, pieces.end(), triangle,
    [](Index t, const RegionCut::Piece& piece) { return t < piece.triangle; });
  return { first, last };
}

/** A point is in all pieces of a face in which its weights are not below minus this. */
constexpr double PieceTolerance = 1e-9;

/** Calls @p visit with each run of sides of one edge, as its first and last iterator. */
template <class Sides, class Visit>
void visitEdges(const Sides& sides, const Visit& visit)
{
  for (auto first = sides.begin(); first != sides.end();)
  {
    const auto last =
      std::find_if(first, sides.end(), [&](const auto& side) { return side.edge != first->edge; });
    visit(first, last);
    first = last;
  }
}

}

std::vector<Index> placesBySize(std::span<const double> sizes)
{
  std::vector<Index> order(sizes.size());
  std::iota(order.begin(), order.end(), Index{ 0 });
  std::ranges::stable_sort(order, std::greater<>{}, [&](Index number) { return sizes[number]; });
  std::vector<Index> places(order.size());
  for (Index place = 0; place < order.size(); ++place)
  {
    places[order[place]] = place;
  }
  return places;
}

RegionCut::RegionCut(std::shared_ptr<const RegionMesh> mesh, std::span<const SurfacePath> lines,
  std::vector<std::uint8_t> shared)
  : Mesh(std::move(mesh))
  , Splitter(this->Mesh->mesh())
  , Shared(std::move(shared))
{
  for (const SurfacePath& line : lines)
  {
    this->Splitter.add(line);
  }
  this->Splitter.split();
  this->collectPieces();
  const std::vector<Edge> closed = this->edgesOfLines(lines.size());
  this->Sides = this->sidesAtLines(closed);
  DisjointSets parts(static_cast<Index>(this->Regions.size() + this->Pieces.size()));
  this->connectTriangles(parts);
  visitEdges(this->Sides,
    [&](auto first, auto last)
    {
      if (!std::binary_search(closed.begin(), closed.end(), first->edge))
      {
        std::for_each(
          first, last, [&](const Side& side) { parts.connect(first->part, side.part); });
      }
    });
  this->number(parts);
  this->collectSharedSides(closed);
  this->measure();
}

void RegionCut::collectPieces()
{
  const EdgeTable& edges = this->Mesh->edges();
  this->Regions.assign(this->Mesh->mesh().numberOfTriangles(), 0);
  for (Index triangle : this->Splitter.splitTriangles())
  {
    this->Regions[triangle] = NoIndex;
  }
  for (std::size_t p = 0; p < this->Splitter.pieces().size(); ++p)
  {
    const Index triangle = this->Splitter.baseTriangles()[p];
    if (!edges.isRepeated(triangle))
    {
      this->Pieces.push_back({ triangle, this->Splitter.pieces()[p], NoIndex });
    }
  }
  const std::size_t first = this->Pieces.size();
  for (const auto& [repeated, original] : edges.repetitions())
  {
    if (this->Regions[original] == NoIndex)
    {
      this->Regions[repeated] = NoIndex;
      const std::span<const Piece> pieces(this->Pieces.data(), first);
      const std::span<const Piece> ofOriginal = piecesIn(pieces, original);
      const auto& corners = this->Mesh->mesh().triangle(original);
      const auto& twin = this->Mesh->mesh().triangle(repeated);
      const auto at = std::find(twin.begin(), twin.end(), corners[0]) - twin.begin();
      const bool isTurned = twin[(at + 1) % 3] != corners[1];
      const std::vector<Piece> originals(ofOriginal.begin(), ofOriginal.end());
      for (Piece piece : originals)
      {
        piece.triangle = repeated;
        if (isTurned)
        {
          std::swap(piece.corners[1], piece.corners[2]);
        }
        this->Pieces.push_back(piece);
      }
    }
  }
  std::ranges::stable_sort(this->Pieces, {}, &Piece::triangle);
}

std::vector<RegionCut::Edge> RegionCut::edgesOfLines(std::size_t lines) const
{
  std::vector<Edge> closed;
  for (std::size_t line = 0; line < lines; ++line)
  {
    const std::vector<Index> points = this->Splitter.curve(line);
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      closed.push_back(std::minmax(points[i - 1], points[i]));
    }
  }
  sortUnique(closed);
  return closed;
}

std::vector<RegionCut::Side> RegionCut::sidesAtLines(const std::vector<Edge>& lines)
{
  const TriangleMesh& mesh = this->Mesh->mesh();
  const EdgeTable& edges = this->Mesh->edges();
  std::vector<Side> sides;
  for (Index p = 0; p < this->Pieces.size(); ++p)
  {
    const Piece& piece = this->Pieces[p];
    for (int c = 0; c < 3; ++c)
    {
      sides.push_back({ std::minmax(piece.corners[c], piece.corners[(c + 1) % 3]),
        mesh.numberOfTriangles() + p });
    }
  }
  std::set<Index> edgesOfMany;
  for (Index triangle : this->Splitter.splitTriangles())
  {
    for (Index side = 3 * triangle; side < 3 * triangle + 3; ++side)
    {
      if (edges.isOfMany(side) && !edgesOfMany.insert(edges.first(side)).second)
      {
        continue;
      }
      for (Index at = edges.next(side); at != side; at = edges.next(at))
      {
        if (this->Regions[EdgeTable::triangleOf(at)] != NoIndex)
        {
          sides.push_back({ this->Mesh->endsOf(at), EdgeTable::triangleOf(at) });
        }
      }
    }
  }
  this->IsClosed.assign(3 * static_cast<std::size_t>(mesh.numberOfTriangles()), 0);
  for (const Edge& edge : lines)
  {
    if (edge.second >= mesh.numberOfVertices())
    {
      continue;
    }
    const Index ends[] = { edge.first, edge.second };
    Index before = NoIndex;
    for (Index triangle : mesh.trianglesWith(ends))
    {
      Index side = 3 * triangle;
      while (this->Mesh->endsOf(side) != edge)
      {
        ++side;
      }
      this->IsClosed[side] = 1;
      if (this->Regions[triangle] != NoIndex)
      {
        sides.push_back({ edge, triangle });
        if (before != NoIndex)
        {
          this->ClosedEdges.emplace_back(before, triangle);
        }
        before = triangle;
      }
    }
  }
  sortUnique(sides);
  return sides;
}

void RegionCut::connectTriangles(DisjointSets& parts) const
{
  const EdgeTable& edges = this->Mesh->edges();
  const auto sides = static_cast<Index>(this->IsClosed.size());
  for (Index side = 0; side < sides; ++side)
  {
    Interruption::checkAt(side);
    const Index next = edges.next(side);
    const bool isDone = next == side || (next < side && edges.next(next) == side);
    const Index triangle = EdgeTable::triangleOf(side);
    const Index other = EdgeTable::triangleOf(next);
    if (!isDone && this->IsClosed[side] == 0 && this->Regions[triangle] != NoIndex &&
      this->Regions[other] != NoIndex)
    {
      parts.connect(triangle, other);
    }
  }
  for (const auto& [repeated, original] : edges.repetitions())
  {
    if (this->Regions[original] != NoIndex)
    {
      parts.connect(repeated, original);
    }
  }
}

void RegionCut::number(DisjointSets& parts)
{
  const auto triangles = static_cast<Index>(this->Regions.size());
  std::vector<Index> found(parts.size(), NoIndex);
  const auto take = [&](Index part, double area)
  {
    Index& number = found[parts.rootOf(part)];
    if (number == NoIndex)
    {
      number = static_cast<Index>(this->Areas.size());
      this->Areas.push_back(0.0);
    }
    this->Areas[number] += area;
    return number;
  };
  for (Index triangle = 0; triangle < triangles; ++triangle)
  {
    Interruption::checkAt(triangle);
    if (this->Regions[triangle] != NoIndex)
    {
      this->Regions[triangle] = take(triangle, this->Mesh->areaOf(triangle));
    }
  }
  for (Index p = 0; p < this->Pieces.size(); ++p)
  {
    this->Pieces[p].region = take(triangles + p, this->areaOf(this->Pieces[p]));
  }
  const std::vector<Index> places = placesBySize(this->Areas);
  std::vector<double> areas(this->Areas.size());
  for (Index region = 0; region < places.size(); ++region)
  {
    areas[places[region]] = this->Areas[region];
  }
  this->Areas = std::move(areas);
  this->replaceRegions(places);
}

void RegionCut::replaceRegions(std::span<const Index> numbers)
{
  for (Index& region : this->Regions)
  {
    region = region == NoIndex ? NoIndex : numbers[region];
  }
  for (Piece& piece : this->Pieces)
  {
    piece.region = numbers[piece.region];
  }
  for (SharedSide& side : this->SharedSides)
  {
    side.region = numbers[side.region];
  }
}

void RegionCut::collectSharedSides(const std::vector<Edge>& lines)
{
  if (this->Shared.empty())
  {
    return;
  }
  const auto add = [&](const Edge& edge, Index region)
  {
    const bool isOnLine = std::binary_search(lines.begin(), lines.end(), edge);
    this->SharedSides.push_back({ edge, region, isOnLine, this->lengthOf(edge) });
  };
  const auto sides = static_cast<Index>(3 * this->Regions.size());
  for (Index side = 0; side < sides; ++side)
  {
    Interruption::checkAt(side);
    const Index triangle = EdgeTable::triangleOf(side);
    const Edge edge = this->Mesh->endsOf(side);
    if (this->Regions[triangle] != NoIndex && !this->Mesh->edges().isRepeated(triangle) &&
      this->isShared(edge))
    {
      add(edge, this->Regions[triangle]);
    }
  }
  for (const Piece& piece : this->Pieces)
  {
    for (int c = 0; c < 3 && !this->Mesh->edges().isRepeated(piece.triangle); ++c)
    {
      const Edge edge = std::minmax(piece.corners[c], piece.corners[(c + 1) % 3]);
      if (this->isShared(edge))
      {
        add(edge, piece.region);
      }
    }
  }
}

bool RegionCut::isShared(const Edge& edge) const
{
  if (this->Shared.empty())
  {
    return false;
  }
  const Carriers ends = unionOf(this->pointAt(edge.first), this->pointAt(edge.second));
  return ends.size() == 2 && this->Shared[ends[0]] != 0 && this->Shared[ends[1]] != 0;
}

void RegionCut::renumber(
  std::span<const Index> numbers, std::vector<double> areas, const std::vector<bool>& separating)
{
  this->replaceRegions(numbers);
  this->Areas = std::move(areas);
  this->measure();
  for (std::size_t side = 0; side < this->SharedSides.size(); ++side)
  {
    if (separating[side])
    {
      this->Separating.push_back(this->SharedSides[side].edge);
    }
  }
  sortUnique(this->Separating);
}

void RegionCut::measure()
{
  this->Perimeters.assign(this->Areas.size(), 0.0);
  this->Separating.clear();
  for (Index side : this->Mesh->border())
  {
    const Index region = this->Regions[EdgeTable::triangleOf(side)];
    if (region != NoIndex && this->IsClosed[side] == 0 && !this->isShared(this->Mesh->endsOf(side)))
    {
      this->Perimeters[region] += this->lengthOf(this->Mesh->endsOf(side));
    }
  }
  visitEdges(this->Sides,
    [&](auto first, auto last)
    {
      if (this->isShared(first->edge))
      {
        return;
      }
      std::vector<Index> regions;
      std::transform(first, last, std::back_inserter(regions),
        [&](const Side& side) { return this->regionOfPart(side.part); });
      const bool isBorder = regions.size() == 1;
      sortUnique(regions);
      if (isBorder || regions.size() > 1)
      {
        for (Index region : regions)
        {
          this->Perimeters[region] += this->lengthOf(first->edge);
        }
      }
      if (regions.size() > 1)
      {
        this->Separating.push_back(first->edge);
      }
    });
}

Index RegionCut::regionOfPart(Index part) const
{
  const auto triangles = static_cast<Index>(this->Regions.size());
  return part < triangles ? this->Regions[part] : this->Pieces[part - triangles].region;
}

double RegionCut::lengthOf(const Edge& edge) const
{
  const TriangleMesh& mesh = this->Mesh->mesh();
  return norm(this->pointAt(edge.first).position(mesh) - this->pointAt(edge.second).position(mesh));
}

double RegionCut::areaOf(const Piece& piece) const
{
  // By weights and not by positions: the parts then add up to the whole to rounding, also where the
  // triangle is thin.
  const Triangle& corners = this->Mesh->mesh().triangle(piece.triangle);
  const std::array<PathPoint, 3> points{ this->pointAt(piece.corners[0]),
    this->pointAt(piece.corners[1]), this->pointAt(piece.corners[2]) };
  const auto x = [&](int i)
  { return weightOf(points[i], corners[1]) - weightOf(points[0], corners[1]); };
  const auto y = [&](int i)
  { return weightOf(points[i], corners[2]) - weightOf(points[0], corners[2]); };
  return std::abs(x(1) * y(2) - x(2) * y(1)) * this->Mesh->areaOf(piece.triangle);
}

std::span<const RegionCut::Piece> RegionCut::piecesOf(Index triangle) const
{
  return piecesIn(this->Pieces, triangle);
}

std::vector<Index> RegionCut::regionsAt(const SurfacePoint& point) const
{
  const TriangleMesh& mesh = this->Mesh->mesh();
  const PathPoint place = PathPoint::at(mesh, point);
  const Carriers carriers = place.carriers();
  std::vector<Index> regions;
  for (Index triangle : mesh.trianglesWith({ carriers.begin(), carriers.end() }))
  {
    if (this->Regions[triangle] != NoIndex)
    {
      regions.push_back(this->Regions[triangle]);
      continue;
    }
    const Triangle& corners = mesh.triangle(triangle);
    const std::array<double, 3> weights{ weightOf(place, corners[0]), weightOf(place, corners[1]),
      weightOf(place, corners[2]) };
    // In a thin piece rounding can put the point outside all of them; then the nearest one counts.
    Index deepest = NoIndex;
    double depth = -std::numeric_limits<double>::infinity();
    for (const Piece& piece : this->piecesOf(triangle))
    {
      const std::array<double, 3> inPiece =
        weightsIn({ this->pointAt(piece.corners[0]), this->pointAt(piece.corners[1]),
                    this->pointAt(piece.corners[2]) },
          corners, weights);
      const double least = *std::min_element(inPiece.begin(), inPiece.end());
      if (least >= -PieceTolerance)
      {
        regions.push_back(piece.region);
      }
      if (least > depth)
      {
        depth = least;
        deepest = piece.region;
      }
    }
    if (depth < -PieceTolerance)
    {
      regions.push_back(deepest);
    }
  }
  sortUnique(regions);
  return regions;
}

void RegionCut::putFirst(Index region)
{
  std::vector<Index> numbers(this->Areas.size());
  std::iota(numbers.begin(), numbers.end(), Index{ 0 });
  std::iota(numbers.begin(), numbers.begin() + region, Index{ 1 });
  numbers[region] = 0;
  this->replaceRegions(numbers);
  for (std::vector<double>* values : { &this->Areas, &this->Perimeters })
  {
    const auto place = values->begin() + region;
    std::rotate(values->begin(), place, place + 1);
  }
}

bool RegionCut::separates(std::size_t line) const
{
  const std::vector<Index> points = this->Splitter.curve(line);
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const Edge edge = std::minmax(points[i - 1], points[i]);
    if (std::binary_search(this->Separating.begin(), this->Separating.end(), edge))
    {
      return true;
    }
  }
  return false;
}

}
