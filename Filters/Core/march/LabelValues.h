#ifndef geodesic_LabelValues_h
#define geodesic_LabelValues_h

#include "march/FieldValues.h"
#include "march/LabelSets.h"
#include "solve/MarchingFront.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/**
 * The values of several labels. The field holds a vertex's best value, LabelSets what else the
 * vertex keeps. In the queue are vertices for their best values, and behind their numbers those of
 * further values. When a further value becomes the best, the two change places; what the queue then
 * holds of either is passed over.
 */
template <class Cost>
class LabelValues : public FieldValues<Cost>
{
public:
  LabelValues(const MarchContext<Cost>& context, std::span<const Label> labels, LabelSets& sets)
    : FieldValues<Cost>(context, smallestOf(labels))
    , Labels(labels)
    , Sets(sets)
    , NumberOfVertices(context.mesh.numberOfVertices())
  {
    sets.start(this->NumberOfVertices);
    this->Fronts.reserve(labels.size());
    for (const Label& label : labels)
    {
      const Index bits = ValueMark::bitsOf(static_cast<Index>(this->Fronts.size()));
      this->Fronts.emplace_back(label, bits, context.cost.smallest());
    }
  }

  static constexpr bool hasOthers = true;

  /** The label of a number, which is to have a value at a vertex. Where that is first decides on
   * its group: what is near each other on the surface is so in memory too. */
  const MarchedLabel& enter(Index number, Index vertex)
  {
    MarchedLabel& label = this->Fronts[number];
    if (label.group == nullptr)
    {
      FrontQueues& queues = this->context().queues;
      label.group =
        &queues.group(std::uint64_t{ vertex } * queues.numberOfGroups() / this->NumberOfVertices);
    }
    return label;
  }

  class Sight
  {
  public:
    Sight(const FieldSight& field, Index labelBits)
      : Field(field)
      , LabelBits(labelBits)
    {
    }
    template <class Real>
    GEODESIC_INLINED SeenValues<Real> look(const Indices<Real>& vertices) const
    {
      constexpr unsigned all = (1u << lanes<Real>)-1;
      const BitsOf<Real> marks = this->Field.template marks<Real>(vertices);
      const BitsOf<Real> labels = marks & ValueMark::LabelBits;
      const unsigned areOwn = highestBits<Real>((labels == 0) | (labels == this->LabelBits));
      return { this->Field.template values<Real>(vertices), areOwn ^ all,
        areOwn & highestBits<Real>(marks) };
    }

  private:
    FieldSight Field;
    Index LabelBits;
  };
  Sight sight(const MarchedLabel& label) const
  {
    return { this->fieldSight(label), label.labelBits };
  }

  /** Has the processor fetch what others() reads of a vertex. */
  [[gnu::always_inline]] void prefetchOther(Index vertex) const
  {
    this->Sets.prefetchSecond(vertex);
    this->context().cost.prefetchMargin(vertex);
  }

  /**
   * What is known for a label of vertices, of which some have a best value of another one.
   * @param areOther  which do; only of those something is told
   * @param best      their best values, less the one of the label's seed
   */
  template <class Real>
  GEODESIC_INLINED KnownValues<Real> others(const Indices<Real>& vertices, unsigned areOther,
    const MarchedLabel& label, const Real& best) const
  {
    const auto second = [&](int lane) -> const LabelSets::Further&
    { return this->Sets.second(vertices[lane]); };
    const BitsOf<Real> marks = bitsWith<Real>([&](int lane) { return second(lane).mark.bits(); });
    const BitsTestOf<Real> areSecond = (marks & ValueMark::LabelBits) == label.labelBits;
    const BitsTestOf<Real> areLast =
      bitsWith<Real>([&](int lane) { return second(lane).next(); }) == NoIndex;
    const Real values =
      select(widened<Real>(areSecond), lanesOf<Real>([&](int lane) { return second(lane).value; }),
        Real() + DistanceField::Unreached);
    const Real keptUpTo =
      best + lanesOf<Real>([&](int lane) { return this->context().cost.margin(vertices[lane]); });
    KnownValues<Real> known{ values, least(values, keptUpTo),
      highestBits<Real>(areSecond) & highestBits<Real>(marks) };
    unsigned inChain = areOther & ~highestBits<Real>(areSecond | areLast);
    for (; inChain != 0; inChain &= inChain - 1)
    {
      const int lane = std::countr_zero(inChain);
      const KnownValue further =
        this->knownFurther(this->Sets.findInChain(vertices[lane], label.number()), keptUpTo[lane]);
      known.values[lane] = further.value;
      known.ceilings[lane] = further.ceiling;
      known.areQueued |= static_cast<unsigned>(further.isQueued) << lane;
    }
    return known;
  }

