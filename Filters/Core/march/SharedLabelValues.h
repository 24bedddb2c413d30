// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedLabelValues_h
#define geodesic_SharedLabelValues_h

#include "march/LabelBounds.h"
#include "march/SharedFieldValues.h"
#include "march/SharedSecondaryValues.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

/**
 * The values of a march of several labels on several threads, for one of them: as LabelValues, with
 * the same items in the queues. LabelValues explains the functions.
 *
 * Other threads read a value and its label while their owner writes them. Whatever has a place at a
 * vertex, the distance there only falls. So the owner writes the label first, and others read the
 * distance first: then the distance that they take for the label's is never below it. When a
 * secondary value becomes the best one, the best one is written to the place of the secondary one
 * before. So what does not change is always found, and what changes is popped, which others are
 * told of (see SharedMarch).
 */
template <class Cost>
class SharedLabelValues : public SharedFieldValues<Cost>
{
public:
  using Secondary = SharedSecondaryValues::SecondaryValue;

  /** A mesh must have fewer vertices: the best value of each and MostOthers + 2 secondary ones are
   * items of a queue. */
  static constexpr Index MostVertices =
    SharedFieldValues<Cost>::Notice / (SharedSecondaryValues::MostOthers + 3);

  /**
   * @param fronts  by the number of the label
   * @param bounds  see LabelValues
   * @param firstDistance  the distance of the queue's key 0
   * @param reached  gets the vertices that this thread gives their first value
   */
  SharedLabelValues(const MarchContext<Cost>& context, std::span<const SourceFront> fronts,
    SharedSecondaryValues& sets, const LabelBounds* bounds, double firstDistance,
    SharedMarch::Share& share, std::vector<Index>& reached)
    : SharedFieldValues<Cost>(context, firstDistance, share, reached)
    , Fronts(fronts)
    , Sets(sets)
    , Bounds(bounds)
    , NumberOfVertices(context.mesh.numberOfVertices())
  {
  }

  static constexpr bool hasOtherLabels = true;

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
      keepSharedInOrder();
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

  GEODESIC_INLINED void prefetchBound(Index vertex) const
  {
    if (this->Bounds)
    {
      this->Bounds->prefetch(vertex);
    }
  }

  GEODESIC_INLINED void prefetchOther(Index vertex) const
  {
    prefetchToRead(&this->Sets.inPlace(vertex));
    this->Context.cost.prefetchMargin(vertex);
    this->prefetchBound(vertex);
  }

  template <class Real>
  GEODESIC_INLINED NeighbourValues<Real> others(const Indices<Real>& vertices, unsigned areOther,
    const SourceFront& label, const Real& best) const
  {
    const auto inPlace = [&](int lane) -> const Secondary&
    { return this->Sets.inPlace(vertices[lane]); };
    const Real distances =
      sharedLanesOf<Real>([&](int lane) -> const double& { return inPlace(lane).distance; });
    keepSharedInOrder();
    const BitsOf<Real> states =
      sharedBitsWith<Real>([&](int lane) -> const VertexState& { return inPlace(lane).state; });
    const BitsTestOf<Real> areInPlace = (states & VertexState::LabelBits) == label.labelBits;
    const BitsTestOf<Real> areLast =
      bitsWith<Real>([&](int lane) { return SharedSecondaryValues::nextOf(inPlace(lane)); }) ==
      NoIndex;
    const Real values = select(
      widened<Real>(areInPlace), distances - label.seedValue, Real() + DistanceField::Unreached);
    const Real keptUpTo = this->Bounds
      ? lanesOf<Real>([&](int lane) { return this->Bounds->of(label, vertices[lane]); })
      : best + lanesOf<Real>([&](int lane) { return this->Context.cost.margin(vertices[lane]); });
    NeighbourValues<Real> known{ values, least(values, keptUpTo),
      highestBits<Real>(areInPlace) & highestBits<Real>(states) };
    unsigned inChain = areOther & ~highestBits<Real>(areInPlace | areLast);
    for (; inChain != 0; inChain &= inChain - 1)
    {
      const int lane = std::countr_zero(inChain);
      const NeighbourValue secondary =
        this->knownSecondary(label, this->Sets.find(vertices[lane], label.number()), keptUpTo[lane])
          .held;
      known.values[lane] = secondary.value;
      known.ceilings[lane] = secondary.ceiling;
      known.areQueued |= static_cast<unsigned>(secondary.isQueued) << lane;
    }
    known.areQueued &= this->ownOf<Real>(vertices);
    return known;
  }

