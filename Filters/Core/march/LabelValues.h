// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LabelValues_h
#define geodesic_LabelValues_h

#include "base/Platform.h"
#include "march/FieldValues.h"
#include "march/FinishedVertex.h"
#include "march/LabelBounds.h"
#include "march/SecondaryValues.h"
#include "solve/MarchingFront.h"
#include "solve/StartValue.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/**
 * The values of a march of several labels. The field holds the best value of each vertex, and
 * SecondaryValues what else the vertex keeps. The items of the queues are the vertices, for their
 * best values, and then the number of vertices plus the numbers of secondary values. When a
 * secondary value becomes the best one, the two change places; items that were queued for them
 * before are ignored when they are taken.
 */
template <class Cost>
class LabelValues : public FieldValues<Cost>
{
public:
  /** @param sets, fronts  workspace
   * @param bounds of the values that count; null if there are none */
  LabelValues(const MarchContext<Cost>& context, std::span<const Label> labels,
    SecondaryValues& sets, std::vector<SourceFront>& fronts, LabelBounds* bounds)
    : FieldValues<Cost>(context, leastSeedValue(labels))
    , Labels(labels)
    , Sets(sets)
    , Bounds(bounds)
    , NumberOfVertices(context.mesh.numberOfVertices())
    , Fronts(fronts)
  {
    fronts.clear();
    sets.start(this->NumberOfVertices);
    fronts.reserve(labels.size());
    for (const Label& label : labels)
    {
      const Index bits = VertexState::labelBitsOf(static_cast<Index>(this->Fronts.size()));
      this->Fronts.emplace_back(label, bits, context.cost.smallest());
    }
    this->takeHigherBounds();
  }

  static constexpr bool hasOtherLabels = true;

  /** The label with a number, before it gets a value at @p vertex. The first such vertex decides
   * which group the label joins (see FrontQueues), as vertices with near numbers are near each
   * other on the surface. */
  const SourceFront& enter(Index number, Index vertex)
  {
    SourceFront& label = this->Fronts[number];
    if (label.group == NoIndex)
    {
      label.group = static_cast<Index>(
        std::uint64_t{ vertex } * this->context().queues.numberOfGroups() / this->NumberOfVertices);
    }
    return label;
  }

  /** Reads the best values of vertices, for an update for one label. */
  class Reader
  {
  public:
    Reader(const FieldReader& field, Index labelBits)
      : Field(field)
      , LabelBits(labelBits)
    {
    }
    template <class Real>
    GEODESIC_INLINED BestValues<Real> look(const Indices<Real>& vertices) const
    {
      constexpr unsigned all = (1u << lanes<Real>)-1;
      const BitsOf<Real> states = this->Field.template states<Real>(vertices);
      const BitsOf<Real> labels = states & VertexState::LabelBits;
      const unsigned areOwn = highestBits<Real>((labels == 0) | (labels == this->LabelBits));
      return { this->Field.template values<Real>(vertices), areOwn ^ all,
        areOwn & highestBits<Real>(states) };
    }

  private:
    FieldReader Field;
    Index LabelBits;
  };
  Reader reader(const SourceFront& label) const
  {
    return { this->fieldReader(label), label.labelBits };
  }

  /** Has the processor fetch the bound that propose() reads of a vertex. */
  GEODESIC_INLINED void prefetchBound(Index vertex) const
  {
    if (this->Bounds)
    {
      this->Bounds->prefetch(vertex);
    }
  }

  /** Has the processor fetch what others() reads of a vertex. */
  GEODESIC_INLINED void prefetchOther(Index vertex) const
  {
    this->Sets.prefetchInPlace(vertex);
    this->context().cost.prefetchMargin(vertex);
    this->prefetchBound(vertex);
  }

