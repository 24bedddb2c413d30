// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LabelBounds_h
#define geodesic_LabelBounds_h

#include "base/Index.h"
#include "base/Platform.h"
#include "march/LabelReach.h"
#include "march/SourceFront.h"
#include "solve/DistanceField.h"
#include "solve/SeedFront.h"
#include "solve/StartValue.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

class Partition;
class TriangleMesh;

/**
 * Whether no front goes on from its starts, as in triangles that hang together with no other: the
 * starts are final, labels have few of them, and each neighbour of a start has one of the same
 * label, to which no way along the edge is shorter. It is mostly told by the first start where
 * fronts go on. Collective. @param starts  sorted by label
 */
bool areSettled(const TriangleMesh& mesh, std::span<const StartValue> starts, Partition& partition);

/**
 * Bounds of the values that count in a march of several labels.
 *
 * A vertex keeps the values of all labels within a margin of its least one (see labelMargin()).
 * Where labels are dense (see labelsAreDense()), those are many. Where costs jump (see VertexCost),
 * the order of the march decides which ones those are: as long as the least value is missing a
 * farther label is kept, and may go on to a dear vertex where it is the least one. So in both cases
 * a value counts only if it is neither above the bound of its vertex nor above the one of its
 * label. All bounds are fixed before the march, so the field does not depend on its order; a
 * check() after it may raise some, and it goes on (see HigherBounds.h).
 *
 * The bound of a vertex is its distance in a *first march*, in which all labels together are one
 * straight front, and an excess(); values a little above the least one are needed near borders. Or
 * it is made of straight lines, see LineBounds. Where costs jump the excess is the margin, and
 * labels have no bounds. For dense labels it is less, and the bounds of labels are from
 * labelReaches(); distances of those that last may exceed bounds of vertices by an allowance.
 * Beside a single point the straight front is too slow: in a step of a height h it loses c² / 8 h d
 * at a distance d, with sides of length c, which grows to some c² / 8 h times the logarithm of the
 * distance. On rough surfaces it differs from round fronts by a part of the distance.
 */
class LabelBounds
{
public:
  /** How much a distance that counts may exceed the least one where labels are dense. Near the
   * seeds it grows with the distance, as labels end there in whose place others are farther; beyond
   * that the first march is the slower one (see above). @param reach  of the vertex, see
   * UnitCost::reach() @param distance  the least one, less the seeds' value */
  static double excess(double reach, double distance)
  {
    return std::min(0.12 * reach + 0.01 * distance, 0.3 * reach);
  }
  /** The same at a start of labels that compete, see labelsCompeteInTriangles(). */
  static double excessAtStart(double reach) { return 0.5 * reach; }

  /**
   * Prepares a first march: sets its starts. Collective.
   * @param starts  those of all labels; final values of a vertex stay as they are
   */
  void begin(const TriangleMesh& mesh, std::span<const Label> labels,
    std::span<const StartValue> starts, Partition& partition);
  /** For each vertex with starts the least one, as a distance of label 0. */
  std::span<const StartValue> starts() const { return this->Starts; }
  /** Whether no front passes any vertex that has a start, as where all vertices are seeds.
   * Collective. */
  bool areAllInside(Partition& partition) const;

  /** Whether a label starts at a vertex. */
  bool hasStart(Index vertex) const { return this->PlaceOfStart[vertex] != NoIndex; }

  /**
   * Takes over the field of the first march, and sets the bounds.
   * @param ofLabels  bounds of labels, see labelReaches()
   * @param excessOf  tells of a vertex how much more than its distance counts; nothing where none
   *                  but the least distance does, for any label
   */
  template <class ExcessOf>
  void take(const DistanceField& first, std::vector<LabelReach> ofLabels, const ExcessOf& excessOf)
  {
    this->OfLabels = std::move(ofLabels);
    this->Reached.assign(first.reached().begin(), first.reached().end());
    this->First.resize(first.distances().size(), DistanceField::Unreached);
    this->OfVertices.resize(first.distances().size(), DistanceField::Unreached);
    for (const Index vertex : this->Reached)
    {
      const double distance = first.distance(vertex);
      this->First[vertex] = distance;
      this->notePassed(vertex, distance);
      if (const std::optional<double> excess = excessOf(vertex); this->isInside(vertex) || !excess)
      {
        this->OfVertices[vertex] = -(this->isInside(vertex) ? distance : Rounding * distance);
      }
      else
      {
        this->OfVertices[vertex] = distance + *excess;
      }
    }
  }

  /** Begins with bounds of vertices alone, without a first march: those of addBlock(). */
  void startBlocks(std::size_t vertices, std::size_t labels);
  /** Adds vertices with numbers from @p first on. @return their bounds, to be set */
  std::span<double> addBlock(Index first, std::size_t count)
  {
    this->Blocks.push_back({ first, first + static_cast<Index>(count) });
    return std::span(this->OfVertices).subspan(first, count);
  }
  /** Numbers of vertices: the first one, and the one behind the last. */
  struct Block
  {
    Index begin;
    Index end;
  };
  std::span<const Block> blocks() const { return this->Blocks; }
  /** Sets a bound anew. */
  void setOfVertex(Index vertex, double bound) { this->OfVertices[vertex] = bound; }
  void setOfLabels(std::vector<LabelReach> bounds) { this->OfLabels = std::move(bounds); }
  /** After startBlocks(): notes the distance that a vertex has in a first march of a part. */
  void setFirst(Index vertex, double distance)
  {
    this->First.resize(this->OfVertices.size(), DistanceField::Unreached);
    this->First[vertex] = distance;
    this->Reached.push_back(vertex);
  }

