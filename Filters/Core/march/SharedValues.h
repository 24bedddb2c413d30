// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedValues_h
#define geodesic_SharedValues_h

#include "march/SharedFieldValues.h"

#include <vector>

namespace geodesic
{

/** The values of a march of one label on several threads, for one of them: as OneLabelValues, in a
 * field that all threads share. */
template <class Cost>
class SharedValues : public SharedFieldValues<Cost>
{
public:
  /** @param reached  gets the vertices that this thread gives their first value */
  SharedValues(const MarchContext<Cost>& context, const Label& label, SharedMarch::Share& share,
    std::vector<Index>& reached)
    : SharedFieldValues<Cost>(context, label.value, share, reached)
    , Only(label, 0, context.cost.smallest())
  {
  }

  static constexpr bool hasOtherLabels = false;
  /** The only label. */
  const SourceFront& label() const { return this->Only; }

  /** Reads the values of vertices. */
  class Reader
  {
  public:
    explicit Reader(SharedValues& of)
      : Shared(of)
      , SeedValue(of.Only.seedValue)
    {
    }
    /** Counts only what waits in this thread's queue as waiting: what waits elsewhere may have been
     * taken meanwhile. */
    template <class Real>
    GEODESIC_INLINED BestValues<Real> look(const Indices<Real>& vertices) const
    {
      const Real distances = this->Shared.template distances<Real>(vertices);
      const BitsOf<Real> states = this->Shared.template states<Real>(vertices);
      const BitsOf<Real> others = this->Shared.template others<Real>(vertices);
      return { distances - this->SeedValue, 0, highestBits<Real>(states & ~others) };
    }

  private:
    typename SharedValues::SharedReader Shared;
    double SeedValue;
  };
  Reader reader(const SourceFront&) { return Reader(*this); }

  template <Way way>
  NeighbourValue propose(const SourceFront&, Index vertex, double value)
  {
    value = this->Only.leastOf.raised(value, this->Context.mesh.position(vertex));
    const VertexState state = this->state(vertex);
    const bool isOwn = this->Share.owns(vertex);
    const double old = this->key(vertex);
    const double ceiling = old * this->Context.control.keptFraction();
    if (isOwn && state.isQueuedFor(0))
    {
      // A processor can't predict whether the value counts, so there is no branch on it.
      const Pair held = select(Pair{ value } < Pair{ ceiling }, Pair{ value }, Pair{ old });
      this->setDistance(vertex, held[0] + this->Only.seedValue);
      return { held[0], held[0], true };
    }
    const bool isFixed = !(Cost::isUnit && way == Way::Along) && state.isFinal();
    if (!(value < ceiling) || isFixed || this->Context.options.isExcluded(vertex))
    {
      return { old, old, isOwn && state.isQueued() };
    }
    if (!isOwn)
    {
      this->Share.send(vertex, 0, value);
      return { old, old, false };
    }
    this->set(vertex, state, value);
    return { value, value, true };
  }

  /** Gives a vertex a value that another thread sent. */
  void lower(Index vertex, Index, double value)
  {
    this->template propose<Way::Along>(this->Only, vertex, value);
  }

  PoppedValue pop(Index item)
  {
    const Index vertex = this->take(item);
    return { vertex, &this->Only, this->key(vertex) };
  }

private:
  /** Stores a value of a vertex that this thread owns, and queues the vertex. */
  void set(Index vertex, VertexState state, double value)
  {
    this->setAnyDistance(vertex, value + this->Only.seedValue);
    if (!state.isQueued())
    {
      state.setQueued(true);
      this->setState(vertex, state);
      this->queue(vertex, value);
    }
  }

  SourceFront Only;
};

}

#endif