  /**
   * The values of a label at vertices whose best value is of another label.
   * @param areOther  mask of these vertices; for the others nothing is to be read in the result
   * @param best      the best values of all, less the value of the label's seed
   */
  template <class Real>
  GEODESIC_INLINED NeighbourValues<Real> others(const Indices<Real>& vertices, unsigned areOther,
    const SourceFront& label, const Real& best) const
  {
    const auto inPlace = [&](int lane) -> const SecondaryValues::SecondaryValue&
    { return this->Sets.inPlace(vertices[lane]); };
    const BitsOf<Real> states =
      bitsWith<Real>([&](int lane) { return inPlace(lane).state.bits(); });
    const BitsTestOf<Real> areInPlace = (states & VertexState::LabelBits) == label.labelBits;
    const BitsTestOf<Real> areLast =
      bitsWith<Real>([&](int lane) { return inPlace(lane).next(); }) == NoIndex;
    const Real values = select(widened<Real>(areInPlace),
      lanesOf<Real>([&](int lane) { return inPlace(lane).distance; }) - label.seedValue,
      Real() + DistanceField::Unreached);
    const Real keptUpTo = this->Bounds
      ? lanesOf<Real>([&](int lane) { return this->Bounds->of(label, vertices[lane]); })
      : best + lanesOf<Real>([&](int lane) { return this->context().cost.margin(vertices[lane]); });
    NeighbourValues<Real> known{ values, least(values, keptUpTo),
      highestBits<Real>(areInPlace) & highestBits<Real>(states) };
    unsigned inChain = areOther & ~highestBits<Real>(areInPlace | areLast);
    for (; inChain != 0; inChain &= inChain - 1)
    {
      const int lane = std::countr_zero(inChain);
      const NeighbourValue secondary = this->knownSecondary(
        label, this->Sets.findInChain(vertices[lane], label.number()), keptUpTo[lane]);
      known.values[lane] = secondary.value;
      known.ceilings[lane] = secondary.ceiling;
      known.areQueued |= static_cast<unsigned>(secondary.isQueued) << lane;
    }
    return known;
  }

  /** Gives a vertex a value of a label, and queues it, if the value counts. @return what the vertex
   * then has of the label */
  template <Way way>
  NeighbourValue propose(const SourceFront& label, Index vertex, double value)
  {
    value = label.leastOf.raised(value, this->position(vertex));
    if (this->state(vertex).isQueuedFor(label.labelBits))
    {
      return this->lower(label, vertex, value);
    }
    if (this->state(vertex).hasOtherLabel(label.labelBits)) [[unlikely]]
    {
      return this->proposeSecondary<way>(label, vertex, value);
    }
    if (this->Bounds && value > this->Bounds->of(label, vertex))
    {
      const double known = this->value(label, vertex);
      return { known, known, this->state(vertex).isQueued() };
    }
    return this->template offer<way>(label, vertex, value);
  }

  /** Gives a vertex a start value of a label. */
  void start(const SourceFront& label, const StartValue& first)
  {
    VertexState& state = this->state(first.vertex);
    if (!state.hasOtherLabel(label.labelBits))
    {
      state.setLabel(label.number());
      this->setFirst(label, first);
      return;
    }
    const Index number = this->Sets.findOrAdd(first.vertex, label.number());
    this->Sets.secondary(number).state.setFinal(first.isFinal);
    this->setSecondary(label, first.vertex, number, first.value);
    if (first.isIdle)
    {
      // The item in the queue is ignored then.
      (state.label() == label.number() ? state : this->Sets.secondary(number).state)
        .setQueued(false);
    }
  }

