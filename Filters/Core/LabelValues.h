#ifndef geodesic_LabelValues_h
#define geodesic_LabelValues_h

#include "FieldValues.h"
#include "LabelSets.h"
#include "MarchingFront.h"

#include <algorithm>
#include <array>
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
    this->LeastOf.reserve(labels.size());
    for (const Label& label : labels)
    {
      this->LeastOf.emplace_back(label, context.cost.smallest());
    }
  }

  Index current() const { return this->Current; }
  FrontShape shape() const { return this->Labels[this->Current].shape; }
  void setCurrent(Index label)
  {
    this->Current = label;
    this->setOffset(this->Labels[label].value);
  }

  template <class Real>
  GEODESIC_INLINED KnownValues<Real> look(const Indices<Real>& vertices) const
  {
    // Away from borders a vertex has a value for this label, or none at all.
    std::uint64_t areOthers = 0;
    for (Index vertex : vertices)
    {
      areOthers |= this->isOther(vertex);
    }
    if (areOthers == 0) [[likely]]
    {
      return this->template known<Real>(vertices);
    }
    return this->template lookAtBorder<Real>(vertices);
  }

  KnownValue propose(Index vertex, double value)
  {
    value = this->LeastOf[this->Current].raised(value, this->position(vertex));
    if (this->isOther(vertex) != 0) [[unlikely]]
    {
      return this->proposeFurther(vertex, value);
    }
    const KnownValue held = this->offer(vertex, value);
    if (held.isQueued)
    {
      this->Sets.setBestLabel(vertex, this->Current);
    }
    return held;
  }

  void start(Index vertex, double value, bool isFinal)
  {
    if (this->isOther(vertex) == 0)
    {
      this->setBest(vertex, value);
      this->state(vertex).isPinned = isFinal;
      return;
    }
    const Index number = this->Sets.add(vertex, this->Current, value);
    this->Sets.further(number).setState({ .isPinned = isFinal });
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
    this->setCurrent(this->Sets.bestLabel(vertex));
    visit(this->Current, this->value(vertex));
    this->Sets.visitFurther(vertex,
      [&](const LabelSets::Further& further)
      {
        this->setCurrent(further.label());
        if (further.value <= this->keptUpTo(vertex))
        {
          visit(further.label(), further.value);
        }
      });
  }

  /** The smallest seed among those whose value equals the vertex's best one, rounding aside. */
  Index nearestSeed(Index vertex) const
  {
    constexpr double rounding = 1.0 + 1e-10;
    const double most = this->context().field.distance(vertex) * rounding;
    Index seed = this->Labels[this->Sets.bestLabel(vertex)].seed;
    this->Sets.visitFurther(vertex,
      [&](const LabelSets::Further& further)
      {
        const Label& label = this->Labels[further.label()];
        if (further.value + label.value <= most)
        {
          seed = std::min(seed, label.seed);
        }
      });
    return seed;
  }

  void clear(Index vertex)
  {
    this->state(vertex) = {};
    this->Sets.clear(vertex);
  }

