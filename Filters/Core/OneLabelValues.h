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
    this->setOffset(label.value);
  }

  Index current() const { return 0; }
  void setCurrent(Index) {}
  FrontShape shape() const { return this->Shape; }

  template <class Real>
  GEODESIC_INLINED KnownValues<Real> look(const Indices<Real>& vertices) const
  {
    return this->template known<Real>(vertices);
  }

  KnownValue propose(Index vertex, double value)
  {
    return this->offer(vertex, this->LeastOf.raised(value, this->position(vertex)));
  }

  void start(Index vertex, double value, bool isFinal)
  {
    this->set(vertex, value);
    this->state(vertex).isPinned = isFinal;
  }

  Index vertexOf(Index taken) const { return taken; }
  TakenValue take(Index vertex)
  {
    this->state(vertex).isQueued = false;
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
  void clear(Index vertex) { this->state(vertex) = {}; }

private:
  StraightLineBound LeastOf;
  Index Seed;
  FrontShape Shape;
};

}

#endif
