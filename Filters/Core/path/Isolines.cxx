// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/Isolines.h"

#include "base/DisjointSets.h"
#include "base/Interruption.h"
#include "path/ByLevel.h"
#include "path/EdgeFields.h"
#include "path/FaceField.h"
#include "path/FlatFace.h"
#include "path/IsolineJoining.h"
#include "path/SurfaceField.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

namespace geodesic
{
namespace
{

class Tracer
{
public:
  /** @param levels in increasing order; kept */
  Tracer(const SurfaceField& field, std::span<const double> levels)
    : Field(field)
    , Mesh(field.mesh)
    , Values(field.values)
    , Faces(facesOf(field))
    , Edges(field, Faces)
    , Levels(levels)
    , Ranges(levels)
    , Events(levels)
    , Below(field.mesh.numberOfVertices())
    , AreaBelow(field.mesh.numberOfVertices(), 0.0)
  {
    this->findRanges();
    this->findEvents();
  }

  /** To be called for each level in turn. */
  void trace(std::size_t number, std::vector<Isoline>& isolines)
  {
    const double level = this->Levels[number];
    this->Level = level;
    this->raise(number);
    this->Pieces.clear();
    this->Sets.emplace(0);
    this->SetAreas.clear();
    this->HasSource.clear();
    this->SetOfKey.clear();
    for (std::size_t i = 0; i < this->Active.size(); ++i)
    {
      Interruption::checkAt(i);
      this->cut(this->Active[i].face);
    }
    this->leaveOutGhosts();
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
  /** The levels up to @p high may cross a face. */
  struct Range
  {
    double high;
    Index face;
  };
  /** Two or three corners of a face are below the level. */
  struct Event
  {
    Index face;
    bool isWhole;
  };

  static std::vector<Index> facesOf(const SurfaceField& field)
  {
    std::vector<Index> faces;
    for (Index face = 0; face < field.mesh.numberOfTriangles(); ++face)
    {
      Interruption::checkAt(face);
      if (field.hasField(face))
      {
        faces.push_back(face);
      }
    }
    return faces;
  }

  void findRanges()
  {
    for (std::size_t i = 0; i < this->Faces.size(); ++i)
    {
      Interruption::checkAt(i);
      const Index face = this->Faces[i];
      const auto values = this->Field.valuesOf(face);
      const auto [least, most] = std::minmax_element(values.begin(), values.end());
      // A distance can be nearer to 0 inside of the face than at each corner.
      const double low = *least > 0.0 ? 0.0 : *least;
      const double high = *most < 0.0 ? 0.0 : *most;
      double cost = 0.0;
      for (Index h = 3 * face; h < 3 * face + 3; ++h)
      {
        cost = std::max(cost, this->Edges.cost(h));
      }
      const double size = cost * this->Mesh.longestEdgeAround(this->Mesh.triangle(face)[0]);
      const std::size_t first = this->Ranges.firstAbove(std::max(low, *least - size));
      const double last = std::min(high, *most + size);
      if (first < this->Levels.size() && this->Levels[first] <= last)
      {
        this->Ranges.add(first, { last, face });
      }
    }
    this->Ranges.order();
  }

  void findEvents()
  {
    for (std::size_t i = 0; i < this->Faces.size(); ++i)
    {
      Interruption::checkAt(i);
      auto values = this->Field.valuesOf(this->Faces[i]);
      std::sort(values.begin(), values.end());
      for (const bool isWhole : { false, true })
      {
        const std::size_t first = this->Events.firstAbove(values[isWhole ? 2 : 1]);
        if (first < this->Levels.size())
        {
          this->Events.add(first, { this->Faces[i], isWhole });
        }
      }
    }
    this->Events.order();
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
  void raise(std::size_t number)
  {
    const std::span<const Event> events = this->Events.of(number);
    for (std::size_t i = 0; i < events.size(); ++i)
    {
      Interruption::checkAt(i);
      const Event& event = events[i];
      Triangle t = this->Mesh.triangle(event.face);
      std::sort(
        t.begin(), t.end(), [&](Index a, Index b) { return this->Values[a] < this->Values[b]; });
      this->connect(t[0], t[event.isWhole ? 2 : 1]);
      if (event.isWhole)
      {
        this->AreaBelow[this->Below.rootOf(t[0])] += this->Field.areaOf(event.face);
      }
    }
    const std::span<const Range> ranges = this->Ranges.of(number);
    this->Active.insert(this->Active.end(), ranges.begin(), ranges.end());
    std::erase_if(this->Active, [&](const Range& range) { return range.high < this->Level; });
  }

  /** The set of a vertex below the level, or of what an edge or a face has below it.
   * @param hasSource whether a front can come from there */
  Index setOf(std::uint64_t key, double area, bool hasSource)
  {
    const auto [found, isNew] = this->SetOfKey.emplace(key, NoIndex);
    if (isNew)
    {
      found->second = this->Sets->add();
      this->SetAreas.push_back(area);
      this->HasSource.push_back(hasSource);
    }
    return found->second;
  }
  Index setOfVertex(Index vertex)
  {
    const Index root = this->Below.rootOf(vertex);
    return this->setOf(root, this->AreaBelow[root], true);
  }
  /** Of the part between the two places where an edge has the level. */
  Index setOfEdge(Index edge)
  {
    return this->setOf(
      std::uint64_t{ this->Mesh.numberOfVertices() } + edge, 0.0, this->Edges.hasSource(edge));
  }
  Index setOfFace(Index face)
  {
    return this->setOf(std::uint64_t{ this->Mesh.numberOfVertices() } +
        3 * std::uint64_t{ this->Mesh.numberOfTriangles() } + face,
      0.0, true);
  }

  /**
   * Takes away pieces round parts that are nearer than the level between vertices that are all
   * farther, if there is no source in them. Where fronts meet the model of an edge can have a
   * source that does not exist.
   */
  void leaveOutGhosts()
  {
    std::vector<bool> hasSource(this->HasSource.size(), false);
    for (Index set = 0; set < hasSource.size(); ++set)
    {
      if (this->HasSource[set])
      {
        hasSource[this->Sets->rootOf(set)] = true;
      }
    }
    std::erase_if(this->Pieces,
      [&](const LevelPiece& piece) { return !hasSource[this->Sets->rootOf(piece.nearSet)]; });
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
      const Index a = this->Field.endsOf(halfEdge).first;
      const std::vector<double> places = this->Edges.places(halfEdge, this->Level);
      std::vector<Crossing> ofSide;
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        const double along = t[c] == a ? places[i] : 1.0 - places[i];
        const PlanePoint& from = flat.corners[c];
        const PlanePoint& to = flat.corners[(c + 1) % 3];
        ofSide.push_back({ { this->Field.edgeOf(halfEdge), static_cast<Index>(i) },
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
    const FlatFace flat = this->Field.flat(face);
    const std::vector<Crossing> crossings = this->crossingsOf(face, flat);
    const int sign = this->Field.signOfFace(face);
    const FaceField field = this->Field.inFace(face, flat);
    if (crossings.empty())
    {
      this->addCircle(face, flat, field, sign);
      return;
    }
    const Triangle& t = this->Mesh.triangle(face);
    const auto values = this->Field.valuesOf(face);
    // Where the distance is less than the level's, which is convex.
    const bool nearIsBelow = sign >= 0;
    const Index nearSet = this->setOfNear(face, field, nearIsBelow, crossings);
    double near = field.area();
    const std::size_t count = crossings.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      // The border between crossings i and i + 1; at corner 0 it begins with that corner's state.
      const bool isBelow = (i % 2 == 0) != (values[0] < this->Level);
      if (isBelow == nearIsBelow)
      {
        continue;
      }
      const Crossing& from = crossings[i];
      const Crossing& to = crossings[(i + 1) % count];
      const FaceField::Arc arc = sign == 0 ? FaceField::Arc{ { from.place, to.place },
        std::hypot(to.place.x - from.place.x, to.place.y - from.place.y), 0.0 }
                                           : field.arc(from.place, to.place, sign * this->Level);
      const double far = this->areaBeside(flat, from, to, i + 1 == count) - arc.segment;
      near -= far;
      // What is far between two places of the border has corners, so it is below by one of these.
      const Index set = nearIsBelow ? nearSet : this->setOfVertex(t[(from.corner + 1) % 3]);
      if (!nearIsBelow)
      {
        this->SetAreas[set] += far;
      }
      this->addPiece(flat, arc, { from.node, to.node }, set, nearSet);
    }
    if (nearIsBelow)
    {
      this->SetAreas[nearSet] += near;
    }
    else if (*std::max_element(values.begin(), values.end()) < this->Level)
    {
      // It counts as a whole face below the level already.
      this->SetAreas[this->setOfVertex(t[0])] -= field.area();
    }
  }

  /** The set of the part of a cut face that is nearer than the level. On the minus side that is
   * above the level, where vertices have no sets. */
  Index setOfNear(
    Index face, const FaceField& field, bool nearIsBelow, const std::vector<Crossing>& crossings)
  {
    Index set = NoIndex;
    const auto unite = [&](Index other)
    { set = set == NoIndex ? other : this->Sets->connect(set, other).first; };
    for (const Index corner : this->Mesh.triangle(face))
    {
      if (nearIsBelow && this->Values[corner] < this->Level)
      {
        unite(this->setOfVertex(corner));
      }
      else if (!nearIsBelow && !(this->Values[corner] < this->Level))
      {
        unite(this->setOfFace(face));
      }
    }
    for (const Crossing& crossing : crossings)
    {
      // Two crossings of a side with a near part between them.
      if (crossing.node.second == 1)
      {
        unite(this->setOfEdge(crossing.node.first));
      }
    }
    if (field.hasSource())
    {
      unite(this->setOfFace(face));
    }
    return set;
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
    const bool firstIsBelow = this->Field.valuesOf(face)[0] < this->Level;
    const double level = sign * this->Level;
    if (sign == 0 || !field.hasSource() || !(level > 0.0) || firstIsBelow != (sign < 0))
    {
      return;
    }
    const FaceField::Arc circle = field.circle(level);
    const double disc = circle.segment;
    const std::array ends{ LevelPiece::Node{ NoIndex, face }, LevelPiece::Node{ NoIndex, face } };
    const Index near = this->setOfFace(face);
    const Index set = sign > 0 ? near : this->setOfVertex(this->Mesh.triangle(face)[0]);
    this->SetAreas[set] += sign * disc;
    this->addPiece(flat, circle, ends, set, near);
  }

  void addPiece(const FlatFace& flat, const FaceField::Arc& arc,
    const std::array<LevelPiece::Node, 2>& ends, Index set, Index nearSet)
  {
    LevelPiece piece{ ends, {}, arc.length, set, nearSet };
    for (const PlanePoint& point : arc.points)
    {
      piece.points.push_back(flat.inSpace(point));
    }
    this->Pieces.push_back(std::move(piece));
  }

  SurfaceField Field;
  const TriangleMesh& Mesh;
  std::span<const double> Values;
  /** Those that have a field. */
  std::vector<Index> Faces;
  EdgeFields Edges;
  std::span<const double> Levels;
  ByLevel<Range> Ranges;
  ByLevel<Event> Events;
  /** The ranges that can have the level. */
  std::vector<Range> Active;
  /** The vertices below the level, connected over faces, and the area of whole faces by root. */
  DisjointSets Below;
  std::vector<double> AreaBelow;
  double Level = 0.0;
  std::vector<LevelPiece> Pieces;
  /** What is connected below the level, with the cut faces. */
  std::optional<DisjointSets> Sets;
  std::vector<double> SetAreas;
  std::vector<bool> HasSource;
  std::map<std::uint64_t, Index> SetOfKey;
};

}

std::vector<Isoline> isolines(const TriangleMesh& mesh, const EdgeTable& edges,
  std::span<const double> values, std::span<const double> cost, std::span<const double> levels,
  const std::function<bool()>& goesOn)
{
  Tracer tracer({ mesh, edges, values, cost }, levels);
  std::vector<Isoline> found;
  for (std::size_t level = 0; level < levels.size(); ++level)
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