private:
  std::uint64_t isOther(Index vertex) const { return this->Sets.isOther(vertex, this->Current); }

  /** The largest value of the current label that a vertex keeps beside its best one. */
  double keptUpTo(Index vertex) const
  {
    return this->value(vertex) + this->context().cost.margin(vertex);
  }

  TakenValue takeBest(Index vertex)
  {
    if (!std::exchange(this->state(vertex).isQueued, false))
    {
      return { NoIndex, 0.0 };
    }
    this->setCurrent(this->Sets.bestLabel(vertex));
    return { vertex, this->value(vertex) };
  }

  TakenValue takeFurther(Index number)
  {
    LabelSets::Further& further = this->Sets.further(number);
    VertexState state = further.state();
    if (!std::exchange(state.isQueued, false))
    {
      return { NoIndex, 0.0 };
    }
    further.setState(state);
    this->setCurrent(further.label());
    const Index vertex = this->Sets.vertexOf(number);
    return { further.value <= this->keptUpTo(vertex) ? vertex : NoIndex, further.value };
  }

  /** Of vertices some of which have a best value of another label. */
  template <class Real>
  GEODESIC_INLINED KnownValues<Real> lookAtBorder(const Indices<Real>& vertices) const
  {
    using Further = LabelSets::Further;
    const auto second = [&](int lane) -> const Further&
    { return this->Sets.second(vertices[lane]); };
    const TestOf<Real> isBest = whereEqual<Real>(
      this->Current + 1, [&](int lane) { return this->Sets.bestBits(vertices[lane]); });
    const TestOf<Real> isSecond = whereEqual<Real>(
      this->Current + 1, [&](int lane) { return second(lane).bits() & Further::LabelBits; });
    const TestOf<Real> isLast =
      whereEqual<Real>(NoIndex, [&](int lane) { return second(lane).next(); });
    if (any(~(isBest | isSecond | isLast))) [[unlikely]]
    {
      return this->template lookOneByOne<Real>(vertices);
    }
    const KnownValues<Real> best = this->template known<Real>(vertices);
    const Real none = Real() + DistanceField::Unreached;
    const Real values = select(isBest, best.values,
      select(isSecond, lanesOf<Real>([&](int lane) { return second(lane).value; }), none));
    const Real keptUpTo = best.values +
      lanesOf<Real>([&](int lane) { return this->context().cost.margin(vertices[lane]); });
    const TestOf<Real> isQueued = whereEqual<Real>(
      Further::Queued, [&](int lane) { return second(lane).bits() & Further::Queued; });
    return { values, select(isBest | isSecond, values, keptUpTo),
      (bitsOf(isBest) & best.isQueued) | bitsOf(isSecond & isQueued) };
  }

  template <class Real>
  KnownValues<Real> lookOneByOne(const Indices<Real>& vertices) const
  {
    std::array<KnownValue, lanes<Real>> known;
    unsigned areQueued = 0;
    for (std::size_t lane = 0; lane < lanes<Real>; ++lane)
    {
      known[lane] = this->look(vertices[lane]);
      areQueued |= static_cast<unsigned>(known[lane].isQueued) << lane;
    }
    return { lanesOf<Real>([&](int lane) { return known[lane].value; }),
      lanesOf<Real>([&](int lane) { return known[lane].ceiling; }), areQueued };
  }

  KnownValue look(Index vertex) const
  {
    return this->isOther(vertex) == 0
      ? this->known(vertex)
      : this->knownFurther(vertex, this->Sets.find(vertex, this->Current));
  }

  KnownValue knownFurther(Index vertex, Index number) const
  {
    if (number == NoIndex)
    {
      return { DistanceField::Unreached, this->keptUpTo(vertex), false };
    }
    const LabelSets::Further& further = this->Sets.further(number);
    return { further.value, further.value, further.state().isQueued };
  }

  KnownValue proposeFurther(Index vertex, double value)
  {
    Index number = this->Sets.find(vertex, this->Current);
    const KnownValue known = this->knownFurther(vertex, number);
    if (!(value < std::min(this->ceiling(vertex, known.value), this->keptUpTo(vertex))) ||
      this->context().options.isExcluded(vertex) ||
      (number != NoIndex && this->Sets.further(number).state().isPinned))
    {
      return known;
    }
    if (number == NoIndex)
    {
      number = this->Sets.add(vertex, this->Current, value);
    }
    this->setFurther(number, value);
    return { value, value, true };
  }

  void setBest(Index vertex, double value)
  {
    this->Sets.setBestLabel(vertex, this->Current);
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
    VertexState state = further.state();
    if (!std::exchange(state.isQueued, true))
    {
      further.setState(state);
      this->context().queue.push(this->NumberOfVertices + number,
        further.value + this->Labels[further.label()].value - this->firstDistance());
    }
  }

  /** A further value of the current label and the best one change places. */
  void makeBest(Index number)
  {
    LabelSets::Further& further = this->Sets.further(number);
    const Index vertex = this->Sets.vertexOf(number);
    const double value = further.value;
    const Index label = this->Sets.bestLabel(vertex);
    further.setLabel(label);
    further.value = this->context().field.distance(vertex) - this->Labels[label].value;
    VertexState state = std::exchange(this->state(vertex), further.state());
    // Wherever the queue has them, they go to it again under their new numbers.
    const bool wasQueued = std::exchange(state.isQueued, false);
    further.setState(state);
    if (wasQueued)
    {
      this->queueFurther(number);
    }
    this->state(vertex).isQueued = false;
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
  std::vector<StraightLineBound> LeastOf;
  Index Current = 0;
};

}

#endif