  template <Way way>
  NeighbourValue propose(const SourceFront& label, Index vertex, double value)
  {
    value = label.leastOf.raised(value, this->Context.mesh.position(vertex));
    if (!this->Share.owns(vertex)) [[unlikely]]
    {
      return this->template proposeToOther<way>(label, vertex, value);
    }
    const double old = this->distance(vertex) - label.seedValue;
    const double ceiling = old * this->Context.control.keptFraction();
    const VertexState state = this->state(vertex);
    if (state.isQueuedFor(label.labelBits))
    {
      // A processor can't predict whether the value counts, so there is no branch on it.
      const Pair held = select(Pair{ value } < Pair{ ceiling }, Pair{ value }, Pair{ old });
      this->setDistance(vertex, label.distance(held[0]));
      return { held[0], held[0], true };
    }
    if (state.hasOtherLabel(label.labelBits)) [[unlikely]]
    {
      return this->template proposeSecondary<way>(label, vertex, value);
    }
    if (!(value < ceiling) || isFixed<Cost, way>(state) ||
      this->Context.options.isExcluded(vertex) || this->isBeyondBounds(label, vertex, value))
    {
      return { old, old, state.isQueued() };
    }
    this->setBest(label, vertex, value);
    return { value, value, true };
  }

  bool hasBounds() const { return this->Bounds != nullptr; }

  /** How many values vertices have, or have had; those of other threads as far as is known. */
  std::size_t numberOfValues() const
  {
    return this->Share.valuesOfOthers() + this->numberOfOwnValues();
  }
  /** How many of them this thread gave to them. */
  std::size_t numberOfOwnValues() const { return this->numberOfReached() + this->Block.added(); }

  Index vertexOf(Index item) const
  {
    if (this->isNotice(item)) [[unlikely]]
    {
      return this->noticed(item).vertex;
    }
    return item < this->NumberOfVertices ? item
                                         : this->Sets.vertexOf(item - this->NumberOfVertices);
  }
  GEODESIC_INLINED void prefetch(Index item) const
  {
    const Index vertex = this->vertexOf(item);
    this->prefetchRing(vertex);
    prefetchToRead(&this->Context.states[vertex]);
  }
  /** In the order of buckets, that of threads, all items are handed out. */
  bool isWaiting(Index) const { return true; }
  PoppedValue pop(Index item)
  {
    this->noteBorder();
    if (this->isNotice(item)) [[unlikely]]
    {
      return this->popNotice(this->noticed(item));
    }
    const PoppedValue popped = item < this->NumberOfVertices
      ? this->popBest(item)
      : this->popSecondary(item - this->NumberOfVertices);
    if (popped.vertex != NoIndex)
    {
      this->notePopped({ popped.vertex, popped.label->number() },
        popped.label->distance(popped.value) - this->FirstDistance);
    }
    return popped;
  }

  // See ThreadFront.

  template <Way way>
  void lower(const LabelAtVertex& place, double key)
  {
    const SourceFront& label = this->Fronts[place.label];
    this->Context.queues.goBackIfFar(this->groupOf(label), key);
    this->template propose<way>(label, place.vertex, key + this->FirstDistance - label.seedValue);
  }
  void updateRound(const LabelAtVertex& place)
  {
    const SourceFront& label = this->Fronts[place.label];
    const Index item = SharedLabelValues::Notice | static_cast<Index>(this->Notices.size());
    this->Notices.push_back(place);
    FrontGroup& group = this->groupOf(label);
    this->putBack(group, group.best, item,
      label.distance(this->known(label, place.vertex).held.value) - this->FirstDistance);
  }
  void take(Index item)
  {
    if (item < this->NumberOfVertices)
    {
      FrontGroup& group = this->groupOf(this->labelOf(this->state(item)));
      this->putBack(group, group.best, item, this->key(item));
      return;
    }
    const Secondary& secondary = this->Sets.secondary(item - this->NumberOfVertices);
    FrontGroup& group = this->groupOf(this->labelOf(secondary.state));
    this->putBack(group, group.secondary, item, secondary.distance - this->FirstDistance);
  }

private:
  const LabelAtVertex& noticed(Index item) const
  {
    return this->Notices[item & ~SharedLabelValues::Notice];
  }
  const SourceFront& labelOf(const VertexState& state) const { return this->Fronts[state.label()]; }
  FrontGroup& groupOf(const SourceFront& label) const
  {
    return this->Context.queues.group(label.group);
  }

