// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/Isolines.h"

#include "base/DisjointSets.h"
#include "path/FaceField.h"
#include "path/FlatFace.h"
#include "path/IsolineJoining.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

namespace geodesic
{
namespace
{

/** The sign of the values of a face or an edge, 0 if there are both. */
int signOf(std::initializer_list<double> values)
{
  const auto [least, most] = std::minmax(values);
  return least >= 0.0 ? 1 : (most <= 0.0 ? -1 : 0);
}

class Tracer
{
public:
  Tracer(const TriangleMesh& mesh, const EdgeTable& edges, std::span<const double> values)
    : Mesh(mesh)
    , Edges(edges)
    , Values(values)
    , Below(mesh.numberOfVertices())
    , AreaBelow(mesh.numberOfVertices(), 0.0)
  {
    this->findRanges();
    this->chooseEdges();
    this->findEvents();
  }

  /** Levels must come in increasing order. */
  void trace(double level, std::vector<Isoline>& isolines)
  {
    this->Level = level;
    this->raise();
    this->Pieces.clear();
    this->Sets.emplace(0);
    this->SetAreas.clear();
    this->SetOfKey.clear();
    for (const Index range : this->Active)
    {
      this->cut(this->Ranges[range].face);
    }
    std::vector<double> areas(this->SetAreas.size(), 0.0);
    for (Index set = 0; set < areas.size(); ++set)
    {
      areas[this->Sets->rootOf(set)] += this->SetAreas[set];
    }
    std::vector<double> ofPieces;
    for (const LevelPiece& piece : this->Pieces)
    {
      ofPieces.push_back(areas[this->Sets->rootOf(piece.set)]);
    }
    joinPieces(level, this->Pieces, ofPieces, isolines);
  }

private:
  struct Range
  {
    double low;
    double high;
    Index face;
  };
  /** From this value on two or three corners of a face are below the level. */
  struct Event
  {
    double value;
    Index face;
    bool isWhole;
  };

  std::array<double, 3> valuesOf(Index face) const
  {
    const Triangle& t = this->Mesh.triangle(face);
    return { this->Values[t[0]], this->Values[t[1]], this->Values[t[2]] };
  }

  FlatFace flat(Index face) const
  {
    const Triangle& t = this->Mesh.triangle(face);
    return { this->Mesh.position(t[0]), this->Mesh.position(t[1]), this->Mesh.position(t[2]) };
  }

  static FaceField fieldOf(const FlatFace& face, const std::array<double, 3>& values)
  {
    return { face.corners, { std::abs(values[0]), std::abs(values[1]), std::abs(values[2]) } };
  }

  double areaOf(Index face) const
  {
    const FlatFace flat = this->flat(face);
    return 0.5 * orientation(flat.corners[0], flat.corners[1], flat.corners[2]);
  }

  /** A half-edge that is the same for all faces with its edge. */
  Index edgeOf(Index halfEdge) const
  {
    Index least = halfEdge;
    for (Index at = this->Edges.next(halfEdge); at != halfEdge; at = this->Edges.next(at))
    {
      least = std::min(least, at);
    }
    return least;
  }

  /** The corners of a half-edge's edge, smaller vertex first. */
  std::pair<Index, Index> endsOf(Index halfEdge) const
  {
    const Triangle& t = this->Mesh.triangle(EdgeTable::triangleOf(halfEdge));
    return std::minmax(t[(halfEdge + 1) % 3], t[(halfEdge + 2) % 3]);
  }

  /** Whether the face has an area and values, and the field is of one kind in it. */
  bool hasField(Index face) const
  {
    const auto values = this->valuesOf(face);
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }) &&
      !this->Edges.isRepeated(face) && this->areaOf(face) > 0.0;
  }

  void findRanges()
  {
    for (Index face = 0; face < this->Mesh.numberOfTriangles(); ++face)
    {
      if (!this->hasField(face))
      {
        continue;
      }
      const auto values = this->valuesOf(face);
      const auto [least, most] = std::minmax_element(values.begin(), values.end());
      // A distance can be nearer to 0 inside of the face than at each corner.
      const double low = *least > 0.0 ? 0.0 : *least;
      const double high = *most < 0.0 ? 0.0 : *most;
      const double size = this->Mesh.longestEdgeAround(this->Mesh.triangle(face)[0]);
      this->Ranges.push_back({ std::max(low, *least - size), std::min(high, *most + size), face });
    }
    std::ranges::sort(this->Ranges, {}, &Range::low);
  }

  void chooseEdges()
  {
    const Index halfEdges = 3 * this->Mesh.numberOfTriangles();
    std::vector<double> preference(halfEdges, 0.0);
    for (const Range& range : this->Ranges)
    {
      const auto values = this->valuesOf(range.face);
      const bool isOfOneSign = signOf({ values[0], values[1], values[2] }) != 0;
      const FaceField field = fieldOf(this->flat(range.face), values);
      const double size = this->Mesh.longestEdgeLength();
      const double round = isOfOneSign ? std::min(field.roundError(), size) : size;
      for (Index h = 3 * range.face; h < 3 * range.face + 3; ++h)
      {
        preference[this->edgeOf(h)] += std::min(field.straightError(), size) - round;
      }
    }
    this->IsRound.assign(halfEdges, false);
    for (Index h = 0; h < halfEdges; ++h)
    {
      this->IsRound[h] = preference[this->edgeOf(h)] >= 0.0;
    }
  }

