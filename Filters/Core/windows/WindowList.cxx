// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/WindowList.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>

namespace geodesic
{
namespace
{

/** By which fraction of the lengths that make its distance a window must be nearer than one that is
 * there. Of equal ones the first stays. Of the distance itself it would be nothing beside a seed:
 * where sheets lie on each other, rounding would then cut windows into ever more. */
constexpr double LeastWin = 1e-14;

/** Windows that are no farther from each other, in parts of their distance from the edge's lower
 * end, touch. */
constexpr double Gap = 1e-13;

/** Whether the same straight lines make two windows, except for rounding. */
bool haveOneSource(const Window& a, const Window& b)
{
  if (a.seed != b.seed || a.isStraight != b.isStraight)
  {
    return false;
  }
  constexpr double rounding = 1e-13;
  if (a.isStraight)
  {
    return std::abs(a.x - b.x) <= rounding && std::abs(a.y - b.y) <= rounding &&
      std::abs(a.offset - b.offset) <= rounding * (std::abs(a.offset) + a.last);
  }
  const double size = rounding * (std::abs(a.x) + a.y + a.last);
  return a.offset == b.offset && std::abs(a.x - b.x) <= size && std::abs(a.y - b.y) <= size;
}

/** The lengths that make a window's distances, by which their rounding is judged. */
double sizeOf(const Window& window)
{
  return std::abs(window.offset) + window.last +
    (window.isStraight ? 0.0 : std::abs(window.x) + window.y);
}

/** Two windows over a part of the edge that both have. */
class Contest
{
public:
  Contest(const Window& present, const Window& added)
    : Present(present)
    , Added(added)
    , Size(std::max(sizeOf(present), sizeOf(added)))
  {
  }

  /** By how much the added window is farther at a point. */
  double excess(double at) const
  {
    return (this->Added.offset - this->Present.offset) +
      (this->Added.lineTo(at) - this->Present.lineTo(at));
  }

  /** Whether the added window counts at a point. */
  bool wins(double at) const { return this->excess(at) < -LeastWin * this->Size; }

  /** A point from @p from to @p to where both are equally near. @pre they differ in who wins */
  double crossing(double from, double to) const
  {
    for (const double root : this->roots())
    {
      if (root > from && root < to && this->isTie(root))
      {
        return root;
      }
    }
    // Both are equally near at an end, or rounding spoilt the formula.
    if (this->isTie(from) || this->isTie(to))
    {
      return this->isTie(from) ? from : to;
    }
    const bool winsFirst = this->wins(from);
    constexpr int mostSteps = 60;
    for (int i = 0; i < mostSteps; ++i)
    {
      const double middle = 0.5 * (from + to);
      (this->wins(middle) == winsFirst ? from : to) = middle;
    }
    return 0.5 * (from + to);
  }

private:
  bool isTie(double at) const
  {
    constexpr double rounding = 1e-13;
    return std::abs(this->excess(at)) <= rounding * this->Size;
  }

  /** Where the edge's line may cross the hyperbola of points to which both are equally near. */
  std::array<double, 2> roots() const
  {
    const Window& p = this->Present;
    const Window& a = this->Added;
    if (p.isStraight && a.isStraight)
    {
      const double root = (a.offset - p.offset) / (p.x - a.x);
      return { root, root };
    }
    if (p.isStraight || a.isStraight)
    {
      return p.isStraight ? rootsWith(p, a) : rootsWith(a, p);
    }
    const double apart = a.x - p.x;
    const double gain = p.offset - a.offset;
    const double k = apart * apart + (a.y - p.y) * (a.y + p.y) - gain * gain;
    if (gain == 0.0)
    {
      const double root = p.x + 0.5 * k / apart;
      return { root, root };
    }
    const double square = (apart - gain) * (apart + gain);
    const double root = std::sqrt(std::max(0.0, k * k + 4.0 * p.y * p.y * square));
    const double q = k * apart + std::copysign(gain * root, k * apart);
    const double product = (0.5 * k - gain * p.y) * (0.5 * k + gain * p.y);
    return { p.x + 0.5 * q / square, p.x + 2.0 * product / q };
  }

