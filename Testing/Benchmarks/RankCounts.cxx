// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Counts what a field on many ranks takes, with all ranks in this process:
//   RankCounts SURFACE SEED RANKS PATCHES
// For SURFACE see NamedSurface.h. SEED is cut, middle (of a rank's piece, where
// each rank has one) or the number of a random place. PATCHES is how many patches each rank has.
// Prints the name and number of all that is counted, a pair a line. rank_suite.py makes a table.

#include "DealtSurface.h"
#include "NamedSurface.h"
#include "SimulatedRanks.h"
#include "Solving.h"
#include "algorithm/DistributedSolver.h"
#include "march/FastMarchingSolver.h"
#include "pieces/DividedMesh.h"
#include "ranks/RankGroup.h"

#include "vtkMultiProcessController.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <random>
#include <stdexcept>
#include <string>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** The point that is farthest from all cuts. */
Index middleOf(const std::shared_ptr<const TriangleMesh>& mesh, std::vector<Index> cuts)
{
  for (Index& point : cuts)
  {
    point = mesh->vertexOfPoint(point);
  }
  FastMarchingSolver solver(mesh);
  const Seed seed = Seed::onRegion(std::move(cuts));
  const DistanceField& field = solver.solve({ &seed, 1 }, {});
  return mesh->pointOfVertex(*std::max_element(field.reached().begin(), field.reached().end(),
    [&](Index a, Index b) { return field.distance(a) < field.distance(b); }));
}

Index seedPoint(const std::string& place, const Surface& surface,
  const std::shared_ptr<const TriangleMesh>& mesh, const std::vector<Index>& cuts)
{
  if (place == "middle")
  {
    return middleOf(mesh, cuts);
  }
  if (place == "cut")
  {
    return cuts[cuts.size() / 2];
  }
  std::mt19937 random(std::stoul(place));
  return std::uniform_int_distribution<Index>(0, static_cast<Index>(surface.points.size()) - 1)(
    random);
}

/** What a rank counts; the same on all ranks but for the last two. */
struct Counts
{
  distributed::DistributedWork work;
  std::size_t points = 0;
  double largestDifference = 0.0;
};

/** Solves from a point of the whole surface, on a rank's piece of it.
 * @param truth the distances on one rank, for each point of the whole surface */
Counts solve(vtkMultiProcessController* controller, const Piece& piece, Index seedPoint,
  const Vector3& position, const std::vector<double>& truth)
{
  Counts counts;
  distributed::RankGroup ranks(controller);
  ranks.run(
    [&]
    {
      const auto mesh = std::make_shared<const TriangleMesh>(
        piece.surface.points, piece.surface.triangles, CoincidentPoints::Separate, ThreadTeam(1));
      std::vector<distributed::Key> keys;
      for (Index v = 0; v < mesh->numberOfVertices(); ++v)
      {
        keys.push_back({ piece.points[mesh->pointOfVertex(v)], 0, 0, 0 });
      }
      const distributed::DividedMesh divided(ranks, mesh, keys);
      distributed::DistributedSolver partition(ranks, divided);
      std::vector<SurfacePoint> here;
      const auto own = std::lower_bound(piece.points.begin(), piece.points.end(), seedPoint);
      if (own != piece.points.end() && *own == seedPoint)
      {
        here.push_back(
          mesh->pointAtVertex(mesh->vertexOfPoint(static_cast<Index>(own - piece.points.begin()))));
      }
      const Seed seed = Seed::atPosition(position, here);
      SolveOptions options;
      options.partition = &partition;
      FastMarchingSolver solver(mesh);
      const DistanceField& field = solver.solve({ &seed, 1 }, options);
      counts.work = partition.work();
      counts.points = piece.points.size();
      for (Index v = 0; v < mesh->numberOfVertices() && !truth.empty(); ++v)
      {
        const double difference =
          std::abs(field.distance(v) - truth[piece.points[mesh->pointOfVertex(v)]]);
        counts.largestDifference = std::max(counts.largestDifference, difference);
      }
    });
  return counts;
}

/** Prints a number under its name. */
void print(const char* name, double value)
{
  std::printf("%s %.12g\n", name, value);
}

void count(const std::string& name, const std::string& place, int ranks, int patches)
{
  const Surface surface = namedSurface(name);
  const auto mesh = meshOf(surface);
  const Index seed =
    seedPoint(place, surface, mesh, pointsOnCuts(surface, dealt(surface, std::max(ranks, 2), 1)));
  const Vector3 position = surface.points[seed];
  const std::vector<double> truth = distances<FastMarchingSolver>(
    mesh, { Seed::atPosition(position, { mesh->pointAtVertex(mesh->vertexOfPoint(seed)) }) });
  const auto owners = dealt(surface, ranks, patches);
  const std::vector<Piece> pieces = piecesOf(surface, owners, ranks);
  std::vector<Counts> ofRanks(ranks);
  runOnRanks(ranks,
    [&](vtkMultiProcessController* controller)
    {
      const int rank = controller->GetLocalProcessId();
      ofRanks[rank] = solve(controller, pieces[rank], seed, position, truth);
    });
  const distributed::DistributedWork& work = ofRanks[0].work;
  print("points", static_cast<double>(surface.points.size()));
  print("shared", static_cast<double>(pointsOnCuts(surface, owners).size()));
  print("rounds", static_cast<double>(work.rounds));
  print("updates", work.updates);
  print("chain", work.longestChain);
  print("bytes", work.bytes);
  const auto ofAll = [&](const auto& member)
  {
    return std::max_element(ofRanks.begin(), ofRanks.end(),
      [&](const Counts& a, const Counts& b) { return a.*member < b.*member; });
  };
  print("most_points", static_cast<double>(ofAll(&Counts::points)->points));
  print("difference",
    ofAll(&Counts::largestDifference)->largestDifference /
      *std::max_element(truth.begin(), truth.end()));
}

}

int main(int argc, char** argv)
{
  try
  {
    if (argc != 5)
    {
      throw std::invalid_argument("usage: RankCounts SURFACE SEED RANKS PATCHES");
    }
    count(argv[1], argv[2], std::stoi(argv[3]), std::stoi(argv[4]));
    return 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