  void findEvents()
  {
    for (const Range& range : this->Ranges)
    {
      auto values = this->valuesOf(range.face);
      std::sort(values.begin(), values.end());
      this->Events.push_back({ values[1], range.face, false });
      this->Events.push_back({ values[2], range.face, true });
    }
    std::ranges::sort(
      this->Events, {}, [](const Event& e) { return std::pair(e.value, e.isWhole); });
  }

  void connect(Index a, Index b)
  {
    const auto [root, other] = this->Below.connect(a, b);
    if (root != other)
    {
      this->AreaBelow[root] += this->AreaBelow[other];
    }
  }

  /** Brings all that depends on the level to it. */
  void raise()
  {
    for (;
         this->NextEvent < this->Events.size() && this->Events[this->NextEvent].value < this->Level;
         ++this->NextEvent)
    {
      const Event& event = this->Events[this->NextEvent];
      Triangle t = this->Mesh.triangle(event.face);
      std::sort(
        t.begin(), t.end(), [&](Index a, Index b) { return this->Values[a] < this->Values[b]; });
      this->connect(t[0], t[event.isWhole ? 2 : 1]);
      if (event.isWhole)
      {
        this->AreaBelow[this->Below.rootOf(t[0])] += this->areaOf(event.face);
      }
    }
    for (; this->NextRange < this->Ranges.size() && this->Ranges[this->NextRange].low < this->Level;
         ++this->NextRange)
    {
      this->Active.push_back(this->NextRange);
    }
    std::erase_if(
      this->Active, [&](Index range) { return this->Ranges[range].high < this->Level; });
  }

  /** The set of a vertex below the level, or of what an edge or a face has below it. */
  Index setOf(std::uint64_t key, double area)
  {
    const auto [found, isNew] = this->SetOfKey.emplace(key, NoIndex);
    if (isNew)
    {
      found->second = this->Sets->add();
      this->SetAreas.push_back(area);
    }
    return found->second;
  }
  Index setOfVertex(Index vertex)
  {
    const Index root = this->Below.rootOf(vertex);
    return this->setOf(root, this->AreaBelow[root]);
  }
  Index setOfEdge(Index edge)
  {
    return this->setOf(std::uint64_t{ this->Mesh.numberOfVertices() } + edge, 0.0);
  }

  /** A place where the level enters or leaves a face on its border. */
  struct Crossing
  {
    LevelPiece::Node node;
    PlanePoint place;
    /** The corner after which it comes. */
    int corner;
  };