  /** Mask of the vertices that this thread owns. */
  template <class Real>
  GEODESIC_INLINED unsigned ownOf(const Indices<Real>& vertices) const
  {
    unsigned own = 0;
    for (std::size_t lane = 0; lane < lanes<Real>; ++lane)
    {
      own |= static_cast<unsigned>(this->Share.owns(vertices[lane])) << lane;
    }
    return own;
  }

  /** See LabelValues. */
  double keptUpTo(const SourceFront& label, Index vertex) const
  {
    return this->Bounds
      ? this->Bounds->of(label, vertex)
      : this->distance(vertex) - label.seedValue + this->Context.cost.margin(vertex);
  }
  bool isBeyondBounds(const SourceFront& label, Index vertex, double value) const
  {
    return this->Bounds && value > this->Bounds->of(label, vertex);
  }

  PoppedValue popBest(Index vertex)
  {
    VertexState state = this->state(vertex);
    if (!state.isQueued())
    {
      return { NoIndex, nullptr, 0.0 };
    }
    state.setQueued(false);
    this->setState(vertex, state);
    const SourceFront& label = this->labelOf(state);
    return { vertex, &label, this->distance(vertex) - label.seedValue };
  }

  PoppedValue popSecondary(Index number)
  {
    Secondary& secondary = this->Sets.secondary(number);
    VertexState state = secondary.state;
    if (!state.isQueued())
    {
      return { NoIndex, nullptr, 0.0 };
    }
    state.setQueued(false);
    SharedSecondaryValues::setState(secondary, state);
    const SourceFront& label = this->labelOf(state);
    return this->ifKept(label, this->Sets.vertexOf(number), secondary.distance - label.seedValue);
  }

  /** What a vertex of another thread has of a label. */
  PoppedValue popNotice(const LabelAtVertex& place) const
  {
    const SourceFront& label = this->Fronts[place.label];
    const double value = this->known(label, place.vertex).held.value;
    return value < DistanceField::Unreached ? this->ifKept(label, place.vertex, value)
                                            : PoppedValue{ NoIndex, nullptr, 0.0 };
  }

  PoppedValue ifKept(const SourceFront& label, Index vertex, double value) const
  {
    return { value <= this->keptUpTo(label, vertex) ? vertex : NoIndex, &label, value };
  }

  /** What a vertex has of a label, and its state; without a label if it has nothing of it. */
  struct Known
  {
    NeighbourValue held;
    VertexState state;
  };
  Known known(const SourceFront& label, Index vertex) const
  {
    const double value = this->distance(vertex) - label.seedValue;
    keepSharedInOrder();
    const VertexState state = this->state(vertex);
    if (!state.hasOtherLabel(label.labelBits))
    {
      return { { value, value, state.isQueued() }, state };
    }
    keepSharedInOrder();
    return this->knownSecondary(
      label, this->Sets.find(vertex, label.number()), this->keptUpTo(label, vertex));
  }

  /** @param number  of a secondary value or NoIndex */
  Known knownSecondary(const SourceFront& label, Index number, double keptUpTo) const
  {
    if (number == NoIndex)
    {
      return { { DistanceField::Unreached, keptUpTo, false }, {} };
    }
    const Secondary& secondary = this->Sets.secondary(number);
    const double value = SharedSecondaryValues::distanceOf(secondary) - label.seedValue;
    keepSharedInOrder();
    const VertexState state = SharedSecondaryValues::stateOf(secondary);
    // Its owner may have given the place to another label since it was found.
    return state.labelBits() == label.labelBits
      ? Known{ { value, std::min(value, keptUpTo), state.isQueued() }, state }
      : Known{ { DistanceField::Unreached, keptUpTo, false }, {} };
  }

