// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a surface and a request on it: a solver makes distances that are numbers of at least
// 0, or throws an exception with a message.

#include "base/WorkCount.h"
#include "march/UpdateBounds.h"
#include "methods/SolverTable.h"
#include "solve/DistanceField.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

using namespace geodesic;

namespace
{

/** Numbers from the bytes, one after the other; zeros behind the end. */
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size)
    : Data(data)
    , Size(size)
  {
  }

  template <class Number>
  Number next()
  {
    Number number{};
    const std::size_t taken = std::min(sizeof number, this->Size);
    std::memcpy(&number, this->Data, taken);
    this->Data += taken;
    this->Size -= taken;
    return number;
  }
  /** A number below @p count. */
  Index below(Index count) { return this->next<std::uint8_t>() % count; }
  /** Most often some tenths, at times any eight bytes: NaN, infinity, 1e-300. */
  double coordinate()
  {
    const auto kind = this->next<std::uint8_t>();
    return kind < 250 ? kind / 10.0 : this->next<double>();
  }

private:
  const std::uint8_t* Data;
  std::size_t Size;
};

/** Solves what the bytes say. @throws what the mesh or the solver does */
void solve(Bytes bytes)
{
  std::vector<Vector3> points(3 + bytes.below(30));
  for (Vector3& p : points)
  {
    const double x = bytes.coordinate();
    const double y = bytes.coordinate();
    p = { x, y, bytes.coordinate() };
  }
  std::vector<Triangle> triangles(1 + bytes.below(40));
  for (Triangle& t : triangles)
  {
    // Some corners do not exist.
    for (Index& corner : t)
    {
      corner = bytes.below(static_cast<Index>(points.size()) + (bytes.below(200) == 199 ? 1 : 0));
    }
  }
  const auto coincident =
    bytes.below(2) == 0 ? CoincidentPoints::Separate : CoincidentPoints::Merge;
  const auto mesh = std::make_shared<const TriangleMesh>(
    points, triangles, coincident, ThreadTeam(), &updateMeasurer());
  if (mesh->numberOfTriangles() == 0)
  {
    return;
  }
  std::vector<Seed> seeds(bytes.below(5));
  for (Seed& seed : seeds)
  {
    const double a = bytes.below(11) / 10.0;
    const double b = (1.0 - a) * bytes.below(11) / 10.0;
    seed = Seed::atPoint({ bytes.below(mesh->numberOfTriangles()), { a, b, 1.0 - a - b } });
    seed.value = bytes.below(4) == 0 ? bytes.coordinate() : 0.0;
  }
  SolveOptions options;
  std::vector<double> cost(bytes.below(3) == 2 ? mesh->numberOfVertices() : 0);
  for (double& c : cost)
  {
    c = bytes.coordinate();
  }
  std::vector<std::uint8_t> excluded(bytes.below(4) == 3 ? mesh->numberOfVertices() : 0);
  for (std::uint8_t& flag : excluded)
  {
    flag = bytes.below(8) == 7;
  }
  options.cost = cost;
  options.excluded = excluded;
  if (bytes.below(4) == 3)
  {
    options.maximumDistance = bytes.coordinate();
  }
  std::vector<Triangle> targets(bytes.below(3));
  for (Triangle& target : targets)
  {
    target.fill(bytes.below(mesh->numberOfVertices() + 1));
  }
  options.targets = targets;
  options.targetMode = bytes.below(2) == 0 ? TargetMode::Any : TargetMode::All;
  options.onlyTowardsTargets = bytes.below(2) == 1 && options.targetMode == TargetMode::All;
  const auto solvers = solverTable();
  const SolverTraits& traits = solvers[bytes.below(static_cast<Index>(solvers.size()))];
  const auto solver = traits.make(mesh);
  checkServes(traits, SolverDemands::of(options, 1));
  const std::size_t before = WorkCount::steps();
  const DistanceField& field = solver->solve(seeds, options);
  for (const double distance : field.distances())
  {
    if (!(distance >= 0.0) || WorkCount::steps() - before > 10'000'000)
    {
      std::abort();
    }
  }
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  try
  {
    solve({ data, size });
  }
  catch (const std::invalid_argument& error)
  {
    // Another exception, or one without a message, ends the program.
    if (std::strlen(error.what()) < 20)
    {
      std::abort();
    }
  }
  catch (const std::runtime_error& error)
  {
    if (!std::strstr(error.what(), "does not settle"))
    {
      std::abort();
    }
  }
  return 0;
}