  KnownValue propose(const MarchedLabel& label, Index vertex, double value)
  {
    value = label.leastOf.raised(value, this->position(vertex));
    if (this->mark(vertex).isQueuedFor(label.labelBits))
    {
      return this->lower(label, vertex, value);
    }
    if (this->mark(vertex).hasOtherLabel(label.labelBits)) [[unlikely]]
    {
      return this->proposeFurther(label, vertex, value);
    }
    return this->offer(label, vertex, value);
  }

  void start(const MarchedLabel& label, Index vertex, double value, bool isFinal)
  {
    if (!this->mark(vertex).hasOtherLabel(label.labelBits))
    {
      this->setBest(label, vertex, value);
      this->mark(vertex).setPinned(isFinal);
      return;
    }
    const Index number = this->Sets.findOrAdd(vertex, label.number());
    this->Sets.further(number).mark.setPinned(isFinal);
    this->setFurther(label, vertex, number, value);
  }

  Index vertexOf(Index taken) const
  {
    return taken < this->NumberOfVertices ? taken
                                          : this->Sets.vertexOf(taken - this->NumberOfVertices);
  }

  /** Has the processor fetch what take() of it and a look round it read. GCC drops the call unless
   * it is inlined. */
  [[gnu::always_inline]] void prefetch(Index taken) const
  {
    const Index vertex = this->vertexOf(taken);
    this->context().mesh.prefetch(vertex);
    __builtin_prefetch(&this->mark(vertex));
  }

  TakenValue take(Index taken)
  {
    return taken < this->NumberOfVertices ? this->takeBest(taken)
                                          : this->takeFurther(taken - this->NumberOfVertices);
  }

  /** The values that the vertex keeps, by label. */
  void visit(Index vertex, const MarchingFront::Visit& visit)
  {
    if (!this->context().field.isReached(vertex))
    {
      return;
    }
    const MarchedLabel& best = this->labelOf(this->mark(vertex));
    visit(best.number(), this->value(best, vertex));
    this->Sets.visitFurther(vertex,
      [&](const LabelSets::Further& further)
      {
        const MarchedLabel& label = this->labelOf(further.mark);
        if (further.value <= this->keptUpTo(label, vertex))
        {
          visit(label.number(), further.value);
        }
      });
  }

  /** Tells the field the nearest seeds, and forgets all values. */
  void finish()
  {
    DistanceField& field = this->context().field;
    for (Index vertex : field.reached())
    {
      ValueMark& mark = this->mark(vertex);
      field.setNearestSeed(vertex, this->Labels[mark.label()].seed);
      if (this->Sets.hasFurther(vertex))
      {
        field.setNearestSeed(vertex, this->nearestOfFurther(vertex, field.nearestSeed(vertex)));
        this->Sets.clear(vertex);
      }
      mark = {};
    }
    this->Sets.finish();
  }

private:
  const MarchedLabel& labelOf(const ValueMark& mark) const { return this->Fronts[mark.label()]; }

  /** The largest value of a label that a vertex keeps beside its best one. */
  double keptUpTo(const MarchedLabel& label, Index vertex) const
  {
    return this->value(label, vertex) + this->context().cost.margin(vertex);
  }

  TakenValue takeBest(Index vertex)
  {
    ValueMark& mark = this->mark(vertex);
    if (!mark.isQueued())
    {
      return { NoIndex, nullptr, 0.0 };
    }
    mark.setQueued(false);
    const MarchedLabel& label = this->labelOf(mark);
    return { vertex, &label, this->value(label, vertex) };
  }