  /** What a check of the bounds after a march has found. */
  enum class Check
  {
    /** None was too low. */
    Passed,
    /** Some were; the march is to go on, or to be made again, with higher ones. */
    Raised,
    Cancelled
  };
  /** A check that raises bounds. It gets the vertices whose values may now go on. */
  using Checking = std::function<Check(const DistanceField& field, std::vector<Index>& beside)>;
  /** Sets what check() is to do. */
  void setChecking(Checking checking) { this->Checks = std::move(checking); }
  /** To be called after a march, when its queues are empty. The first time after setChecking() it
   * is checked; bounds pass that were checked, or are not to be. Collective. */
  Check check(const DistanceField& field, std::vector<Index>& beside)
  {
    const Checking checking = std::exchange(this->Checks, nullptr);
    return checking ? checking(field, beside) : Check::Passed;
  }

  /** The largest distance of a label that counts at a vertex, with the value of the label's seed.
   * @param allowance  of the label, see allowanceOf() */
  double ofVertex(Index vertex, double allowance = 0.0) const
  {
    const double bound = this->OfVertices[vertex];
    return std::signbit(bound) ? -bound : bound + allowance;
  }
  /** Has the processor fetch what ofVertex() reads. */
  GEODESIC_INLINED void prefetch(Index vertex) const { prefetchToRead(&this->OfVertices[vertex]); }
  /** The largest value of a label that counts at a vertex, without the value of its seed. */
  double of(const SourceFront& label, Index vertex) const
  {
    return std::min(this->ofVertex(vertex, label.allowance) - label.seedValue, label.reach);
  }
  /** The largest value of a label that counts, without the value of its seed. */
  double ofLabel(Index label) const { return this->OfLabels[label].value; }
  /** By how much a distance of a label that counts may exceed the bound of its vertex. */
  double allowanceOf(Index label) const { return this->OfLabels[label].allowance; }

  /** The vertices that the first march reached, and their distances in it. */
  std::span<const Index> reached() const { return this->Reached; }
  double first(Index vertex) const { return this->First[vertex]; }
  bool isReached(Index vertex) const
  {
    return vertex < this->First.size() && this->First[vertex] < DistanceField::Unreached;
  }

  /**
   * The starts of a march within the bounds, first those that count. A final one above the bound of
   * its vertex becomes +infinity, which keeps updates from giving its vertex another value of the
   * label; this holds where another label has a start that counts. Idle are those from which no
   * update counts.
   * @param goesOn  called for each few thousand starts; when it returns false this ends, without
   *                any start
   */
  std::span<const StartValue> within(const TriangleMesh& mesh, std::span<const Label> labels,
    std::span<const StartValue> starts, const std::function<bool()>& goesOn);

  /** Whether the nearest label of a vertex may end before a neighbour. @param farthest  the value
   * that the label may have there */
  bool mayEnd(Index label, double farthest) const { return farthest > this->ofLabel(label); }
  /** To be called for such a vertex after the march within the bounds, and for others that may
   * lower a neighbour along an edge. */
  void noteAtEnd(Index vertex) { this->AtEnds.push_back(vertex); }
  /** The vertices that were noted. */
  std::span<const Index> atEnds() const { return this->AtEnds; }

  /** Removes all bounds, in a time that depends on how many vertices were reached. */
  void clear();

private:
  /** Distances that differ by no more than this factor are the same. */
  static constexpr double Rounding = 1.0 + 1e-9;

  /** Adds a start of all labels together; the least one of a vertex counts. */
  void addStart(const StartValue& start);
  /** Sorts Starts by vertex, as neighbours are near each other in memory then. */
  void sortStarts();
  /** Whether enough of the vertices of all pieces have a start that some may be inside. Collective.
   */
  bool haveManyStarts(const TriangleMesh& mesh, Partition& partition) const;

  /** Notes that a vertex is not inside if a front came to it along edges from elsewhere, as on
   * needles. @param distance  in the first march */
  void notePassed(Index vertex, double distance)
  {
    if (this->isInside(vertex) && distance < this->Starts[this->PlaceOfStart[vertex]].value)
    {
      this->AreInside[vertex] = 0;
    }
  }

  /** Whether a vertex and all its neighbours have final starts, and the vertex the least one: no
   * front passes it. */
  bool isInside(Index vertex) const
  {
    return !this->AreInside.empty() && this->AreInside[vertex] != 0;
  }

  std::vector<StartValue> Starts;
  /** What within() returned last. */
  std::vector<StartValue> Within;
  /** For each vertex the place of its start in Starts, or NoIndex. */
  std::vector<Index> PlaceOfStart;
  /** Empty if there are few starts. */
  std::vector<std::uint8_t> AreInside;
  std::vector<Index> Reached;
  std::vector<double> First;
  /** Negative where no label has an allowance. */
  std::vector<double> OfVertices;
  std::vector<Block> Blocks;
  std::vector<LabelReach> OfLabels;
  std::vector<Index> AtEnds;
  Checking Checks;
};

}

#endif
