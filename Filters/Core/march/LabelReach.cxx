// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/LabelReach.h"

#include "base/Vector3.h"
#include "base/WorkCount.h"
#include "march/CircleArcs.h"
#include "march/LabelPlaces.h"
#include "march/PlaceGrid.h"
#include "solve/SeedFront.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <tuple>

namespace geodesic
{
namespace
{

/** The first distance at which labels end, in edges; and the factor from each to the next. */
constexpr double FirstReach = 3.0;
constexpr double ReachStep = 1.5;
/** The search for other labels goes as far as this many times the distance sideways at which the
 * error is the largest one. */
constexpr double SearchRadius = 2.0;
/** The side of the cubes of the search: a ball touches 3.4 such cubes in the mean. */
constexpr double CubeInRadii = 2.0;
/** Only labels at which the surface has nearly the same direction stand for each other. */
constexpr double LeastCosine = 0.7;
/** A label closer than this many edges to another one, of no larger value, ends where it starts. */
constexpr double LeastSpacing = 0.1;
/** Moves what is often the same for many places, as 0 and 1 are, away from where one cube ends and
 * the next begins. What rounding leaves of such a number would decide there. */
constexpr double Offset = 0.377;
/** A straight front goes on for this many squares of its length, and for two edges at least. */
constexpr double ReachOfSquaredLength = 2.5;
constexpr double LeastReachOfStraight = 2.0;
/** How often goesOn() is called. */
constexpr std::size_t LabelsOfReport = 512;

/** A number for the cube of a place, whose diagonal is at most the least spacing there. Places in
 * different cubes hardly ever have the same one. */
std::uint64_t cubeOf(const LabelPlace& place)
{
  const double exponent = std::floor(std::log2(place.edge) - Offset);
  const double perSide = std::sqrt(3.0) / (LeastSpacing * std::exp2(exponent));
  std::uint64_t cube = 0;
  for (const double x : { exponent, place.position.x * perSide, place.position.y * perSide,
         place.position.z * perSide })
  {
    // Fibonacci hashing, see Knuth, The Art of Computer Programming 3, section 6.4.
    constexpr std::uint64_t goldenRatio = 0x9e3779b97f4a7c15u;
    cube = (cube ^ std::bit_cast<std::uint64_t>(std::floor(x + Offset))) * goldenRatio;
    cube ^= cube >> 32;
  }
  return cube;
}

/** Ends the labels that are close to another one of no larger value. Time O(k log k), and O(k)
 * where few are close. */
void endCrowded(const std::vector<LabelPlace>& places, std::vector<Index>& numbers,
  std::vector<LabelReach>& reaches)
{
  // Only labels that share a bucket may share a cube.
  std::vector<std::uint64_t> cubes;
  cubes.reserve(numbers.size());
  const int shift = std::countl_zero(numbers.size() | 1) - 1;
  std::vector<std::uint8_t> members(std::size_t{ 2 } << (63 - shift));
  for (const Index number : numbers)
  {
    cubes.push_back(cubeOf(places[number]));
    std::uint8_t& known = members[cubes.back() >> shift];
    known = known == 0 ? 1 : 2;
  }
  std::vector<std::tuple<std::uint64_t, double, Index>> sorted;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (members[cubes[i] >> shift] == 2)
    {
      sorted.emplace_back(cubes[i], places[numbers[i]].value, numbers[i]);
    }
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0, first = 0; i < sorted.size(); ++i)
  {
    if (std::get<0>(sorted[i]) != std::get<0>(sorted[first]))
    {
      first = i;
    }
    const Index number = std::get<2>(sorted[i]);
    const LabelPlace& place = places[number];
    const LabelPlace& other = places[std::get<2>(sorted[first])];
    if (i != first && norm(place.position - other.position) <= LeastSpacing * place.edge &&
      dot(place.normal, other.normal) >= LeastCosine)
    {
      reaches[number].value = 0.0;
    }
  }
  std::erase_if(numbers, [&](Index number) { return reaches[number].isFinite(); });
}

/** One step of the thinning: chooses which of some labels go on beyond a distance. */
class ThinningStep
{
public:
  /**
   * @param numbers   of the labels, in increasing order
   * @param reach     the distance, in edges
   * @param farthest  of what lasts, labels whose distance is not less stay without a look at them
   */
  ThinningStep(const std::vector<LabelPlace>& places, const std::vector<Index>& numbers,
    double reach, const LabelThinning& thinning, double farthest,
    const std::function<bool()>& goesOn)
    : Places(places)
    , Reach(reach)
    , MostError(thinning.mostError)
    , Radius(SearchRadius * std::sqrt(2.0 * thinning.mostError * reach))
    , MostRadius(this->Radius * meanEdge(places, numbers))
    , Grid(numbers, CubeInRadii * this->MostRadius,
        [&](Index number) { return places[number].position; })
    , States(places.size(), State::Open)
  {
    for (const Index number : numbers)
    {
      if (reach >= thinning.lasting && !(reach * places[number].unit() < farthest))
      {
        this->States[number] = State::Stays;
      }
    }
    for (std::size_t i = 0; i < numbers.size() && (i % LabelsOfReport > 0 || goesOn()); ++i)
    {
      if (State& state = this->States[numbers[i]]; state == State::Open)
      {
        state = this->mayEnd(numbers[i]) ? State::Ends : State::Stays;
      }
    }
  }

