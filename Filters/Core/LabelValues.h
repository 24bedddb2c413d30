#ifndef geodesic_LabelValues_h
#define geodesic_LabelValues_h

#include "FieldValues.h"
#include "LabelSets.h"
#include "MarchingFront.h"

#include <algorithm>
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
    const BitsOf<Real> marks = this->template marks<Real>(vertices);
    const BitsOf<Real> labels = marks & ValueMark::LabelBits;
    const BitsTestOf<Real> areOther = ~((labels == 0) | (labels == this->labelBits()));
    return { this->template values<Real>(vertices), highestBits<Real>(areOther),
      highestBits<Real>(marks & ~areOther) };
  }

  /** What is known for a label of a vertex whose best value is of another one.
   * @param best  that value, less the one of the label's seed */
  KnownValue other(Index vertex, Index label, double best) const
  {
    const LabelSets::Further& second = this->Sets.second(vertex);
    const double keptUpTo = best + this->context().cost.margin(vertex);
    if (this->Sets.mayBeInChain(vertex, label)) [[unlikely]]
    {
      return this->knownFurther(this->Sets.find(vertex, label), keptUpTo);
    }
    // Whether it is the second is not to be guessed, so there is no branch on it.
    const bool isSecond = second.mark.label() == label;
    const Pair none{ DistanceField::Unreached };
    const double value =
      select(PairTest{ -static_cast<std::int64_t>(isSecond) }, Pair{ second.value }, none)[0];
    return { value, least(value, keptUpTo), (isSecond & second.mark.isQueued()) != 0 };
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
    this->setFurther(number, value);
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
    const KnownValue known = this->other(vertex, this->current(), this->value(vertex));
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
    this->setFurther(number, value);
    return { value, value, true };
  }

  void setBest(Index vertex, double value)
  {
    this->mark(vertex).setLabel(this->current());
    this->set(vertex, value);
  }

  /** Of the current label. */
  void setFurther(Index number, double value)
  {
    this->Sets.further(number).value = value;
    if (value < this->value(this->Sets.vertexOf(number)))
    {
      this->makeBest(number);
    }
    else
    {
      this->queueFurther(number);
    }
  }

  void queueFurther(Index number)
  {
    LabelSets::Further& further = this->Sets.further(number);
    if (!further.mark.isQueued())
    {
      further.mark.setQueued(true);
      this->context().queue.push(this->NumberOfVertices + number,
        further.value + this->Fronts[further.mark.label()].seedValue - this->firstDistance());
    }
  }

  /** A further value of the current label and the best one change places. */
  void makeBest(Index number)
  {
    LabelSets::Further& further = this->Sets.further(number);
    const Index vertex = this->Sets.vertexOf(number);
    const double value = further.value;
    ValueMark& mark = this->mark(vertex);
    further.value = this->context().field.distance(vertex) - this->Fronts[mark.label()].seedValue;
    std::swap(mark, further.mark);
    // Wherever the queue has them, they go to it again under their new numbers.
    if (further.mark.isQueued())
    {
      further.mark.setQueued(false);
      this->queueFurther(number);
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