  /** The same with a straight front: where its distance is that of a round one. */
  static std::array<double, 2> rootsWith(const Window& straight, const Window& round)
  {
    // Below the round front's source, the straight one is by so much farther than that.
    const double gain = straight.offset + straight.x * round.x - round.offset;
    const double root =
      std::sqrt(std::max(0.0, (gain - straight.y * round.y) * (gain + straight.y * round.y)));
    const double q = gain * straight.x + std::copysign(root, gain * straight.x);
    return { round.x + q / (straight.y * straight.y),
      round.x + (round.y - gain) * (round.y + gain) / q };
  }

  const Window& Present;
  const Window& Added;
  double Size;
};

/** Joins the parts of windows that are kept, one after the other, into windows. */
class Pieces
{
public:
  /** @param owner a number for the window, the same for all its parts */
  void add(const Window& window, std::ptrdiff_t owner, double first, double last)
  {
    if (!(first < last))
    {
      return;
    }
    if (this->LastOwner == owner && !this->Windows.empty() && this->Windows.back().last == first)
    {
      this->Windows.back().last = last;
      return;
    }
    this->LastOwner = owner;
    this->Windows.push_back(window);
    this->Windows.back().first = first;
    this->Windows.back().last = last;
  }

  void clear()
  {
    this->Windows.clear();
    this->LastOwner = NoOwner;
  }