  template <Way way>
  NeighbourValue proposeToOther(const SourceFront& label, Index vertex, double value)
  {
    auto [known, state] = this->known(label, vertex);
    known.isQueued = false;
    if (value < known.ceiling * this->Context.control.keptFraction() &&
      !isFixed<Cost, way>(state) && !this->Context.options.isExcluded(vertex) &&
      !this->isBeyondBounds(label, vertex, value))
    {
      this->Share.send(
        { vertex, label.number() }, label.distance(value) - this->FirstDistance, way == Way::Along);
    }
    return known;
  }

  template <Way way>
  NeighbourValue proposeSecondary(const SourceFront& label, Index vertex, double value)
  {
    Index number = this->Sets.find(vertex, label.number());
    const auto [known, state] = this->knownSecondary(label, number, this->keptUpTo(label, vertex));
    if (!(value < known.ceiling * this->Context.control.keptFraction()) ||
      isFixed<Cost, way>(state) || this->Context.options.isExcluded(vertex))
    {
      return known;
    }
    if (number == NoIndex)
    {
      number = this->Sets.add(vertex, label.number(), this->Block);
    }
    this->setSecondary(label, vertex, number, value);
    return { value, value, true };
  }

  /** Stores the best value of a vertex, and queues the vertex. @pre it has no other label */
  void setBest(const SourceFront& label, Index vertex, double value)
  {
    VertexState state = this->state(vertex);
    const bool wasQueued = state.isQueued();
    this->noteIfFirst(vertex);
    state.setLabel(label.number());
    state.setQueued(true);
    this->setState(vertex, state);
    keepSharedInOrder();
    this->setDistance(vertex, label.distance(value));
    if (!wasQueued)
    {
      this->groupOf(label).best.push(vertex, label.distance(value) - this->FirstDistance);
    }
  }

  /** Stores a secondary value; if it is less than the best one, the two change places. */
  void setSecondary(const SourceFront& label, Index vertex, Index number, double value)
  {
    Secondary& secondary = this->Sets.secondary(number);
    if (value < this->distance(vertex) - label.seedValue)
    {
      this->makeBest(label, vertex, number, value);
      return;
    }
    SharedSecondaryValues::setDistance(secondary, label.distance(value));
    this->queueSecondary(number, secondary);
  }

  void queueSecondary(Index number, Secondary& secondary)
  {
    VertexState state = secondary.state;
    if (!state.isQueued())
    {
      state.setQueued(true);
      SharedSecondaryValues::setState(secondary, state);
      this->groupOf(this->labelOf(state))
        .secondary.push(this->NumberOfVertices + number, secondary.distance - this->FirstDistance);
    }
  }

  /** Gives the best value of a vertex the place of a secondary one, and then that of @p label the
   * place of the best one. */
  void makeBest(const SourceFront& label, Index vertex, Index number, double value)
  {
    Secondary& secondary = this->Sets.secondary(number);
    const VertexState before = this->state(vertex);
    VertexState after = secondary.state;
    VertexState moved = before;
    moved.setQueued(false);
    SharedSecondaryValues::setState(secondary, moved);
    keepSharedInOrder();
    SharedSecondaryValues::setDistance(secondary, this->distance(vertex));
    keepSharedInOrder();
    // What was queued is queued again as what it is now.
    if (before.isQueued())
    {
      this->queueSecondary(number, secondary);
    }
    after.setQueued(true);
    this->setState(vertex, after);
    keepSharedInOrder();
    this->setDistance(vertex, label.distance(value));
    this->groupOf(label).best.push(vertex, label.distance(value) - this->FirstDistance);
  }

  std::span<const SourceFront> Fronts;
  SharedSecondaryValues& Sets;
  const LabelBounds* Bounds;
  Index NumberOfVertices;
  SharedSecondaryValues::Block Block;
  /** What notices in the queue tell of. */
  std::vector<LabelAtVertex> Notices;
};

}

#endif