  bool ends(Index number) const { return this->States[number] == State::Ends; }

private:
  enum class State : std::uint8_t
  {
    Open,
    Stays,
    Ends
  };

  /** A label that can stand for another one in the directions of an arc. */
  struct Substitute
  {
    Index number;
    double distance;
    double centre;
    double half;
  };

  static double meanEdge(const std::vector<LabelPlace>& places, const std::vector<Index>& numbers)
  {
    double sum = 0.0;
    for (const Index number : numbers)
    {
      sum += places[number].edge;
    }
    return sum / static_cast<double>(numbers.size());
  }

  /** Half of the arc of directions whose component along a vector of length @p flat is at least
   * @p least; less than 0 if there is none. */
  static double halfArc(double least, double flat)
  {
    if (least <= -flat)
    {
      return std::numbers::pi;
    }
    return least < flat ? std::acos(least / flat) : -1.0;
  }

  /** Whether the labels that stay can stand for a label; if so, open ones that are needed for that
   * stay from now on. */
  bool mayEnd(Index number)
  {
    this->Covered.clear();
    this->Open.clear();
    this->lookAround(number);
    if (this->Covered.coverAll())
    {
      return true;
    }
    // Those far away come first, so that few are needed.
    std::sort(this->Open.begin(), this->Open.end(),
      [](const Substitute& a, const Substitute& b)
      { return std::tuple(-a.distance, a.number) < std::tuple(-b.distance, b.number); });
    CircleArcs covered = this->Covered;
    std::size_t count = 0;
    while (count < this->Open.size() && !covered.coverAll())
    {
      covered.add(this->Open[count].centre, this->Open[count].half);
      ++count;
    }
    if (!covered.coverAll())
    {
      return false;
    }
    this->Open.resize(count);
    this->dropNeedless();
    for (const Substitute& needed : this->Open)
    {
      this->States[needed.number] = State::Stays;
    }
    return true;
  }