  std::vector<Window> Windows;

private:
  static constexpr std::ptrdiff_t NoOwner = -2;
  std::ptrdiff_t LastOwner = NoOwner;
};

/** The number of the window that is added to a list; those that are there have their places'. */
constexpr std::ptrdiff_t AddedOwner = -1;

/** Gives each point from @p first to @p last to the nearer of two windows: calls @p give with
 * whether the added one has it, and the ends of a part. */
template <class Give>
void divide(const Window& present, const Window& added, double first, double last, const Give& give)
{
  const Contest contest(present, added);
  std::array<double, 3> ends{ first, last, last };
  std::size_t parts = 1;
  if (present.offset != added.offset || present.isStraight != added.isStraight)
  {
    // Two points of one offset have at most one crossing; others may have one on either side.
    const double turn = turningPoint(present, added);
    if (turn > first && turn < last)
    {
      ends[1] = turn;
      parts = 2;
    }
  }
  bool before = contest.wins(first);
  for (std::size_t i = 0; i < parts; ++i)
  {
    const double to = ends[i + 1];
    const bool after = contest.wins(to);
    const double middle = before == after ? to : contest.crossing(ends[i], to);
    give(before, ends[i], middle);
    give(after, middle, to);
    before = after;
  }
}

/** The place from which a window is nearer than one that begins before it and ends within it, if
 * there is only one such place. */
std::optional<double> takeOver(const Window& present, const Window& window)
{
  if (present.offset == window.offset && window.x > present.x && !present.isStraight &&
    !window.isStraight)
  {
    // The difference of the squared lengths is linear along the edge.
    const double apart = window.x - present.x;
    const double atOrigin =
      apart * (window.x + present.x) + (window.y - present.y) * (window.y + present.y);
    const double place = 0.5 * atOrigin / apart;
    return place > window.first && place < present.last ? std::optional(place) : std::nullopt;
  }
  const Contest contest(present, window);
  const bool winsAtFirst = contest.wins(window.first);
  const bool winsAtLast = contest.wins(present.last);
  const double turn = turningPoint(present, window);
  // Else the windows may change places twice.
  if (winsAtFirst
      ? present.first == window.first || !winsAtLast || (turn > window.first && turn < present.last)
      : !winsAtLast && turn > window.first && turn < present.last)
  {
    return std::nullopt;
  }
  // Where each wins at its own end, they change places once.
  return winsAtFirst ? window.first
    : winsAtLast     ? contest.crossing(window.first, present.last)
                     : present.last;
}

}

void WindowList::append(const Window& window, double first)
{
  if (!this->Windows.empty() && haveOneSource(this->Windows.back(), window))
  {
    Window& last = this->Windows.back();
    if (first - last.last <= Gap * window.last)
    {
      last.last = window.last;
      last.excess = std::max(last.excess, window.excess);
      return;
    }
  }
  this->Windows.push_back(window);
  this->Windows.back().first = first;
}

bool WindowList::insertBehind(const Window& window)
{
  Window& present = this->Windows.back();
  if (present.first > window.first || present.last >= window.last)
  {
    return false;
  }
  if (present.last - window.first <= Gap * window.last)
  {
    this->append(window, present.last);
    return true;
  }
  const std::optional<double> place = takeOver(present, window);
  if (place)
  {
    present.last = *place;
    this->Windows.push_back(window);
    this->Windows.back().first = *place;
  }
  return place.has_value();
}

void WindowList::insertAll(std::span<const Window> windows)
{
  static thread_local std::vector<Window> present;
  present.clear();
  const bool isBehind =
    this->Windows.empty() || windows.empty() || this->Windows.back().first <= windows.front().first;
  if (!isBehind)
  {
    this->Windows.swap(present);
  }
  auto next = present.begin();
  for (const Window& window : windows)
  {
    for (; next != present.end() && next->first <= window.first; ++next)
    {
      this->insert(*next);
    }
    this->insert(window);
  }
  for (; next != present.end(); ++next)
  {
    this->insert(*next);
  }
}

void WindowList::appendNearer(const Window& window, std::vector<Window>& parts) const
{
  static thread_local Pieces pieces;
  pieces.clear();
  double reached = window.first;
  auto present = std::partition_point(this->Windows.begin(), this->Windows.end(),
    [&](const Window& w) { return w.last <= window.first; });
  for (; present != this->Windows.end() && present->first < window.last; ++present)
  {
    pieces.add(window, AddedOwner, reached, present->first);
    const double first = std::max(reached, present->first);
    const double last = std::min(window.last, present->last);
    divide(*present, window, first, last,
      [&](bool toAdded, double from, double to)
      {
        if (toAdded)
        {
          pieces.add(window, AddedOwner, from, to);
        }
      });
    reached = last;
  }
  pieces.add(window, AddedOwner, reached, window.last);
  parts.insert(parts.end(), pieces.Windows.begin(), pieces.Windows.end());
}

void WindowList::insertAmong(const Window& window)
{
  static thread_local Pieces pieces;
  pieces.clear();
  std::vector<Window>& all = this->Windows;
  auto begin = all.end();
  while (begin != all.begin() && std::prev(begin)->last > window.first)
  {
    --begin;
  }
  double reached = window.first;
  auto end = begin;
  for (; end != all.end() && end->first < window.last; ++end)
  {
    const std::ptrdiff_t owner = end - all.begin();
    pieces.add(*end, owner, end->first, std::min(end->last, reached));
    pieces.add(window, AddedOwner, reached, end->first);
    reached = std::max(reached, end->first);
    const double last = std::min(window.last, end->last);
    divide(*end, window, reached, last,
      [&](bool toAdded, double from, double to)
      { pieces.add(toAdded ? window : *end, toAdded ? AddedOwner : owner, from, to); });
    pieces.add(*end, owner, last, end->last);
    reached = std::max(reached, end->last);
  }
  pieces.add(window, AddedOwner, reached, window.last);
  // The list from begin to end is replaced; most often it is one window by one or two.
  const std::size_t old = static_cast<std::size_t>(end - begin);
  const std::size_t same = std::min(old, pieces.Windows.size());
  const auto newEnd = pieces.Windows.begin() + static_cast<std::ptrdiff_t>(same);
  const auto next = std::copy(pieces.Windows.begin(), newEnd, begin);
  if (same < old)
  {
    all.erase(next, end);
  }
  else
  {
    all.insert(next, newEnd, pieces.Windows.end());
  }
}

}
