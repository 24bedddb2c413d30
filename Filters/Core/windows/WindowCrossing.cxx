// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// How the windows of a front cross a triangle, and what of them goes on.
#include "windows/WindowFront.h"

#include "base/WorkCount.h"
#include "windows/LaidTriangle.h"
#include "windows/WindowLine.h"
#include "windows/WindowMerging.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{
namespace
{

/** By which fraction of the distance another path must be shorter to take the place of a window.
 * It lies above all rounding: a window that is as short as the other path must stay, as nobody else
 * may follow that path further. Where all vertices are turns, they follow it, and the window must
 * be shorter by as much. */
constexpr double Margin = 1e-11;
/** A window no wider than this fraction of the distance is made by rounding alone. */
constexpr double Narrowest = 1e-14;

/**
 * How far from the lower end of an edge paths by that end are shorter than the straight lines of a
 * window. The excess of the lines over these paths falls from the end on.
 * @param known  the distance at the end less the window's offset
 */
double reachOfLower(const Window& window, double known)
{
  const double x = window.x;
  const double y = window.y;
  return window.isStraight ? known / (x - 1.0)
                           : (x * x + y * y - known * known) / (2.0 * (x + known));
}

/** The same from the higher end: where paths by that end begin to be shorter. */
double reachOfHigher(const Window& window, double length, double known)
{
  const double x = length - window.x;
  const double y = window.y;
  return window.isStraight ? (length + known) / (1.0 + window.x)
                           : length - (x * x + y * y - known * known) / (2.0 * (x + known));
}

/** Whether the distance of a window at a point, less the offset, is larger than a bound. */
bool isLineLonger(const Window& window, double at, double bound)
{
  if (window.isStraight)
  {
    return window.x * at > bound;
  }
  const double along = at - window.x;
  return bound < 0.0 || along * along + window.y * window.y > bound * bound;
}

}

double WindowFront::shortestToGoal(const Window& window, const PlanePoint& goal) const
{
  // With the goal laid on the other side of the edge, the shortest path is straight, or passes an
  // end of the window.
  const double at = window.placeTowards(goal.x, goal.y);
  const double place = std::clamp(at, window.first, window.last);
  return window.distanceAt(place) + this->Limit.goal().leftOf(std::hypot(goal.x - place, goal.y));
}

void WindowFront::cutOffered(const Target& target)
{
  // It is changed where it lies: to copy what was just written in parts would wait for these.
  Window& window = this->Offered.back();
  // The way of a straight front is no length.
  const double source = window.isStraight ? 0.0 : std::abs(window.x) + window.y;
  const double size = std::abs(window.offset) + source + target.length;
  const double margin = size * (this->DoesRemember ? -Margin : Margin);
  const double lower = target.atLower - window.offset + margin;
  const double higher = target.atHigher - window.offset + margin;
  const double length = target.length;
  if (isLineLonger(window, window.last, lower + window.last) ||
    isLineLonger(window, window.first, higher + (length - window.first)))
  {
    this->Offered.pop_back();
    return;
  }
  if (isLineLonger(window, window.first, lower + window.first))
  {
    const double cut = reachOfLower(window, lower);
    window.first = cut > window.first && cut < window.last ? cut : window.first;
  }
  if (isLineLonger(window, window.last, higher + (length - window.last)))
  {
    const double cut = reachOfHigher(window, length, higher);
    window.last = cut > window.first && cut < window.last ? cut : window.last;
  }
  const double least = window.leastDistance();
  if (!(window.last - window.first > Narrowest * size) || least > this->Limit.value())
  {
    this->Offered.pop_back();
    return;
  }
  double key = least;
  if (this->Limit.goal().isKnown())
  {
    const double shortest = this->shortestToGoal(window, target.goal);
    if (shortest > this->Limit.value())
    {
      this->Offered.pop_back();
      return;
    }
    key += PartOfOrder * std::max(shortest - least, 0.0);
  }
  this->LeastKey = std::min(this->LeastKey, key);
}

void WindowFront::letOfferedWait(Index halfEdge)
{
  if (!this->Offered.empty())
  {
    if (this->isJunction(halfEdge))
    {
      this->waitAtJunction(halfEdge);
    }
    else
    {
      this->waitAt(this->Edges.next(halfEdge));
    }
  }
  this->Offered.clear();
  this->LeastKey = DistanceField::Unreached;
}

void WindowFront::waitAtJunction(Index halfEdge)
{
  if (this->Work.junctions.wait(
        this->Edges, this->Passable, halfEdge, this->Offered, this->LeastKey))
  {
    this->Work.queue.push(this->Edges.first(halfEdge), this->LeastKey - this->First);
  }
}

bool WindowFront::passJunction(Index first)
{
  const Junctions::Junction& junction = this->Work.junctions.pass(first, this->Passing);
  for (const Index side : junction.sides)
  {
    this->Crossing.clear();
    WorkCount::add(this->Passing.size());
    for (const auto& [window, from] : this->Passing)
    {
      if (from != side)
      {
        this->Crossing.insert(window);
      }
    }
    if (!this->Crossing.isEmpty())
    {
      this->crossTriangle(side);
    }
    if (!this->mayGoOn())
    {
      return false;
    }
  }
  return true;
}

void WindowFront::waitAt(Index halfEdge)
{
  Index& place = this->Work.places[halfEdge];
  bool isFirst = false;
  if (place == NoIndex)
  {
    isFirst = true;
    if (this->Work.free.empty())
    {
      this->Work.free.push_back(static_cast<Index>(this->Work.waiting.size()));
      this->Work.waiting.emplace_back();
    }
    place = this->Work.free.back();
    this->Work.free.pop_back();
  }
  WindowWorkspace::Waiting& waiting = this->Work.waiting[place];
  const std::size_t before = waiting.list.bytes();
  waiting.list.insertAll(this->Offered);
  this->Work.bytes += waiting.list.bytes() - before;
  if (isFirst || this->LeastKey < waiting.key)
  {
    waiting.key = this->LeastKey;
    waiting.halfEdge = halfEdge;
    this->Work.queue.push(halfEdge, this->LeastKey - this->First);
  }
}

