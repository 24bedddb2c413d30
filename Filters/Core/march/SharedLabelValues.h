// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedLabelValues_h
#define geodesic_SharedLabelValues_h

#include "march/SharedFieldValues.h"

#include <span>
#include <vector>

namespace geodesic
{

/**
 * The best values of a march of several labels on several threads, for one of them: as LabelValues,
 * but a vertex keeps its best value only, and what is not lower is lost. Where two labels meet a
 * march of LabelValues must go on from all vertices beside those of another label, and from those
 * that are *held*: they get no value here, as they have what would be lost, secondary values or
 * those of the start.
 *
 * Other threads read a value and its label while their owner writes them. The distance of a vertex
 * only falls, whatever its label. So the owner writes the label first, and others read the distance
 * first: then the distance that they take for the label's is never below it.
 */
template <class Cost>
class SharedLabelValues : public SharedFieldValues<Cost>
{
public:
  /**
   * @param fronts  by the number of the label
   * @param firstDistance  the distance of the queue's key 0
   * @param reached  gets the vertices that this thread gives their first value
   */
  SharedLabelValues(const MarchContext<Cost>& context, std::span<const SourceFront> fronts,
    double firstDistance, SharedMarch::Share& share, std::vector<Index>& reached)
    : SharedFieldValues<Cost>(context, firstDistance, share, reached)
    , Fronts(fronts)
  {
  }

  static constexpr bool hasOtherLabels = true;
  bool hasBounds() const { return false; }

  /** Reads the best values of vertices, for an update for one label. */
  class Reader
  {
  public:
    Reader(SharedLabelValues& of, const SourceFront& label)
      : Shared(of)
      , SeedValue(label.seedValue)
      , LabelBits(label.labelBits)
    {
    }
    template <class Real>
    GEODESIC_INLINED BestValues<Real> look(const Indices<Real>& vertices) const
    {
      constexpr unsigned all = (1u << lanes<Real>)-1;
      const Real distances = this->Shared.template distances<Real>(vertices);
      keepSharedInOrder();
      const BitsOf<Real> states = this->Shared.template states<Real>(vertices);
      const BitsOf<Real> labels = states & VertexState::LabelBits;
      const unsigned areOwn = highestBits<Real>((labels == 0) | (labels == this->LabelBits));
      const BitsOf<Real> others = this->Shared.template others<Real>(vertices);
      return { distances - this->SeedValue, areOwn ^ all,
        areOwn & highestBits<Real>(states & ~others) };
    }

  private:
    typename SharedLabelValues::SharedReader Shared;
    double SeedValue;
    Index LabelBits;
  };
  Reader reader(const SourceFront& label) { return Reader(*this, label); }

  void prefetchOther(Index) const {}
  /** What a label has at vertices whose best value is of another label: nothing, and only lower
   * values count. */
  template <class Real>
  GEODESIC_INLINED NeighbourValues<Real> others(
    const Indices<Real>&, unsigned, const SourceFront&, const Real& best) const
  {
    return { Real() + DistanceField::Unreached, best, 0 };
  }

  template <Way way>
  NeighbourValue propose(const SourceFront& label, Index vertex, double value)
  {
    value = label.leastOf.raised(value, this->Context.mesh.position(vertex));
    const double old = this->distance(vertex) - label.seedValue;
    keepSharedInOrder();
    VertexState state = this->state(vertex);
    const bool isOther = state.hasOtherLabel(label.labelBits);
    const bool isOwn = this->Share.owns(vertex);
    const NeighbourValue known{ isOther ? DistanceField::Unreached : old, old,
      isOwn && !isOther && state.isQueued() };
    const double ceiling = isOther ? old : old * this->Context.control.keptFraction();
    const bool isFixed = !isOther && !(Cost::isUnit && way == Way::Along) && state.isFinal();
    if (!(value < ceiling) || isFixed || state.isHeld() || this->Context.options.isExcluded(vertex))
    {
      return known;
    }
    if (!isOwn)
    {
      this->Share.send(vertex, label.number(), value + label.seedValue - this->FirstDistance);
      return known;
    }
    const bool wasQueued = state.isQueued();
    state.setLabel(label.number());
    state.setQueued(true);
    if (isOther)
    {
      state.setFinal(false);
    }
    this->setState(vertex, state);
    keepSharedInOrder();
    this->setAnyDistance(vertex, value + label.seedValue);
    if (!wasQueued)
    {
      this->queue(vertex, this->key(vertex));
    }
    return { value, value, true };
  }

  /** Gives a vertex a value of a label that another thread sent, as a key of the queue. */
  void lower(Index vertex, Index label, double key)
  {
    const SourceFront& front = this->Fronts[label];
    this->template propose<Way::Along>(front, vertex, key + this->FirstDistance - front.seedValue);
  }

  PoppedValue pop(Index item)
  {
    const Index vertex = this->take(item);
    const double distance = this->distance(vertex);
    keepSharedInOrder();
    const SourceFront& label = this->Fronts[this->state(vertex).label()];
    return { vertex, &label, distance - label.seedValue };
  }

private:
  std::span<const SourceFront> Fronts;
};

}

#endif
