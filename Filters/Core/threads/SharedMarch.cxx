// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "threads/SharedMarch.h"

#include "mesh/TriangleMesh.h"
#include "solve/MarchControl.h"

#include <chrono>
#include <cstdint>

namespace geodesic
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
/** A round in which all threads together make no more updates takes longer to agree on than to
 * compute. */
constexpr std::size_t FewUpdates = 64;
/** The least step of the limit from round to round, in mean edges: the second one where threads
 * take turns on a processor, so that they hear of each other between turns only. */
constexpr double StepInEdges = 8.0;
constexpr double StepInTurns = 3.0;
/** Ranges are cut anew where a queue takes longer than the mean by this part of it and by so many
 * vertices of usual pace. */
constexpr double PartOfExcess = 1.0 / 12.0;
constexpr double LeastExcess = 4.0;
/** A round of fewer vertices says nothing about a thread's pace. Of others, each counts for this
 * part of it: the more, the faster it follows, and the more a round that something else delayed
 * counts. */
constexpr std::size_t LeastTimed = 32;
constexpr double PartOfRound = 0.125;
/** How far a thread goes on while it would wait for others, in mean edges. What it does too early
 * it does in vain. */
constexpr double MostAhead = 1.5;
/** How often a thread that is asked whether it goes on, after a dozen vertices each time, looks
 * into its mailboxes: more often, it would take up many letters one by one. */
constexpr std::size_t CallsOfExchange = 4;
/** A front is short where fewer vertices wait for each thread. */
constexpr std::size_t MostOfShort = 8;
/** With several labels what waits is much to do where as many items wait for each thread. */
constexpr std::size_t MuchWork = 1024;
std::size_t shortFront(std::size_t threads, const SolveOptions& options)
{
  return threads * std::min(MostOfShort, options.verticesOfThread);
}
/** At how many updates the next report is due. */
std::size_t reportAfter(std::size_t updates, const SolveOptions& options)
{
  const std::size_t interval = options.progressInterval;
  return interval > 0 ? (updates / interval + 1) * interval
                      : std::numeric_limits<std::size_t>::max();
}
/** The most updates of a thread in a round, so that it can be cancelled and ranges be cut. */
constexpr std::size_t MostOfRound = 20000;
/** About how many samples of all queues say where ranges are cut. */
constexpr std::size_t SamplesOfAll = 256;

}

struct SharedMarch::Summary
{
  double next = Infinity;
  std::size_t updates = 0;
  /** The updates in the round: of all threads, and the most of any. */
  std::size_t roundUpdates = 0;
  std::size_t most = 0;
  bool isCancelled = false;
  /** How many vertices wait, and how many have a value. */
  std::size_t waiting = 0;
  std::size_t reached = 0;
  /** How many values they have, of all labels. */
  std::size_t values = 0;
  /** Whether the queues are so unequal that the ranges are to be cut anew. */
  bool isUneven = false;
};

std::size_t SharedMarch::mostUpdates(std::size_t values)
{
  return MostUpdates * (values + MarchControl::SmallMarch);
}

bool SharedMarch::isToBeShared(std::size_t waiting, std::size_t unreached, std::size_t threads,
  std::size_t labels, const SolveOptions& options)
{
  return waiting >= 2 * shortFront(threads, options) &&
    (unreached > waiting || (labels > 1 && waiting >= threads * MuchWork));
}

SharedMarch::SharedMarch(
  const TriangleMesh& mesh, std::size_t threads, std::size_t labels, const SolveOptions& options)
  : Mesh(mesh)
  , Labels(labels)
  , Options(options)
  , RunAtOnce(SpinBarrier::runAtOnce(threads))
  , Bells(threads)
  , Together(threads)
{
  this->Boxes.reserve(threads);
  for (std::size_t receiver = 0; receiver < threads; ++receiver)
  {
    this->Boxes.emplace_back(threads);
  }
  for (std::vector<Report>& reports : this->Reports)
  {
    reports.resize(threads);
    for (Report& report : reports)
    {
      report.mail.resize(threads);
    }
  }
}

