#ifndef geodesic_LabelValues_h
#define geodesic_LabelValues_h

#include "FieldValues.h"
#include "LabelSets.h"
#include "MarchingFront.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/**
 * The values of one of several labels, the current one. The field holds a vertex's best value,
 * LabelSets what else the vertex keeps. In the queue are vertices for their best values, and behind
 * their numbers those of further values. When a further value becomes the best, the two change
 * places; what the queue then holds of either is passed over.
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
      this->Fronts.push_back({ label.value, StraightLineBound(label, context.cost.smallest()),
        ValueMark::bitsOf(static_cast<Index>(this->Fronts.size())), label.shape });
    }
    this->setCurrent(0);
  }

  static constexpr bool hasOthers = true;
  Index current() const { return ValueMark::labelOf(this->labelBits()); }
  FrontShape shape() const { return this->Current->shape; }
  void setCurrent(Index label)
  {
    this->Current = &this->Fronts[label];
    FieldValues<Cost>::setCurrent(this->Current->labelBits, this->Current->seedValue);
  }

  template <class Real>
  GEODESIC_INLINED SeenValues<Real> look(const Indices<Real>& vertices) const
  {
    constexpr unsigned all = (1u << lanes<Real>)-1;
    const BitsOf<Real> marks = this->template marks<Real>(vertices);
    const BitsOf<Real> labels = marks & ValueMark::LabelBits;
    const unsigned areOwn = highestBits<Real>((labels == 0) | (labels == this->labelBits()));
    return { this->template values<Real>(vertices), areOwn ^ all,
      areOwn & highestBits<Real>(marks) };
  }

  /**
   * What is known for a label of vertices, of which some have a best value of another one.
   * @param areOther  which do; only of those something is told
   * @param best      their best values, less the one of the label's seed
   */
  template <class Real>
  GEODESIC_INLINED KnownValues<Real> others(
    const Indices<Real>& vertices, unsigned areOther, Index label, const Real& best) const
  {
    const auto second = [&](int lane) -> const LabelSets::Further&
    { return this->Sets.second(vertices[lane]); };
    const BitsOf<Real> marks = bitsWith<Real>([&](int lane) { return second(lane).mark.bits(); });
    const BitsTestOf<Real> areSecond = (marks & ValueMark::LabelBits) == ValueMark::bitsOf(label);
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
        this->knownFurther(this->Sets.findInChain(vertices[lane], label), keptUpTo[lane]);
      known.values[lane] = further.value;
      known.ceilings[lane] = further.ceiling;
      known.areQueued |= static_cast<unsigned>(further.isQueued) << lane;
    }
    return known;
  }

  KnownValue propose(Index vertex, double value)
  {
    value = this->Current->leastOf.raised(value, this->position(vertex));
    if (this->isOther(vertex)) [[unlikely]]
    {
      return this->proposeFurther(vertex, value);
    }
    return this->offer(vertex, value);
  }

  void start(Index vertex, double value, bool isFinal)
  {
    if (!this->isOther(vertex))
    {
      this->setBest(vertex, value);
      this->mark(vertex).setPinned(isFinal);
      return;
    }
    const Index number = this->Sets.findOrAdd(vertex, this->current());
    this->Sets.further(number).mark.setPinned(isFinal);
    this->setFurther(vertex, number, value);
  }

  Index vertexOf(Index taken) const
  {
    return taken < this->NumberOfVertices ? taken
                                          : this->Sets.vertexOf(taken - this->NumberOfVertices);
  }

  /** Makes the label of what was taken from the queue the current one. */
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
    this->setCurrent(this->mark(vertex).label());
    visit(this->current(), this->value(vertex));
    this->Sets.visitFurther(vertex,
      [&](const LabelSets::Further& further)
      {
        this->setCurrent(further.mark.label());
        if (further.value <= this->keptUpTo(vertex))
        {
          visit(this->current(), further.value);
        }
      });
  }

  /** The smallest seed among those whose value equals the vertex's best one, rounding aside. */
  Index nearestSeed(Index vertex) const
  {
    constexpr double rounding = 1.0 + 1e-10;
    const double most = this->context().field.distance(vertex) * rounding;
    Index seed = this->Labels[this->mark(vertex).label()].seed;
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

  void clear(Index vertex)
  {
    this->mark(vertex) = {};
    this->Sets.clear(vertex);
  }

private:
  /** One of the labels, with what the march asks for most. */
  struct Front
  {
    double seedValue;
    StraightLineBound leastOf;
    Index labelBits;
    FrontShape shape;
  };

  /** Whether the best value of a vertex is of another label than the current one. */
  bool isOther(Index vertex) const { return this->mark(vertex).hasOtherLabel(this->labelBits()); }

  /** The largest value of the current label that a vertex keeps beside its best one. */
  double keptUpTo(Index vertex) const
  {
    return this->value(vertex) + this->context().cost.margin(vertex);
  }

  TakenValue takeBest(Index vertex)
  {
    ValueMark& mark = this->mark(vertex);
    if (!mark.isQueued())
    {
      return { NoIndex, 0.0 };
    }
    mark.setQueued(false);
    this->setCurrent(mark.label());
    return { vertex, this->value(vertex) };
  }

  TakenValue takeFurther(Index number)
  {
    LabelSets::Further& further = this->Sets.further(number);
    if (!further.mark.isQueued())
    {
      return { NoIndex, 0.0 };
    }
    further.mark.setQueued(false);
    this->setCurrent(further.mark.label());
    const Index vertex = this->Sets.vertexOf(number);
    return { further.value <= this->keptUpTo(vertex) ? vertex : NoIndex, further.value };
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

  KnownValue proposeFurther(Index vertex, double value)
  {
    const KnownValue known =
      this->knownFurther(this->Sets.find(vertex, this->current()), this->keptUpTo(vertex));
    if (!(value < this->ceiling(vertex, known.ceiling)) ||
      this->context().options.isExcluded(vertex))
    {
      return known;
    }
    const Index number = this->Sets.findOrAdd(vertex, this->current());
    if (this->Sets.further(number).mark.isPinned())
    {
      return known;
    }
    this->setFurther(vertex, number, value);
    return { value, value, true };
  }

  void setBest(Index vertex, double value)
  {
    this->mark(vertex).setLabel(this->current());
    this->set(vertex, value);
  }

  /** @param number  of a further value of the vertex, which is of the current label */
  void setFurther(Index vertex, Index number, double value)
  {
    LabelSets::Further& further = this->Sets.further(number);
    further.value = value;
    if (value < this->value(vertex))
    {
      this->makeBest(vertex, number, further);
    }
    else
    {
      this->queueFurther(number, further);
    }
  }

  void queueFurther(Index number, LabelSets::Further& further)
  {
    if (!further.mark.isQueued())
    {
      further.mark.setQueued(true);
      this->context().queue.push(this->NumberOfVertices + number,
        further.value + this->Fronts[further.mark.label()].seedValue - this->firstDistance());
    }
  }

  /** A further value of the current label and the best one change places. */
  void makeBest(Index vertex, Index number, LabelSets::Further& further)
  {
    const double value = further.value;
    ValueMark& mark = this->mark(vertex);
    further.value = this->context().field.distance(vertex) - this->Fronts[mark.label()].seedValue;
    std::swap(mark, further.mark);
    // Wherever the queue has them, they go to it again under their new numbers.
    if (further.mark.isQueued())
    {
      further.mark.setQueued(false);
      this->queueFurther(number, further);
    }
    mark.setQueued(false);
    this->setBest(vertex, value);
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
  std::vector<Front> Fronts;
  const Front* Current = nullptr;
};

}

#endif
