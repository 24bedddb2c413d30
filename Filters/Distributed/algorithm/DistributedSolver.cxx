// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/DistributedSolver.h"

#include "base/NumberText.h"
#include "mesh/TriangleMesh.h"
#include "pieces/DividedMesh.h"
#include "pieces/SharedPoints.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>

namespace geodesic::distributed
{
namespace
{

/** A round in which no rank makes as many updates takes longer to agree on than to compute: the
 * next one goes farther. */
constexpr double FewUpdates = 32.0;
/** Where costs are spread, a round whose news are more than these parts of its updates has gone
 * ahead of other ranks: the next one goes less far. On triangles dealt to four ranks at random
 * there are 3.7 times the updates of one rank. Before triangles were bypassed (see Detours) there
 * were 7 times, and 129 without this. */
constexpr double MuchNews = 0.125;

/** How far the next round goes. @param updates, news  the most of a rank in and after the last one
 */
double nextStep(double step, double usual, double least, double updates, double news)
{
  if (updates < FewUpdates)
  {
    // The mean step can be far too small where triangles are large or dear.
    return 2.0 * step;
  }
  if (step > usual)
  {
    return std::max(usual, 0.5 * step);
  }
  return news > MuchNews * updates ? std::max(least, 0.5 * step) : std::min(usual, 2.0 * step);
}

}

DistributedSolver::DistributedSolver(RankGroup& ranks, const DividedMesh& mesh)
  : Ranks(ranks)
  , Mesh(mesh)
{
  for (const SharedPoints::Neighbour& neighbour : mesh.shared().neighbours())
  {
    this->Partners.push_back(neighbour.rank);
  }
}

bool DistributedSolver::owns(Index vertex) const
{
  return this->Mesh.shared().owns(vertex);
}

std::span<const Index> DistributedSolver::sharedVertices() const
{
  return this->Mesh.shared().vertices();
}

std::span<const float> DistributedSolver::longestSides() const
{
  return this->Mesh.longestSides();
}

std::vector<StartValue> DistributedSolver::exchange(std::span<const StartValue> own)
{
  return this->Mesh.shared().exchange(this->Ranks, own);
}

bool DistributedSolver::march(MarchingFront& front, StopLimit& limit)
{
  const std::size_t slots = this->Mesh.shared().vertices().size();
  this->Known.start(slots);
  this->Touched.resize(slots);
  std::iota(this->Touched.begin(), this->Touched.end(), 0u);
  this->IsTouched.assign(slots, true);
  const double usualStep = this->stepOf(front.meanLongestEdge());
  const double leastStep = std::min(usualStep, this->stepOf(front.typicalEdge()));
  double step = 0.5 * usualStep;
  double end = 0.0;
  double updates = 0.0;
  double news = 0.0;
  while (true)
  {
    // The state of the whole surface: the least distance that is left, whether a rank was
    // cancelled, the most updates of a rank in the last round, the most values that others lowered
    // after it, and the distances of the targets.
    std::vector<double> state{ front.nextDistance(), front.isCancelled() ? 0.0 : 1.0, -updates,
      -news };
    const std::vector<double> targets = limit.targetDistances();
    state.insert(state.end(), targets.begin(), targets.end());
    this->Ranks.takeLeast(state);
    const auto [next, nobodyCancelled, most, mostNews] =
      std::tuple(state[0], state[1], -state[2], -state[3]);
    const std::span<const double> targetsOfAll = std::span(state).subspan(4);
    this->Own.longestChain += most;
    step = nextStep(step, usualStep, leastStep, most, mostNews);
    if (nobodyCancelled == 0.0 || next == DistanceField::Unreached)
    {
      limit.learn(targetsOfAll);
      this->Own.updates += static_cast<double>(front.numberOfUpdates());
      return nobodyCancelled != 0.0;
    }
    // As a rule what has fallen below the last end is taken at once. Where ranks have gone ahead of
    // each other that would be all that they did.
    end = step < usualStep ? next + step : std::max(end, next + step);
    const auto received = this->Ranks.exchangeAfter(this->Partners,
      [&]
      {
        limit.learn(targetsOfAll);
        updates = this->advance(front, end);
        return this->gatherNews(front);
      });
    news = this->takeNews(front, received);
    ++this->Own.rounds;
  }
}

double DistributedSolver::advance(MarchingFront& front, double end)
{
  const bool hasWork = front.nextDistance() < end;
  const std::size_t before = front.numberOfUpdates();
  this->Taken.clear();
  front.advance(end, this->IsTouched.empty() ? nullptr : &this->Taken);
  const std::size_t updates = front.numberOfUpdates() - before;
  if (hasWork && updates == 0)
  {
    // An error in this program: without this test the ranks would go on like this for ever.
    throw std::logic_error("A round of the march did nothing: up to the distance " + textOf(end) +
      ", rank " + std::to_string(this->Ranks.rank()) +
      " has not gone on from its least distance, " + textOf(front.nextDistance()) + ".");
  }
  this->addTouched();
  return static_cast<double>(updates);
}

void DistributedSolver::addTouched()
{
  for (const Index vertex : this->Taken)
  {
    for (const std::uint32_t slot : this->Mesh.slotsBeside().of(vertex))
    {
      if (!this->IsTouched[slot])
      {
        this->IsTouched[slot] = true;
        this->Touched.push_back(slot);
      }
    }
  }
}

double DistributedSolver::stepOf(double meanEdge)
{
  const auto triangles = static_cast<double>(this->Mesh.mesh().numberOfTriangles());
  const double edge = this->Ranks.sum(triangles * meanEdge) / this->Ranks.sum(triangles);
  return this->Mesh.stepInEdges() * edge;
}

double DistributedSolver::takeNews(
  MarchingFront& front, const std::vector<RankGroup::Message>& received)
{
  const SharedPoints& shared = this->Mesh.shared();
  double news = 0.0;
  for (std::size_t n = 0; n < received.size(); ++n)
  {
    for (const SentValue& sent : valuesIn<SentValue>(received[n]))
    {
      const std::uint32_t slot = shared.neighbours()[n].slots[sent.place];
      if (this->Known.isNews(slot, sent.label, sent.value))
      {
        front.lower(shared.vertices()[slot], sent.label, sent.value);
        ++news;
      }
    }
  }
  return news;
}

std::vector<RankGroup::Message> DistributedSolver::gatherNews(const MarchingFront& front)
{
  const SharedPoints& shared = this->Mesh.shared();
  std::vector<RankGroup::Message> messages(this->Partners.size());
  std::uint32_t slot = 0;
  const MarchingFront::Visit visit = [&](Index label, double value)
  {
    if (this->Known.isNews(slot, label, value))
    {
      for (const SharedPoints::Place& to : shared.placesOf(slot))
      {
        append(messages[to.neighbour], SentValue{ to.place, label, 0, value });
      }
    }
  };
  for (const std::uint32_t touched : this->Touched)
  {
    slot = touched;
    front.visitValues(shared.vertices()[slot], visit);
    this->IsTouched[slot] = false;
  }
  this->Touched.clear();
  for (const RankGroup::Message& message : messages)
  {
    this->Own.bytes += static_cast<double>(message.size());
  }
  return messages;
}

DistributedWork DistributedSolver::work()
{
  return { this->Own.rounds, this->Ranks.sum(this->Own.updates), this->Own.longestChain,
    this->Ranks.sum(this->Own.bytes) };
}

}
