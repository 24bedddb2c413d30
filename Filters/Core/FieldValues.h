#ifndef geodesic_FieldValues_h
#define geodesic_FieldValues_h

#include "BucketQueue.h"
#include "DistanceField.h"
#include "KnownValues.h"
#include "Lanes.h"
#include "MarchControl.h"
#include "SeedFront.h"
#include "SolveOptions.h"
#include "StopLimit.h"
#include "TriangleMesh.h"
#include "ValueMark.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace geodesic
{

/**
 * No way is shorter than the straight line to where a round front starts. Holding updates to that
 * keeps them monotone, and keeps rounding from growing from update to update where triangles lie on
 * each other over the source: there the update's slope exceeds 1.
 */
class StraightLineBound
{
public:
  StraightLineBound(const Label& label, double smallestCost)
    : Origin(label.position)
    , SquaredCost(label.shape == FrontShape::Round ? smallestCost * smallestCost : 0.0)
  {
  }

  /** @p value, or the bound at @p position where that is more. */
  double raised(double value, const Vector3& position) const
  {
    const Vector3 away = position - this->Origin;
    const double square = this->SquaredCost * dot(away, away);
    return value * value < square ? std::sqrt(square) : value;
  }

private:
  Vector3 Origin;
  double SquaredCost;
};

/** What the values of every label have in common; see RingSweep. */
template <class Cost>
struct MarchContext
{
  const TriangleMesh& mesh;
  const Cost& cost;
  const SolveOptions& options;
  const StopLimit& limit;
  const MarchControl& control;
  DistanceField& field;
  BucketQueue& queue;
  std::span<ValueMark> marks;
};

/**
 * Values of a label, the current one, that the field itself holds: its distances less the value of
 * the seed.
 */
template <class Cost>
class FieldValues
{
public:
  /** The distance of the queue's key 0. */
  double firstDistance() const { return this->First; }
  /** The place in the queue of a value of the current label. */
  double keyOf(double value) const { return value + this->Offset - this->First; }

protected:
  FieldValues(const MarchContext<Cost>& context, double firstDistance)
    : Context(context)
    , First(firstDistance)
    , Marks(context.marks)
    , Distances(context.field.distances())
    , Positions(context.mesh.positions())
  {
  }

  /** @param labelBits as in ValueMark; 0 where there is only one label */
  void setCurrent(Index labelBits, double seedValue)
  {
    this->LabelBits = labelBits;
    this->Offset = seedValue;
  }
  Index labelBits() const { return this->LabelBits; }
  const MarchContext<Cost>& context() const { return this->Context; }
  const Vector3& position(Index vertex) const { return this->Positions[vertex]; }
  ValueMark& mark(Index vertex) { return this->Marks[vertex]; }
  const ValueMark& mark(Index vertex) const { return this->Marks[vertex]; }
  template <class Real>
  GEODESIC_INLINED BitsOf<Real> marks(const Indices<Real>& vertices) const
  {
    return bitsWith<Real>([&](int lane) { return this->Marks[vertices[lane]].bits(); });
  }

  double value(Index vertex) const { return this->Distances[vertex] - this->Offset; }
  KnownValue known(Index vertex) const
  {
    const double value = this->value(vertex);
    return { value, value, this->mark(vertex).isQueued() };
  }

  template <class Real>
  GEODESIC_INLINED Real values(const Indices<Real>& vertices) const
  {
    return lanesOf<Real>([&](int lane) { return this->Distances[vertices[lane]]; }) - this->Offset;
  }

  /** What a value has to be below in order to count where there is @p old. */
  double ceiling(Index vertex, double old) const
  {
    const double counts = old * this->Context.control.keptFraction();
    return this->Context.limit.isNone()
      ? counts
      : std::min(counts, this->Context.limit.with(this->Context.cost.reach(vertex)) - this->Offset);
  }

  /** Gives the field a value, which it takes if that counts; returns what then holds. */
  KnownValue offer(Index vertex, double value)
  {
    const bool isFixed = this->mark(vertex).isPinned() || this->Context.options.isExcluded(vertex);
    if (!isFixed && this->mark(vertex).isQueued())
    {
      const double held = this->lower(vertex, value);
      return { held, held, true };
    }
    if (!isFixed && value < this->ceiling(vertex, this->value(vertex)))
    {
      this->set(vertex, value);
      return { value, value, true };
    }
    return this->known(vertex);
  }

  void set(Index vertex, double value)
  {
    if (this->mark(vertex).isQueued())
    {
      this->Context.field.lowerDistance(vertex, value + this->Offset);
    }
    else
    {
      this->Context.field.setDistance(vertex, value + this->Offset);
      this->mark(vertex).queueFor(this->LabelBits);
      this->Context.queue.push(vertex, this->keyOf(value));
    }
  }

private:
  /** Sets the value of a vertex that is queued, if it counts, and returns what then holds. Whether
   * it does is not to be guessed, so there is no branch on it. */
  double lower(Index vertex, double value)
  {
    const double ceiling = this->ceiling(vertex, this->value(vertex));
    const Pair distance = select(Pair{ value } < Pair{ ceiling }, Pair{ value + this->Offset },
      Pair{ this->Distances[vertex] });
    this->Context.field.lowerDistance(vertex, distance[0]);
    return distance[0] - this->Offset;
  }

  const MarchContext<Cost>& Context;
  double First;
  double Offset = 0.0;
  Index LabelBits = 0;
  std::span<ValueMark> Marks;
  std::span<const double> Distances;
  std::span<const Vector3> Positions;
};

}

#endif