  std::vector<Crossing> crossingsOf(Index face, const FlatFace& flat)
  {
    std::vector<Crossing> crossings;
    const Triangle& t = this->Mesh.triangle(face);
    for (int c = 0; c < 3; ++c)
    {
      // The side from corner c to the next one is opposite to the third.
      const Index halfEdge = 3 * face + (c + 2) % 3;
      const auto [a, b] = this->endsOf(halfEdge);
      const double first = this->Values[a];
      const double second = this->Values[b];
      const int sign = signOf({ first, second });
      const double length = norm(this->Mesh.position(a) - this->Mesh.position(b));
      std::vector<double> places;
      if (sign < 0 && this->IsRound[halfEdge])
      {
        // What is below the level is not below it by its distance, and the other way round.
        const double above = std::nextafter(-this->Level, std::numeric_limits<double>::infinity());
        places = placesOnEdge(-first, -second, length, true, above);
      }
      else
      {
        places =
          placesOnEdge(first, second, length, sign > 0 && this->IsRound[halfEdge], this->Level);
      }
      std::vector<Crossing> ofSide;
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        const double along = t[c] == a ? places[i] : 1.0 - places[i];
        const PlanePoint& from = flat.corners[c];
        const PlanePoint& to = flat.corners[(c + 1) % 3];
        ofSide.push_back({ { this->edgeOf(halfEdge), static_cast<Index>(i) },
          { from.x + along * (to.x - from.x), from.y + along * (to.y - from.y) }, c });
      }
      if (t[c] != a)
      {
        std::reverse(ofSide.begin(), ofSide.end());
      }
      crossings.insert(crossings.end(), ofSide.begin(), ofSide.end());
    }
    return crossings;
  }

  /** Adds the pieces of the level in a face. */
  void cut(Index face)
  {
    const Triangle& t = this->Mesh.triangle(face);
    const auto values = this->valuesOf(face);
    const FlatFace flat = this->flat(face);
    const std::vector<Crossing> crossings = this->crossingsOf(face, flat);
    const int sign = signOf({ values[0], values[1], values[2] });
    // Where the distance is less than the level's, which is convex.
    const bool nearIsBelow = sign >= 0;
    const bool firstIsBelow = values[0] < this->Level;
    const FaceField field = sign == 0 ? FaceField(flat.corners, values) : fieldOf(flat, values);
    if (crossings.empty())
    {
      this->addCircle(face, flat, field, sign);
      return;
    }
    std::optional<Index> set;
    const auto unite = [&](Index other)
    { set = set ? this->Sets->connect(*set, other).first : other; };
    for (int c = 0; c < 3; ++c)
    {
      if (values[c] < this->Level)
      {
        unite(this->setOfVertex(t[c]));
      }
    }
    for (const Crossing& crossing : crossings)
    {
      unite(this->setOfEdge(crossing.node.first));
    }
    double near = field.area();
    const std::size_t count = crossings.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      // The border between crossings i and i + 1; at corner 0 it begins with that corner's state.
      const bool isBelow = (i % 2 == 0) != firstIsBelow;
      if (isBelow == nearIsBelow)
      {
        continue;
      }
      const Crossing& from = crossings[i];
      const Crossing& to = crossings[(i + 1) % count];
      FaceField::Arc arc = sign == 0 ? FaceField::Arc{ { from.place, to.place },
        std::hypot(to.place.x - from.place.x, to.place.y - from.place.y), 0.0 }
                                     : field.arc(from.place, to.place);
      near -= this->areaBeside(flat, from, to, i + 1 == count) - arc.segment;
      this->addPiece(flat, arc, { from.node, to.node }, *set);
    }
    this->SetAreas[*set] += nearIsBelow ? near : field.area() - near;
  }

  /** The area between the border from one crossing to another and the straight line back. */
  static double areaBeside(
    const FlatFace& flat, const Crossing& from, const Crossing& to, bool passesStart)
  {
    std::vector<PlanePoint> around{ from.place };
    const int last = to.corner + (passesStart ? 3 : 0);
    for (int c = from.corner + 1; c <= last; ++c)
    {
      around.push_back(flat.corners[c % 3]);
    }
    around.push_back(to.place);
    double area = 0.0;
    for (std::size_t i = 1; i + 1 < around.size(); ++i)
    {
      area += 0.5 * orientation(around[0], around[i], around[i + 1]);
    }
    return area;
  }

  /** Adds a whole circle round a seed inside of a face. */
  void addCircle(Index face, const FlatFace& flat, const FaceField& field, int sign)
  {
    const auto values = this->valuesOf(face);
    const bool firstIsBelow = values[0] < this->Level;
    const double radius = sign * this->Level;
    if (sign == 0 || !field.hasSource() || !(radius > 0.0) || firstIsBelow != (sign < 0))
    {
      return;
    }
    const double disc = std::numbers::pi * radius * radius;
    if (sign > 0)
    {
      const Index set = this->setOf(std::uint64_t{ this->Mesh.numberOfVertices() } +
          3 * std::uint64_t{ this->Mesh.numberOfTriangles() } + face,
        0.0);
      this->SetAreas[set] += disc;
      this->addPiece(flat, field.circle(radius),
        { LevelPiece::Node{ NoIndex, face }, LevelPiece::Node{ NoIndex, face } }, set);
      return;
    }
    const Index set = this->setOfVertex(this->Mesh.triangle(face)[0]);
    this->SetAreas[set] -= disc;
    this->addPiece(flat, field.circle(radius),
      { LevelPiece::Node{ NoIndex, face }, LevelPiece::Node{ NoIndex, face } }, set);
  }

  void addPiece(const FlatFace& flat, const FaceField::Arc& arc,
    const std::array<LevelPiece::Node, 2>& ends, Index set)
  {
    LevelPiece piece{ ends, {}, arc.length, set };
    for (const PlanePoint& point : arc.points)
    {
      piece.points.push_back(flat.inSpace(point));
    }
    this->Pieces.push_back(std::move(piece));
  }

  const TriangleMesh& Mesh;
  const EdgeTable& Edges;
  std::span<const double> Values;
  std::vector<Range> Ranges;
  /** For each half-edge. */
  std::vector<bool> IsRound;
  std::vector<Event> Events;
  std::size_t NextEvent = 0;
  std::size_t NextRange = 0;
  /** The ranges that can have the level. */
  std::vector<Index> Active;
  /** The vertices below the level, connected over faces, and the area of whole faces by root. */
  DisjointSets Below;
  std::vector<double> AreaBelow;
  double Level = 0.0;
  std::vector<LevelPiece> Pieces;
  /** What is connected below the level, with the cut faces. */
  std::optional<DisjointSets> Sets;
  std::vector<double> SetAreas;
  std::map<std::uint64_t, Index> SetOfKey;
};

}

std::vector<Isoline> isolines(const TriangleMesh& mesh, const EdgeTable& edges,
  std::span<const double> values, std::span<const double> levels,
  const std::function<bool()>& goesOn)
{
  Tracer tracer(mesh, edges, values);
  std::vector<Isoline> found;
  for (const double level : levels)
  {
    if (!goesOn())
    {
      return {};
    }
    tracer.trace(level, found);
  }
  return found;
}

}
