#include "DistanceField.h"

#include <algorithm>

namespace geodesic
{

void DistanceField::reset()
{
  for (Index vertex : this->Reached)
  {
    this->Distances[vertex] = Unreached;
    this->NearestSeeds[vertex] = NoIndex;
  }
  this->Reached.clear();
  this->LargestDistance = 0.0;
  this->Reason = StopReason::Exhausted;
}

void DistanceField::orderReached()
{
  constexpr std::size_t least = 8;
  if (this->Reached.size() < this->Distances.size() / least)
  {
    return;
  }
  std::size_t count = 0;
  for (Index vertex = 0; count < this->Reached.size(); ++vertex)
  {
    this->Reached[count] = vertex;
    count += this->isReached(vertex) ? 1 : 0;
  }
}

void DistanceField::finish(double limit, StopReason reason)
{
  this->Reason = reason;
  this->LargestDistance = 0.0;
  std::erase_if(this->Reached,
    [&](Index vertex)
    {
      if (this->Distances[vertex] > limit)
      {
        this->Distances[vertex] = Unreached;
        this->NearestSeeds[vertex] = NoIndex;
        return true;
      }
      this->LargestDistance = std::max(this->LargestDistance, this->Distances[vertex]);
      return false;
    });
}

}