  /** See goOnWithinHigherBounds(). */
  void takeHigherBounds()
  {
    for (SourceFront& label : this->Fronts)
    {
      label.reach = this->Bounds ? this->Bounds->ofLabel(label.number()) : DistanceField::Unreached;
      label.allowance = this->Bounds ? this->Bounds->allowanceOf(label.number()) : 0.0;
    }
  }
  void goBackTo(Index vertex)
  {
    const auto goBack = [&](const SourceFront& label, double value)
    {
      FrontQueues& queues = this->context().queues;
      queues.goBackTo(queues.group(label.group), value + label.seedValue - this->firstDistance());
    };
    const SourceFront& best = this->labelOf(this->state(vertex));
    goBack(best, this->value(best, vertex));
    this->Sets.visitSecondary(vertex,
      [&](const SecondaryValues::SecondaryValue& secondary)
      {
        const SourceFront& label = this->labelOf(secondary.state);
        goBack(label, valueOf(label, secondary));
      });
  }
  void queueAgain(Index vertex)
  {
    const SourceFront& best = this->labelOf(this->state(vertex));
    this->state(vertex).setQueued(true);
    this->queue(best, this->groupOf(best).best, vertex, this->value(best, vertex));
    this->Sets.visitNumbers(vertex,
      [&](Index number)
      {
        SecondaryValues::SecondaryValue& secondary = this->Sets.secondary(number);
        this->queueSecondary(this->labelOf(secondary.state), number, secondary);
      });
  }

  /** How many values vertices keep, or have kept in this march; up to one more for each vertex. */
  std::size_t numberOfValues() const
  {
    return 2 * this->context().field.reached().size() + this->Sets.numberOfOthers();
  }

  /** Whether labels are dense, so that bounds are set (see LabelBounds). */
  bool hasBounds() const { return this->Bounds != nullptr; }
  /** The bounds; null if there are none. */
  LabelBounds* bounds() const { return this->Bounds; }

  /** The vertex of an item of the queues. */
  Index vertexOf(Index taken) const
  {
    return taken < this->NumberOfVertices ? taken
                                          : this->Sets.vertexOf(taken - this->NumberOfVertices);
  }

  /** Fetches what pop() and an update read. GCC drops the call unless it is inlined. */
  GEODESIC_INLINED void prefetch(Index taken) const
  {
    const Index vertex = this->vertexOf(taken);
    this->prefetchRing(vertex);
    prefetchToRead(&this->state(vertex));
  }

  /** Whether the value of an item is queued: it may have been taken since the item was. */
  bool isWaiting(Index taken) const
  {
    return taken < this->NumberOfVertices
      ? this->state(taken).isQueued()
      : this->Sets.secondary(taken - this->NumberOfVertices).state.isQueued();
  }

  /** The value of an item that was taken from a queue, which then is not queued any more. */
  PoppedValue pop(Index taken)
  {
    return taken < this->NumberOfVertices ? this->popBest(taken)
                                          : this->popSecondary(taken - this->NumberOfVertices);
  }

  /** Calls @p visit with each label and value that the vertex keeps. */
  void visit(Index vertex, const MarchingFront::Visit& visit)
  {
    if (!this->context().field.isReached(vertex))
    {
      return;
    }
    const SourceFront& best = this->labelOf(this->state(vertex));
    visit(best.number(), this->value(best, vertex));
    this->Sets.visitSecondary(vertex,
      [&](const SecondaryValues::SecondaryValue& secondary)
      {
        const SourceFront& label = this->labelOf(secondary.state);
        const double value = valueOf(label, secondary);
        if (value <= this->keptUpTo(label, vertex))
        {
          visit(label.number(), value);
        }
      });
  }

  /** Sets the nearest seeds in the field, and removes all values. */
  void finish()
  {
    for (const Index vertex : this->context().field.reached())
    {
      if (finishVertex(this->context(), this->Labels, this->Sets, this->Bounds, vertex))
      {
        this->Bounds->noteAtEnd(vertex);
      }
    }
    this->Sets.finish();
  }

private:
  const SourceFront& labelOf(const VertexState& state) const { return this->Fronts[state.label()]; }
  static double valueOf(const SourceFront& label, const SecondaryValues::SecondaryValue& secondary)
  {
    return secondary.distance - label.seedValue;
  }

  /** The largest value of a label that a vertex keeps: within the margin, or within bounds. */
  double keptUpTo(const SourceFront& label, Index vertex) const
  {
    return this->Bounds ? this->Bounds->of(label, vertex)
                        : this->value(label, vertex) + this->context().cost.margin(vertex);
  }

