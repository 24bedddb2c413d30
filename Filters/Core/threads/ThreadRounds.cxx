// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "threads/ThreadRounds.h"

#include "mesh/TriangleMesh.h"
#include "solve/DistanceField.h"

#include <algorithm>
#include <bit>

namespace geodesic
{
namespace
{

/** A round in which no thread makes as many updates takes longer to agree on than to compute. */
constexpr std::size_t FewUpdates = 64;
/** The least step of the limit from round to round, in mean edges. */
constexpr double StepInEdges = 6.0;

}

ThreadRounds::ThreadRounds(const TriangleMesh& mesh, const VertexShares& shares,
  std::span<const Label> labels, const SolveOptions& options)
  : Mesh(mesh)
  , Shares(shares)
  , Labels(labels)
  , Options(options)
  , NextReport(options.progressInterval)
  , Together(shares.numberOfThreads())
{
  for (std::vector<Report>& reports : this->Reports)
  {
    reports.resize(shares.numberOfThreads());
    for (Report& report : reports)
    {
      report.values.resize(shares.numberOfThreads());
    }
  }
}

bool ThreadRounds::Piece::march(MarchingFront& front, StopLimit&)
{
  const std::size_t slots = this->Rounds.Shares.atBorders().size();
  this->Known.start(slots);
  this->IsTouched.assign(slots, false);
  const double leastStep = StepInEdges * front.meanLongestEdge();
  double step = 0.5 * leastStep;
  double end = -DistanceField::Unreached;
  this->report().next = front.nextDistance();
  while (true)
  {
    this->Rounds.Together.wait();
    double next = DistanceField::Unreached;
    bool isCancelled = false;
    std::size_t most = 0;
    std::size_t updates = 0;
    std::size_t sent = 0;
    for (const Report& report : this->Rounds.Reports[this->Parity])
    {
      next = std::min(next, report.next);
      isCancelled = isCancelled || report.isCancelled;
      most = std::max(most, report.roundUpdates);
      updates += report.updates;
      sent += report.sent;
    }
    if (this->Thread == 0)
    {
      this->Rounds.Work.longestChain += most;
      this->Rounds.Work.updates = updates;
      this->Rounds.Work.values += sent;
      ++this->Rounds.Work.rounds;
    }
    if (isCancelled || next == DistanceField::Unreached)
    {
      return !isCancelled;
    }
    step = most < FewUpdates ? 2.0 * step : std::max(leastStep, 0.5 * step);
    end = std::max(end, next + step);
    // From here on this thread writes only to its next report: others may still read the last one.
    this->Parity ^= 1u;
    this->takeNews(front);
    this->advance(front, end);
    if (this->Thread == 0 && !this->Rounds.mayGoOn(updates))
    {
      this->report().isCancelled = true;
    }
  }
}

void ThreadRounds::Piece::advance(MarchingFront& front, double end)
{
  const std::size_t before = front.numberOfUpdates();
  this->Taken.clear();
  front.advance(end, &this->Taken);
  Report& report = this->report();
  report.updates = front.numberOfUpdates();
  report.roundUpdates = report.updates - before;
  report.next = front.nextDistance();
  report.isCancelled = front.isCancelled();
  this->sendNews(front);
}

bool ThreadRounds::mayGoOn(std::size_t updates)
{
  if (!this->Options.onProgress || this->Options.progressInterval == 0 ||
    updates < this->NextReport)
  {
    return true;
  }
  const std::size_t interval = this->Options.progressInterval;
  const std::size_t reported = updates / interval * interval;
  this->NextReport = reported + interval;
  return this->Options.onProgress(reported);
}

void ThreadRounds::Piece::fail()
{
  this->report().isCancelled = true;
  this->Rounds.Together.arrive();
}

void ThreadRounds::Piece::sendNews(MarchingFront& front)
{
  const VertexShares& shares = this->Rounds.Shares;
  Report& report = this->report();
  report.sent = 0;
  for (std::vector<Value>& values : report.values)
  {
    values.clear();
  }
  const VertexShares::Threads own = VertexShares::Threads{ 1 } << this->Thread;
  const auto touch = [&](Index vertex)
  {
    const VertexShares::Slot slot = shares.slotOf(vertex);
    // A value of this thread's own, or of a vertex that it has.
    if (slot != VertexShares::NoSlot && (shares.threadsOf(slot) & own) != 0 &&
      (shares.threadsOf(slot) & ~own) != 0 && !this->IsTouched[slot])
    {
      this->IsTouched[slot] = true;
      this->Touched.push_back(slot);
    }
  };
  for (const Index vertex : this->Taken)
  {
    if (shares.isBeside(vertex))
    {
      touch(vertex);
      for (const RingEntry& entry : this->Rounds.Mesh.ring(vertex))
      {
        touch(entry.neighbour());
      }
    }
  }
  VertexShares::Slot slot = 0;
  const MarchingFront::Visit visit = [&](Index label, double value)
  {
    if (this->Known.isNews(slot, label, value))
    {
      report.next = std::min(report.next, value + this->Rounds.Labels[label].value);
      for (auto others = shares.threadsOf(slot) & ~own; others != 0; others &= others - 1)
      {
        report.values[static_cast<std::size_t>(std::countr_zero(others))].push_back(
          { slot, label, value });
        ++report.sent;
      }
    }
  };
  for (const VertexShares::Slot touched : this->Touched)
  {
    slot = touched;
    this->IsTouched[slot] = false;
    front.visitValues(shares.atBorders()[slot], visit);
  }
  this->Touched.clear();
}

void ThreadRounds::Piece::takeNews(MarchingFront& front)
{
  for (const Report& report : this->Rounds.Reports[this->Parity ^ 1u])
  {
    for (const Value& sent : report.values[this->Thread])
    {
      if (this->Known.isNews(sent.slot, sent.label, sent.value))
      {
        front.lower(this->Rounds.Shares.atBorders()[sent.slot], sent.label, sent.value);
      }
    }
  }
}

}