  TakenValue takeFurther(Index number)
  {
    LabelSets::Further& further = this->Sets.further(number);
    if (!further.mark.isQueued())
    {
      return { NoIndex, nullptr, 0.0 };
    }
    further.mark.setQueued(false);
    const MarchedLabel& label = this->labelOf(further.mark);
    const Index vertex = this->Sets.vertexOf(number);
    const bool isKept = further.value <= this->keptUpTo(label, vertex);
    return { isKept ? vertex : NoIndex, &label, further.value };
  }

  /** @param number  of a further value or NoIndex */
  KnownValue knownFurther(Index number, double keptUpTo) const
  {
    if (number == NoIndex)
    {
      return { DistanceField::Unreached, keptUpTo, false };
    }
    const LabelSets::Further& further = this->Sets.further(number);
    return { further.value, std::min(further.value, keptUpTo), further.mark.isQueued() };
  }

  KnownValue proposeFurther(const MarchedLabel& label, Index vertex, double value)
  {
    Index number = this->Sets.find(vertex, label.number());
    const KnownValue known = this->knownFurther(number, this->keptUpTo(label, vertex));
    if (!(value < this->ceiling(label, vertex, known.ceiling)) || this->isExcluded(vertex))
    {
      return known;
    }
    if (number == NoIndex)
    {
      number = this->Sets.add(vertex, label.number());
    }
    else if (this->Sets.further(number).mark.isPinned())
    {
      return known;
    }
    this->setFurther(label, vertex, number, value);
    return { value, value, true };
  }

  /** The smallest seed among those whose value equals the best one of a vertex, rounding aside.
   * @param seed  that of the best one */
  Index nearestOfFurther(Index vertex, Index seed) const
  {
    constexpr double rounding = 1.0 + 1e-10;
    const double most = this->context().field.distance(vertex) * rounding;
    this->Sets.visitFurther(vertex,
      [&](const LabelSets::Further& further)
      {
        const Label& label = this->Labels[further.mark.label()];
        if (further.value + label.value <= most)
        {
          seed = std::min(seed, label.seed);
        }
      });
    return seed;
  }

  void setBest(const MarchedLabel& label, Index vertex, double value)
  {
    this->mark(vertex).setLabel(label.number());
    this->set(label, vertex, value);
  }

  /** @param number  of the label's value among the further ones of the vertex */
  void setFurther(const MarchedLabel& label, Index vertex, Index number, double value)
  {
    LabelSets::Further& further = this->Sets.further(number);
    further.value = value;
    if (value < this->value(label, vertex))
    {
      this->makeBest(label, vertex, number, further);
    }
    else
    {
      this->queueFurther(label, number, further);
    }
  }

  void queueFurther(const MarchedLabel& label, Index number, LabelSets::Further& further)
  {
    if (!further.mark.isQueued())
    {
      further.mark.setQueued(true);
      this->queue(label, label.group->further, this->NumberOfVertices + number, further.value);
    }
  }

  /** A further value, of @p label, and the best one change places. */
  void makeBest(const MarchedLabel& label, Index vertex, Index number, LabelSets::Further& further)
  {
    const double value = further.value;
    ValueMark& mark = this->mark(vertex);
    const MarchedLabel& before = this->labelOf(mark);
    further.value = this->value(before, vertex);
    std::swap(mark, further.mark);
    // Wherever the queue has them, they go to it again under their new numbers.
    if (further.mark.isQueued())
    {
      further.mark.setQueued(false);
      this->queueFurther(before, number, further);
    }
    mark.setQueued(false);
    this->setBest(label, vertex, value);
  }

  static double smallestOf(std::span<const Label> labels)
  {
    return std::min_element(labels.begin(), labels.end(),
      [](const Label& a, const Label& b) { return a.value < b.value; })
      ->value;
  }

  std::span<const Label> Labels;
  LabelSets& Sets;
  Index NumberOfVertices;
  /** By the number of the label. */
  std::vector<MarchedLabel> Fronts;
};

}

#endif