void WindowFront::reachApex(
  Index halfEdge, const LaidTriangle& laid, std::span<const Window> windows)
{
  const double miss = LineMiss * laid.length;
  this->BesideApex.clear();
  for (const Window& w : windows)
  {
    const double at = w.placeTowards(laid.x, laid.y);
    this->BesideApex.push_back(at);
    if ((at < w.first - miss || at > w.last + miss) && w.y + laid.y > 0.0)
    {
      continue;
    }
    if (const auto line = lineTo(w, halfEdge, laid.x, laid.y, laid.length))
    {
      this->reach(laid.apex, line->distance, w.seed, line->arrival, w.excess);
    }
  }
}

void WindowFront::reachStarts(
  Index halfEdge, const LaidTriangle& laid, std::span<const Window> windows)
{
  this->Work.starts.visitIn(laid.triangle,
    [&](PathStarts::Start& start)
    {
      const auto [x, y] =
        placeBeside(this->Mesh, laid.lower, laid.higher, laid.length, start.position);
      for (const Window& w : windows)
      {
        if (const auto line = lineTo(w, halfEdge, x, y, laid.length))
        {
          PathStarts::reach(start, line->distance + w.excess, w.seed, line->arrival);
        }
      }
    });
}

void WindowFront::crossTo(const LaidTriangle& laid, std::span<const Window> windows, bool isLower)
{
  const Index corner = isLower ? laid.lower : laid.higher;
  const Index opposite = isLower ? laid.higher : laid.lower;
  const Index side = laid.halfEdgeOpposite(this->Mesh, opposite);
  if (!this->leadsOn(side))
  {
    return;
  }
  const double length = edgeLength(this->Mesh, corner, laid.apex);
  if (!(length > 0.0))
  {
    return;
  }
  const Target target = this->targetOf(side, corner, laid.apex, length);
  // All is measured from the corner: x along the crossed edge, and along the side to the apex.
  const double apexX = isLower ? laid.x : laid.length - laid.x;
  const double alongX = apexX / length;
  const double alongY = laid.y / length;
  const bool isTurned = laid.apex < corner;
  const auto pass = [&]<bool isStraight>(const Window& w, double besideApex)
  {
    const double atApex = isLower ? besideApex : laid.length - besideApex;
    const double first = isLower ? w.first : laid.length - w.last;
    if (!(first < atApex))
    {
      return;
    }
    const double last = isLower ? w.last : laid.length - w.first;
    const double sourceX = isStraight ? (isLower ? -w.x : w.x) : isLower ? w.x : laid.length - w.x;
    const auto onSide = [&](double at)
    {
      const double across = isStraight ? -sourceX : at - sourceX;
      const double place = at * w.y / (alongX * w.y - alongY * across);
      return std::clamp(place, 0.0, length);
    };
    const double from = first > 0.0 ? onSide(first) : 0.0;
    const double to = last < atApex ? onSide(last) : length;
    if (!(from < to))
    {
      return;
    }
    Window& next = this->Offered.emplace_back(w);
    next.first = from;
    next.last = to;
    next.x = sourceX * alongX - w.y * alongY;
    next.y = std::max(0.0, alongX * w.y + alongY * sourceX);
    if (isStraight)
    {
      // A source lies above the crossed edge, the way of a straight front goes down.
      const double size = std::hypot(next.x, next.y);
      next.x /= -size;
      next.y /= size;
      next.offset = isLower ? w.offset : w.offset + w.x * laid.length;
    }
    if (isTurned)
    {
      next.turn(length);
    }
    this->cutOffered(target);
  };
  const auto passAny = [&](std::size_t i)
  {
    if (windows[i].isStraight)
    {
      pass.template operator()<true>(windows[i], this->BesideApex[i]);
    }
    else
    {
      pass.template operator()<false>(windows[i], this->BesideApex[i]);
    }
  };
  // In the order in which they lie on the side, so that each goes to the end of the list.
  for (std::size_t i = 0; i < windows.size(); ++i)
  {
    passAny(isLower != isTurned ? i : windows.size() - 1 - i);
  }
  this->letOfferedWait(side);
}

void WindowFront::keepForPaths(Index halfEdge, std::span<const Window> windows)
{
  if (this->Work.kept.areWanted())
  {
    const std::size_t before = this->Work.kept.bytes();
    this->Work.kept.keep(halfEdge, windows);
    this->Work.bytes += this->Work.kept.bytes() - before;
  }
}

void WindowFront::takeWaiting(Index halfEdge)
{
  Index& place = this->Work.places[halfEdge];
  this->Crossing.clear();
  this->Crossing.swap(this->Work.waiting[place].list);
  this->Work.free.push_back(place);
  place = NoIndex;
}

void WindowFront::crossTriangle(Index halfEdge)
{
  if (this->Merging)
  {
    this->Merging->merge(this->Crossing);
  }
  const std::span<const Window> windows = this->Crossing.windows();
  this->keepForPaths(halfEdge, windows);
  const LaidTriangle laid(this->Mesh, halfEdge);
  this->reachApex(halfEdge, laid, windows);
  this->reachStarts(halfEdge, laid, windows);
  this->crossTo(laid, windows, true);
  this->crossTo(laid, windows, false);
  this->Crossed += windows.size();
  this->Takes += 1 + windows.size() / ManyWindows;
  WorkCount::add(windows.size());
}

}