void SharedMarch::begin(
  std::size_t updates, std::size_t reached, std::size_t values, bool isCancelled)
{
  this->UpdatesBefore = updates;
  this->ReachedBefore = reached;
  this->ValuesBefore = values;
  this->NextReport = reportAfter(updates, this->Options);
  this->Work.updates = updates;
  this->Work.longestChain = updates;
  // All threads hear of it when they first meet.
  this->Reports[0][0].isCancelled = isCancelled;
  this->WasCancelled = isCancelled;
}

void SharedMarch::fail()
{
  this->Together.breakUp();
}

bool SharedMarch::mayGoOn(std::size_t updates)
{
  if (!this->Options.onProgress || updates < this->NextReport)
  {
    return true;
  }
  this->NextReport = reportAfter(updates, this->Options);
  this->WasCancelled = !this->Options.onProgress(this->NextReport - this->Options.progressInterval);
  return !this->WasCancelled;
}

SharedMarch::Share::Share(SharedMarch& march, std::size_t thread)
  : March(march)
  , Number(thread)
{
  this->Ends.assign(march.Reports[0].size(), march.Mesh.numberOfVertices());
  this->setRange();
}

void SharedMarch::Share::setRange()
{
  this->First = this->Number > 0 ? this->Ends[this->Number - 1] : 0;
  this->Count = this->Ends[this->Number] - this->First;
}

std::size_t SharedMarch::Share::ownerOf(Index vertex) const
{
  return static_cast<std::size_t>(
    std::upper_bound(this->Ends.begin(), this->Ends.end(), vertex) - this->Ends.begin());
}

void SharedMarch::Share::send(const LabelAtVertex& place, double key, bool isAlong)
{
  this->send(this->ownerOf(place.vertex),
    { place, key, isAlong ? Content::ValueAlong : Content::ValueAcross });
}

void SharedMarch::Share::send(std::size_t receiver, const Letter& letter)
{
  ++this->report().sent;
  if (!this->March.Boxes[receiver][this->Number].put(letter))
  {
    this->report().mail[receiver].letters.push_back(letter);
    return;
  }
  std::atomic<bool>& bell = this->March.Bells[receiver].isRung;
  if (!bell.load(std::memory_order_relaxed))
  {
    bell.store(true, std::memory_order_relaxed);
  }
}

void SharedMarch::Share::take(const Letter& letter, ThreadFront& front)
{
  if (letter.content == Content::Notice)
  {
    front.updateRound(letter.place);
  }
  else
  {
    front.lower(letter.place, letter.key, letter.content == Content::ValueAlong);
  }
}

void SharedMarch::Share::takeLetters(ThreadFront& front)
{
  this->March.Bells[this->Number].isRung.store(false, std::memory_order_relaxed);
  for (Box& box : this->March.Boxes[this->Number])
  {
    box.takeAll([&](const Letter& letter) { take(letter, front); });
  }
}

void SharedMarch::Share::exchange(ThreadFront& front)
{
  if (++this->Calls % CallsOfExchange != 0)
  {
    return;
  }
  this->sendNotices(front);
  if (this->March.Bells[this->Number].isRung.load(std::memory_order_relaxed))
  {
    this->takeLetters(front);
  }
}

bool SharedMarch::Share::march(ThreadFront& front)
{
  // Where all points are one place, no step would lead on.
  const double edge = front.meanLongestEdge();
  const double stepInEdges = this->March.RunAtOnce ? StepInEdges : StepInTurns;
  const double leastStep = edge > 0.0 ? stepInEdges * edge : Infinity;
  double step = 0.5 * leastStep;
  double end = -Infinity;
  this->report().next = front.next();
  this->report().waiting = front.waiting();
  while (true)
  {
    const Summary round = this->meet();
    if (round.isCancelled || round.next == Infinity)
    {
      return !round.isCancelled;
    }
    if (round.updates > mostUpdates(round.values))
    {
      MarchControl::endUnsettled(round.updates, round.values, MostUpdates);
    }
    this->ValuesOfOthers = round.values - front.numberOfValues();
    step = round.roundUpdates < FewUpdates ? 2.0 * step : std::max(leastStep, 0.5 * step);
    // What is sent lies up to a step behind the limit.
    end = std::max({ end, round.next + step, std::min(end + step, round.next + 1.5 * step) });
    this->takeMail(front);
    if (!this->adapt(round, front))
    {
      return false;
    }
    this->advance(front, end);
    if (this->Number == 0 && !this->March.mayGoOn(round.updates))
    {
      this->report().isCancelled = true;
    }
  }
}