  PoppedValue popBest(Index vertex)
  {
    VertexState& state = this->state(vertex);
    if (!state.isQueued())
    {
      return { NoIndex, nullptr, 0.0 };
    }
    state.setQueued(false);
    const SourceFront& label = this->labelOf(state);
    return { vertex, &label, this->value(label, vertex) };
  }

  PoppedValue popSecondary(Index number)
  {
    SecondaryValues::SecondaryValue& secondary = this->Sets.secondary(number);
    if (!secondary.state.isQueued())
    {
      return { NoIndex, nullptr, 0.0 };
    }
    secondary.state.setQueued(false);
    const SourceFront& label = this->labelOf(secondary.state);
    const Index vertex = this->Sets.vertexOf(number);
    const double value = valueOf(label, secondary);
    const bool isKept = value <= this->keptUpTo(label, vertex);
    return { isKept ? vertex : NoIndex, &label, value };
  }

  /** @param number  of a secondary value or NoIndex */
  NeighbourValue knownSecondary(const SourceFront& label, Index number, double keptUpTo) const
  {
    if (number == NoIndex)
    {
      return { DistanceField::Unreached, keptUpTo, false };
    }
    const SecondaryValues::SecondaryValue& secondary = this->Sets.secondary(number);
    const double value = valueOf(label, secondary);
    return { value, std::min(value, keptUpTo), secondary.state.isQueued() };
  }

  template <Way way>
  NeighbourValue proposeSecondary(const SourceFront& label, Index vertex, double value)
  {
    Index number = this->Sets.find(vertex, label.number());
    const NeighbourValue known = this->knownSecondary(label, number, this->keptUpTo(label, vertex));
    if (!(value < this->ceiling(label, vertex, known.ceiling)) || this->isExcluded(vertex))
    {
      return known;
    }
    if (number == NoIndex)
    {
      number = this->Sets.add(vertex, label.number());
    }
    else if (isFixed<Cost, way>(this->Sets.secondary(number).state))
    {
      return known;
    }
    this->setSecondary(label, vertex, number, value);
    return { value, value, true };
  }

  void setBest(const SourceFront& label, Index vertex, double value)
  {
    this->state(vertex).setLabel(label.number());
    this->set(label, vertex, value);
  }

  /** Stores a secondary value; if it is less than the best one, the two change places.
   * @param number  of the label's secondary value */
  void setSecondary(const SourceFront& label, Index vertex, Index number, double value)
  {
    SecondaryValues::SecondaryValue& secondary = this->Sets.secondary(number);
    secondary.distance = label.distance(value);
    if (value < this->value(label, vertex))
    {
      this->makeBest(label, vertex, number, secondary);
    }
    else
    {
      this->queueSecondary(label, number, secondary);
    }
  }

  void queueSecondary(
    const SourceFront& label, Index number, SecondaryValues::SecondaryValue& secondary)
  {
    if (!secondary.state.isQueued())
    {
      secondary.state.setQueued(true);
      this->queue(label, this->groupOf(label).secondary, this->NumberOfVertices + number,
        valueOf(label, secondary));
    }
  }

  /** A secondary value, of @p label, and the best one change places. */
  void makeBest(const SourceFront& label, Index vertex, Index number,
    SecondaryValues::SecondaryValue& secondary)
  {
    const double value = valueOf(label, secondary);
    VertexState& state = this->state(vertex);
    const SourceFront& before = this->labelOf(state);
    secondary.distance = this->context().field.distance(vertex);
    std::swap(state, secondary.state);
    this->Sets.relabelled(vertex, number, label.number());
    // What was queued is queued again under its new number.
    if (secondary.state.isQueued())
    {
      secondary.state.setQueued(false);
      this->queueSecondary(before, number, secondary);
    }
    state.setQueued(false);
    this->setBest(label, vertex, value);
  }

  std::span<const Label> Labels;
  SecondaryValues& Sets;
  LabelBounds* Bounds;
  Index NumberOfVertices;
  /** By the number of the label. */
  std::vector<SourceFront>& Fronts;
};

}

#endif