  /** Notes the directions in which others are nearer or may stand for a label, as far as they stay;
   * and the open ones. */
  void lookAround(Index number)
  {
    const LabelPlace& place = this->Places[number];
    const double radius = std::min(this->Radius * place.edge, this->MostRadius);
    const double reach = this->Reach * place.edge;
    const double error = this->MostError * place.edge;
    const Vector3 axis =
      std::abs(place.normal.x) < 0.6 ? Vector3{ 1.0, 0.0, 0.0 } : Vector3{ 0.0, 1.0, 0.0 };
    const Vector3 side = cross(place.normal, axis);
    const Vector3 first = 1.0 / std::max(norm(side), 0.5) * side;
    const Vector3 second = cross(place.normal, first);
    this->Grid.visitNear(place.position, radius,
      [&](Index other)
      {
        WorkCount::add(1);
        const LabelPlace& there = this->Places[other];
        const Vector3 away = there.position - place.position;
        const double distance = norm(away);
        if (other == number || distance > radius || dot(there.normal, place.normal) < LeastCosine)
        {
          return;
        }
        const double x = dot(away, first);
        const double y = dot(away, second);
        const double flat = std::sqrt(x * x + y * y);
        // In a direction u the other one is farther by distance² / (2 reach) - away·u.
        const double least = distance * distance / (2.0 * reach) + there.value - place.value;
        const State state = this->States[other];
        // One that stays covers where it is nearly as near; another one where it is nearer. One at
        // the same place is no nearer.
        const double mostCovered = state == State::Stays ? least - error : least;
        const bool covers = mostCovered < flat;
        const bool mayCover = state == State::Open && least - error < flat;
        if (!covers && !mayCover)
        {
          return;
        }
        const double centre = std::atan2(y, x);
        if (covers)
        {
          this->Covered.add(centre, halfArc(mostCovered, flat));
        }
        if (mayCover)
        {
          this->Open.push_back({ other, distance, centre, halfArc(least - error, flat) });
        }
      });
  }

  /** Removes from Open, from the nearest on, those without which the others are enough. */
  void dropNeedless()
  {
    for (std::size_t i = this->Open.size(); i-- > 0;)
    {
      CircleArcs others = this->Covered;
      for (std::size_t j = 0; j < this->Open.size(); ++j)
      {
        if (j != i)
        {
          others.add(this->Open[j].centre, this->Open[j].half);
        }
      }
      if (others.coverAll())
      {
        this->Open.erase(this->Open.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }

  const std::vector<LabelPlace>& Places;
  double Reach;
  double MostError;
  /** Of the search, in edges; and its largest length. */
  double Radius;
  double MostRadius;
  PlaceGrid Grid;
  /** By the number of the label. */
  std::vector<State> States;
  // Of the label that is looked at.
  CircleArcs Covered;
  std::vector<Substitute> Open;
};

}

std::vector<LabelReach> labelReaches(const TriangleMesh& mesh, const SeedFront& front,
  std::span<const double> cost, double farthest, const LabelThinning& thinning,
  const std::function<bool()>& goesOn, Partition& partition)
{
  std::vector<LabelReach> reaches(front.labels.size());
  if (farthest == 0.0)
  {
    return reaches;
  }
  const std::vector<LabelPlace> places = labelPlaces(mesh, front, cost, goesOn, partition);
  std::vector<Index> numbers;
  double mostEdges = 0.0;
  for (Index number = 0; number < reaches.size(); ++number)
  {
    const LabelPlace& place = places[number];
    const double edge = place.unit();
    // A label without starts, as on excluded vertices, has no edge.
    if (!(edge > 0.0))
    {
      continue;
    }
    if (front.labels[number].shape == FrontShape::Straight)
    {
      const double length = front.labels[number].length / place.edge;
      reaches[number].value =
        edge * std::max(ReachOfSquaredLength * length * length, LeastReachOfStraight);
      continue;
    }
    // None can stand for one where the surface has no direction, as on triangles without area.
    if (place.normal == Vector3{ 0.0, 0.0, 0.0 })
    {
      continue;
    }
    numbers.push_back(number);
    mostEdges = std::max(mostEdges, farthest / edge);
  }
  endCrowded(places, numbers, reaches);
  // What lasts must not depend on how far the field goes.
  mostEdges = std::max(mostEdges, thinning.lasting);
  for (double reach = FirstReach; reach < mostEdges && numbers.size() > 1 && goesOn();
       reach *= ReachStep)
  {
    const ThinningStep step(places, numbers, reach, thinning, farthest, goesOn);
    std::erase_if(numbers,
      [&](Index number)
      {
        if (step.ends(number))
        {
          reaches[number].value = reach * places[number].unit();
        }
        return step.ends(number);
      });
  }
  for (Index number = 0; number < reaches.size(); ++number)
  {
    if (!(reaches[number].value < thinning.lasting * places[number].unit()))
    {
      reaches[number].allowance = thinning.allowance * places[number].unit();
    }
  }
  return reaches;
}

}