bool SharedMarch::Share::adapt(const Summary& round, ThreadFront& front)
{
  const std::size_t threads = this->Ends.size();
  if (this->isOfOne())
  {
    const std::size_t unreached = this->March.Mesh.numberOfVertices() - round.reached;
    return !isToBeShared(
             round.waiting, unreached, threads, this->March.Labels, this->March.Options) ||
      this->cutRanges(front);
  }
  if (round.waiting < shortFront(threads, this->March.Options))
  {
    std::fill(this->Ends.begin(), this->Ends.end(), this->Ends.back());
    this->setRange();
    return this->handOver(front);
  }
  return !round.isUneven || this->cutRanges(front);
}

SharedMarch::Summary SharedMarch::Share::meet()
{
  Summary summary;
  summary.updates = this->March.UpdatesBefore;
  summary.reached = this->March.ReachedBefore;
  summary.values = this->March.ValuesBefore;
  if (!this->March.Together.wait())
  {
    summary.isCancelled = true;
    return summary;
  }
  const std::vector<Report>& reports = this->March.Reports[this->Parity];
  double load = 0.0;
  double mostLoad = 0.0;
  std::size_t sent = 0;
  for (const Report& report : reports)
  {
    summary.next = std::min(summary.next, report.next);
    summary.updates += report.updates;
    summary.roundUpdates += report.roundUpdates;
    summary.most = std::max(summary.most, report.roundUpdates);
    summary.isCancelled = summary.isCancelled || report.isCancelled;
    const double ofThread = static_cast<double>(report.waiting) * report.pace;
    load += ofThread;
    summary.waiting += report.waiting;
    summary.reached += report.reached;
    summary.values += report.values;
    mostLoad = std::max(mostLoad, ofThread);
    sent += report.sent;
  }
  const double mean = load / static_cast<double>(reports.size());
  summary.isUneven = mostLoad > (1.0 + PartOfExcess) * mean + LeastExcess * UsualPace;
  if (this->Number == 0)
  {
    this->March.Work.longestChain += summary.most;
    this->March.Work.updates = summary.updates;
    this->March.Work.sent += sent;
    ++this->March.Work.rounds;
  }
  // From here on this thread writes only to its next report: others may still read the last one.
  this->Parity ^= 1u;
  Report& report = this->report();
  report.updates = this->lastReports()[this->Number].updates;
  report.roundUpdates = 0;
  report.sent = 0;
  for (Mail& mail : report.mail)
  {
    mail.letters.clear();
  }
  return summary;
}

void SharedMarch::Share::takeMail(ThreadFront& front)
{
  this->takeLetters(front);
  for (const Report& report : this->lastReports())
  {
    for (const Letter& letter : report.mail[this->Number].letters)
    {
      take(letter, front);
    }
  }
}

bool SharedMarch::Share::cutRanges(ThreadFront& front)
{
  this->takeSamples(front);
  if (!this->March.Together.wait())
  {
    return false;
  }
  this->findEnds();
  return this->handOver(front);
}

void SharedMarch::Share::takeSamples(const ThreadFront& front)
{
  Report& own = this->report();
  const std::size_t step = own.mail.size() * front.waiting() / SamplesOfAll + 1;
  own.samples.clear();
  std::size_t count = 0;
  front.visitWaiting(
    [&](Index vertex)
    {
      if (count++ % step == 0)
      {
        own.samples.push_back(vertex);
      }
    });
  own.weightOfSample = step;
}

bool SharedMarch::Share::handOver(ThreadFront& front)
{
  Report& own = this->report();
  for (Mail& mail : own.mail)
  {
    mail.gifts.clear();
  }
  front.giveUp(
    [&](Index item, Index vertex)
    {
      Mail& mail = own.mail[this->ownerOf(vertex)];
      mail.gifts.push_back(item);
      ++own.sent;
    });
  if (!this->March.Together.wait())
  {
    return false;
  }
  for (const Report& report : this->March.Reports[this->Parity])
  {
    const Mail& mail = report.mail[this->Number];
    for (const Index item : mail.gifts)
    {
      front.take(item);
    }
  }
  return true;
}

