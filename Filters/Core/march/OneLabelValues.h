// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_OneLabelValues_h
#define geodesic_OneLabelValues_h

#include "march/FieldValues.h"
#include "solve/MarchingFront.h"
#include "solve/StartValue.h"

namespace geodesic
{

/** The values of a march of one label: the distances in the field less the value of the seed.
 * LabelValues explains the functions. */
template <class Cost>
class OneLabelValues : public FieldValues<Cost>
{
public:
  OneLabelValues(const MarchContext<Cost>& context, const Label& label)
    : FieldValues<Cost>(context, label.value)
    , Only(label, 0, context.cost.smallest())
    , Seed(label.seed)
  {
    this->Only.group = 0;
  }

  static constexpr bool hasOtherLabels = false;
  /** The only label. */
  const SourceFront& label() const { return this->Only; }
  const SourceFront& enter(Index, Index) const { return this->Only; }

  /** Reads the values of vertices. */
  class Reader
  {
  public:
    explicit Reader(const FieldReader& field)
      : Field(field)
    {
    }
    template <class Real>
    GEODESIC_INLINED BestValues<Real> look(const Indices<Real>& vertices) const
    {
      return { this->Field.template values<Real>(vertices), 0,
        highestBits<Real>(this->Field.template states<Real>(vertices)) };
    }

  private:
    FieldReader Field;
  };
  Reader reader(const SourceFront&) const { return Reader(this->fieldReader(this->Only)); }

  /** What a vertex has. */
  NeighbourValue known(Index vertex) const
  {
    const double value = this->value(this->Only, vertex);
    return { value, value, this->state(vertex).isQueued() };
  }

  template <Way way>
  NeighbourValue propose(const SourceFront&, Index vertex, double value)
  {
    value = this->Only.leastOf.raised(value, this->position(vertex));
    return this->state(vertex).isQueuedFor(0)
      ? this->lower(this->Only, vertex, value)
      : this->template offer<way>(this->Only, vertex, value);
  }

  void start(const SourceFront&, const StartValue& first) { this->setFirst(this->Only, first); }

  std::size_t numberOfValues() const { return this->context().field.reached().size(); }
  Index vertexOf(Index taken) const { return taken; }
  GEODESIC_INLINED void prefetch(Index taken) const { this->prefetchRing(taken); }
  bool isWaiting(Index vertex) const { return this->state(vertex).isQueued(); }
  PoppedValue pop(Index vertex)
  {
    if (this->mayBeQueuedAgain() && !this->state(vertex).isQueued())
    {
      return { NoIndex, nullptr, 0.0 };
    }
    this->state(vertex).setQueued(false);
    return { vertex, &this->Only, this->value(this->Only, vertex) };
  }

  void visit(Index vertex, const MarchingFront::Visit& visit) const
  {
    if (this->context().field.isReached(vertex))
    {
      visit(0, this->value(this->Only, vertex));
    }
  }

  /** Sets the nearest seed in the field, and removes all vertex states. */
  void finish()
  {
    this->context().field.setNearestSeed(this->Seed);
    this->context().field.fillReached(this->context().states, VertexState());
  }

private:
  SourceFront Only;
  Index Seed;
};

}

#endif
