// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey/MarchesAhead.h"

#include "base/Interruption.h"
#include "base/SharedJobs.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace geodesic
{

std::size_t MarchesAhead::sizeOfBatch() const
{
  // Of vertices, which take some milliseconds.
  constexpr std::size_t work = 30000;
  constexpr std::size_t first = 4;
  constexpr std::size_t least = 16;
  constexpr std::size_t most = 256;
  return this->Size == 0 ? first : std::clamp(work / this->Size, least, most);
}

bool MarchesAhead::march(std::span<const Index> vertices, const SolveOptions& options,
  const std::function<bool()>& mayGoOn)
{
  this->dropFallen();
  std::vector<March> made(vertices.size());
  std::atomic<bool> hasFailed = false;
  const std::size_t memoryOfEach = this->Solvers.memoryOfEach(options.memoryLimit);
  constexpr std::size_t stepsAlone = 0;
  constexpr std::size_t stepsOfJob = 1;
  SharedJobs jobs(this->Solvers.numberOfThreads(), stepsAlone, stepsOfJob,
    [&](std::size_t) { return mayGoOn(); });
  const std::vector<bool> areMade = jobs.run(vertices.size(),
    [&](const SharedJobs::Turn& turn)
    {
      SolveOptions own = options;
      own.onProgress = turn.onProgress;
      own.memoryLimit = turn.isShared && vertices.size() > 1 ? memoryOfEach : options.memoryLimit;
      try
      {
        made[turn.number] = this->marchFrom(vertices[turn.number], std::move(own), turn.thread);
      }
      catch (const Interrupted&)
      {
        throw;
      }
      catch (...)
      {
        hasFailed = true;
        if (turn.number == 0)
        {
          throw;
        }
      }
    });
  this->HasFailed = this->HasFailed || hasFailed;
  if (std::find(areMade.begin(), areMade.end(), false) != areMade.end())
  {
    return false;
  }
  std::size_t sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    sum += made[i].nearer.size();
    if (made[i].isWhole)
    {
      this->Made.insert_or_assign(vertices[i], std::move(made[i]));
    }
  }
  this->Size = std::max<std::size_t>(sum / vertices.size(), 1);
  return true;
}

MarchesAhead::March MarchesAhead::marchFrom(Index vertex, SolveOptions options, std::size_t thread)
{
  DistanceSolver& solver = this->Solvers.ofThread(thread);
  options.keepsSurface = std::exchange(this->HasMarched[thread], 0) != 0;
  const Seed seed = Seed::atPoint(solver.mesh().pointAtVertex(vertex));
  March made{ true, this->Distances[vertex] };
  try
  {
    const DistanceField& field = solver.solve({ &seed, 1 }, options);
    for (const Index reached : field.reached())
    {
      if (field.distance(reached) < this->Distances[reached])
      {
        made.nearer.push_back({ reached, field.distance(reached) });
      }
    }
  }
  catch (...)
  {
    this->Solvers.renew(thread);
    throw;
  }
  this->HasMarched[thread] = 1;
  return made;
}

std::vector<NearerVertex> MarchesAhead::take(Index vertex)
{
  return std::move(this->Made.extract(vertex).mapped().nearer);
}

void MarchesAhead::dropFallen()
{
  std::erase_if(this->Made,
    [&](const auto& made) { return this->Distances[made.first] < made.second.distance; });
}

}
