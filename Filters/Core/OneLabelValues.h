#ifndef geodesic_OneLabelValues_h
#define geodesic_OneLabelValues_h

#include "FieldValues.h"
#include "MarchingFront.h"

namespace geodesic
{

/** The values of the only label: the field itself, but for the value of the seed. */
template <class Cost>
class OneLabelValues : public FieldValues<Cost>
{
public:
  OneLabelValues(const MarchContext<Cost>& context, const Label& label)
    : FieldValues<Cost>(context, label.value)
    , LeastOf(label, context.cost.smallest())
    , Seed(label.seed)
    , Shape(label.shape)
  {
    FieldValues<Cost>::setCurrent(0, label.value);
  }

  static constexpr bool hasOthers = false;
  Index current() const { return 0; }
  void setCurrent(Index) {}
  FrontShape shape() const { return this->Shape; }

  template <class Real>
  GEODESIC_INLINED SeenValues<Real> look(const Indices<Real>& vertices) const
  {
    return { this->template values<Real>(vertices), 0,
      highestBits<Real>(this->template marks<Real>(vertices)) };
  }

  KnownValue propose(Index vertex, double value)
  {
    return this->offer(vertex, this->LeastOf.raised(value, this->position(vertex)));
  }

  void start(Index vertex, double value, bool isFinal)
  {
    this->set(vertex, value);
    this->mark(vertex).setPinned(isFinal);
  }

  Index vertexOf(Index taken) const { return taken; }
  TakenValue take(Index vertex)
  {
    this->mark(vertex).setQueued(false);
    return { vertex, this->value(vertex) };
  }

  void visit(Index vertex, const MarchingFront::Visit& visit) const
  {
    if (this->context().field.isReached(vertex))
    {
      visit(0, this->value(vertex));
    }
  }

  Index nearestSeed(Index) const { return this->Seed; }
  void clear(Index vertex) { this->mark(vertex) = {}; }

private:
  StraightLineBound LeastOf;
  Index Seed;
  FrontShape Shape;
};

}

#endif