void SharedMarch::Share::findEnds()
{
  this->Samples.clear();
  std::size_t total = 0;
  for (const Report& report : this->March.Reports[this->Parity])
  {
    for (const Index vertex : report.samples)
    {
      this->Samples.emplace_back(vertex, report.weightOfSample);
      total += report.weightOfSample;
    }
  }
  std::sort(this->Samples.begin(), this->Samples.end());
  // As much time for each thread; the last one goes on to the last vertex.
  double speeds = 0.0;
  for (const Report& report : this->lastReports())
  {
    speeds += 1.0 / report.pace;
  }
  const auto weightOf = [&](std::size_t thread)
  { return static_cast<double>(total) / (this->lastReports()[thread].pace * speeds); };
  double end = weightOf(0);
  double before = 0.0;
  std::size_t thread = 0;
  for (const auto& [vertex, weight] : this->Samples)
  {
    before += static_cast<double>(weight);
    while (thread + 1 < this->Ends.size() && before >= end)
    {
      this->Ends[thread] = vertex + 1;
      ++thread;
      end += weightOf(thread);
    }
  }
  this->setRange();
}

void SharedMarch::Share::advance(ThreadFront& front, double end)
{
  const std::size_t before = front.numberOfUpdates();
  if (this->isOfOne())
  {
    this->goOnAlone(front, end);
  }
  else
  {
    this->goOnTogether(front, end);
  }
  Report& report = this->report();
  report.updates = front.numberOfUpdates();
  report.roundUpdates = report.updates - before;
  report.waiting = front.waiting();
  report.reached = front.reached();
  report.values = front.numberOfValues();
  report.pace = this->Pace;
  this->sendNotices(front);
  report.next = front.next();
  const auto count = [&](const Letter& letter) { report.next = std::min(report.next, letter.key); };
  for (std::size_t receiver = 0; receiver < report.mail.size(); ++receiver)
  {
    this->March.Boxes[receiver][this->Number].visitLeft(count);
    std::for_each(
      report.mail[receiver].letters.begin(), report.mail[receiver].letters.end(), count);
  }
}

void SharedMarch::Share::goOnAlone(ThreadFront& front, double end)
{
  const std::size_t most = front.numberOfUpdates() + MostOfRound;
  const auto mayGoOn = [&] { return front.numberOfUpdates() < most; };
  front.advanceWhile(end, mayGoOn);
  while (front.waiting() > 0 &&
    front.waiting() < 2 * shortFront(this->Ends.size(), this->March.Options) && mayGoOn())
  {
    end = std::max(end, front.next()) + StepInEdges * front.meanLongestEdge();
    front.advanceWhile(end, mayGoOn);
  }
}

void SharedMarch::Share::goOnTogether(ThreadFront& front, double end)
{
  const std::size_t waiting = front.waiting();
  const std::size_t most = front.numberOfUpdates() + MostOfRound;
  const auto start = std::chrono::steady_clock::now();
  front.advanceWhile(end,
    [&]
    {
      this->exchange(front);
      return front.numberOfUpdates() < most;
    });
  if (!this->March.RunAtOnce)
  {
    return;
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (waiting >= LeastTimed)
  {
    // A thread may have had to leave its processor to another for long: twice as long counts.
    const double pace =
      std::clamp(taken.count() / static_cast<double>(waiting), 0.5 * this->Pace, 2.0 * this->Pace);
    this->Pace += PartOfRound * (pace - this->Pace);
  }
  front.advanceWhile(end + MostAhead * front.meanLongestEdge(),
    [&]
    {
      this->exchange(front);
      return this->March.Together.othersAreComing() && front.numberOfUpdates() < most;
    });
}

void SharedMarch::Share::sendNotices(ThreadFront& front)
{
  front.visitAtBorder(
    [&](const LabelAtVertex& place, double key)
    {
      std::uint64_t receivers = 0;
      for (const RingEntry& entry : this->March.Mesh.ring(place.vertex))
      {
        const std::size_t owner = this->ownerOf(entry.neighbour());
        if (owner > this->Number && (receivers >> owner & 1u) == 0)
        {
          receivers |= std::uint64_t{ 1 } << owner;
          this->send(owner, { place, key, Content::Notice });
        }
      }
    });
}

}
