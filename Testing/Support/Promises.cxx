// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Promises.h"

#include "NastyCases.h"
#include "Solving.h"
#include "base/NumberText.h"
#include "base/WorkCount.h"
#include "methods/SolverTable.h"
#include "path/PathFinder.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace geodesic::testing
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
/** No run on these small surfaces needs as many windows or steps. */
constexpr std::size_t MostSteps = 20'000'000;

/** The promises of one case. */
class Checker
{
public:
  Checker(const NastyCase& test, PromiseReport& report)
    : Test(test)
    , Report(report)
    , Mesh(*test.mesh)
  {
    for (const Vector3& p : this->Mesh.positions())
    {
      this->Size = std::max({ this->Size, std::abs(p.x), std::abs(p.y), std::abs(p.z) });
    }
  }

  void check()
  {
    for (const SolverTraits& solver : solverTable())
    {
      const std::string name = solver.name;
      const bool isTier = name == "FastMarching" || name == "Reference";
      const std::size_t roughBefore = this->Report.roughFields;
      if (auto field = this->solve(solver, this->Test.mesh, this->Test.seeds, this->Test.options()))
      {
        this->Fields[name] = std::move(*field);
      }
      this->AreRough = this->AreRough || (isTier && this->Report.roughFields > roughBefore);
    }
    for (const auto& [name, field] : this->Fields)
    {
      this->checkBounds(name, field);
    }
    this->compareSolvers();
    this->checkInvariance();
    if (this->Test.seeds.size() == 1 && this->Test.cost.empty())
    {
      this->checkPaths();
    }
  }

private:
  using Field = std::vector<double>;

  void expect(bool holds, const std::string& what)
  {
    ++this->Report.comparisons;
    if (!holds)
    {
      this->Report.broken.push_back(what);
    }
  }
  /** Room for rounding: of the distance, and of the coordinates where these are larger. */
  double rounding(double distance, double part = 1e-9) const
  {
    return part * distance + 1e-13 * this->Size * this->dearest();
  }
  double dearest() const
  {
    return this->Test.cost.empty()
      ? 1.0
      : *std::max_element(this->Test.cost.begin(), this->Test.cost.end());
  }
  double cheapest() const
  {
    return this->Test.cost.empty()
      ? 1.0
      : *std::min_element(this->Test.cost.begin(), this->Test.cost.end());
  }
  bool isPlain() const { return this->Test.cost.empty() && !this->Test.hasBarriers(); }

  /** What a solver says, at the vertices; nothing where it refuses. */
  std::optional<Field> solve(const SolverTraits& solver,
    const std::shared_ptr<const TriangleMesh>& mesh, const std::vector<Seed>& seeds,
    SolveOptions options)
  {
    std::size_t before = WorkCount::steps();
    const std::string name = solver.name;
    bool isTooLong = false;
    options.progressInterval = 1;
    options.onProgress = [&](std::size_t)
    { return !(isTooLong = WorkCount::steps() - before > MostSteps); };
    try
    {
      checkServes(solver, SolverDemands::of(options, 1));
      const auto made = solver.make(mesh);
      const DistanceField& field = made->solve(seeds, options);
      ++this->Report.solves;
      this->Report.roughFields += field.raisedGain() > 0.0 ? 1 : 0;
      this->expect(!isTooLong, name + " does not end");
      this->Report.mostSteps = std::max(this->Report.mostSteps, WorkCount::steps() - before);
      const Field found(field.distances().begin(), field.distances().end());
      if (this->Report.cases % 4 == 0)
      {
        // What a solver keeps from run to run must not matter.
        before = WorkCount::steps();
        const DistanceField& again = made->solve(seeds, options);
        this->expect(std::equal(found.begin(), found.end(), again.distances().begin()),
          name + " gives another field when it runs again");
      }
      return found;
    }
    catch (const std::invalid_argument& error)
    {
      ++this->Report.refusedRequests;
      this->expect(std::string(error.what()).size() > 20, name + " refuses without a reason");
    }
    catch (const std::runtime_error& error)
    {
      ++this->Report.budgetsReached;
      this->expect(std::string(error.what()).find("does not settle") != std::string::npos,
        name + ": " + error.what());
    }
    catch (const std::exception& error)
    {
      this->expect(false, name + " throws " + error.what());
    }
    return std::nullopt;
  }

  double straightLine(Index vertex) const
  {
    double least = Infinity;
    for (const Seed& seed : this->Test.seeds)
    {
      least =
        std::min(least, norm(this->Mesh.position(vertex) - this->Mesh.positionOf(seed.points[0])));
    }
    return least;
  }

  void checkBounds(const std::string& name, const Field& field)
  {
    const bool arePoints = std::all_of(this->Test.seeds.begin(), this->Test.seeds.end(),
      [](const Seed& seed) { return seed.kind == Seed::Kind::Point; });
    bool areNumbers = true;
    double tooShort = 0.0;
    const bool hasLine = arePoints && this->Test.seeds.size() < 100;
    for (Index v = 0; v < field.size(); ++v)
    {
      areNumbers = areNumbers && field[v] >= 0.0;
      if (hasLine && field[v] < Infinity)
      {
        const double line = this->cheapest() * this->straightLine(v);
        tooShort = std::max(tooShort, (line - field[v] - this->rounding(0.0)) / line);
      }
    }
    this->expect(areNumbers, name + " has a distance that is no number of at least 0");
    this->expect(tooShort <= (name == "VirtualSources" ? 1e-3 : 1e-9),
      name + " is shorter than the straight line by a part of " + textOf(tooShort));
    if (!this->isPlain() || name == "VirtualSources")
    {
      return;
    }
    const double tolerance = name == "Bounded" ? 1e-3 : 1e-9;
    bool areNear = true;
    for (const Triangle& t : this->Mesh.triangles())
    {
      for (int i = 0; i < 3; ++i)
      {
        const double a = field[t[i]];
        const double b = field[t[(i + 1) % 3]];
        const double edge = norm(this->Mesh.position(t[i]) - this->Mesh.position(t[(i + 1) % 3]));
        areNear = areNear &&
          (a == b || std::abs(a - b) <= edge + this->rounding(std::max(a, b), tolerance));
      }
    }
    this->expect(areNear, name + " differs along an edge by more than the edge's length");
  }

  /** Checks that one field is nowhere larger or smaller than another by more than a part of it, but
   * for a part of the largest distance. */
  void expectWithin(
    const std::string& a, const std::string& b, double below, double above, double ofLargest = 1e-9)
  {
    const auto first = this->Fields.find(a);
    const auto second = this->Fields.find(b);
    if (first == this->Fields.end() || second == this->Fields.end())
    {
      return;
    }
    double excess = 0.0;
    double lack = 0.0;
    double largest = 0.0;
    bool areReachedAlike = true;
    for (std::size_t v = 0; v < first->second.size(); ++v)
    {
      const double x = first->second[v];
      const double y = second->second[v];
      // Exact paths pass where barriers leave only an edge.
      areReachedAlike =
        areReachedAlike && (this->Test.hasBarriers() || std::isinf(x) == std::isinf(y));
      if (x < Infinity && y < Infinity)
      {
        largest = std::max(largest, y);
        excess = std::max(excess, x - y * (1.0 + above));
        lack = std::max(lack, y * (1.0 - below) - x);
      }
    }
    this->expect(areReachedAlike, a + " and " + b + " reach different vertices");
    this->expect(excess <= this->rounding(largest, ofLargest),
      a + " is larger than " + b + " by " + textOf(excess / largest));
    this->expect(lack <= this->rounding(largest, ofLargest),
      a + " is smaller than " + b + " by " + textOf(lack / largest));
  }

  void compareSolvers()
  {
    for (const SolverTraits& solver : solverTable())
    {
      // Near a seed in a varying cost, fast marching has lengths that are fixed before the march.
      if (this->Test.cost.empty())
      {
        this->expectWithin(
          solver.name, "Dijkstra", 1.0, std::string(solver.name) == "Bounded" ? 1e-3 : 0.0);
      }
    }
    this->expectWithin("Bounded", "Exact", 0.0, 1e-3);
    // Where fronts of several seeds meet, what the margin of labels cuts off depends on the order.
    const bool isOne = this->Test.seeds.size() == 1;
    const bool isUnit = this->Test.cost.empty();
    const double tolerance = isOne && isUnit ? 1e-7 : isOne || isUnit ? 1e-6 : 1e-2;
    if (!this->AreRough)
    {
      this->expectWithin("FastMarching", "Reference", 0.0, 0.0, tolerance);
    }
  }

  /** The same seeds on a mesh of the same triangles, whose points are moved and renumbered. */
  void checkInvariance()
  {
    if (!this->isPlain() || this->Test.coincident == CoincidentPoints::Merge ||
      this->Test.seeds.size() > 1 || this->Test.seeds.empty() ||
      this->Test.seeds[0].points[0].weights[0] != 1.0 ||
      this->Test.seeds[0].kind != Seed::Kind::Point)
    {
      return;
    }
    const Index vertex = this->Mesh.triangle(this->Test.seeds[0].points[0].triangle)[0];
    std::vector<Index> newId;
    Surface other = shuffled(this->Test.surface, 7, newId);
    for (Vector3& p : other.points)
    {
      p = { 2.0 * p.y, 2.0 * p.z, 2.0 * p.x };
    }
    std::shared_ptr<const TriangleMesh> mesh;
    try
    {
      mesh = meshOf(other);
    }
    catch (const std::invalid_argument&)
    {
      // Twice as large, it can be too large.
      return;
    }
    for (const char* name : { "Dijkstra", "Exact" })
    {
      const auto known = this->Fields.find(name);
      const Seed seed = seedAt(*mesh, newId[this->Mesh.pointOfVertex(vertex)]);
      const auto field = this->solve(solverOfName(name), mesh, { seed }, {});
      if (!field || known == this->Fields.end())
      {
        continue;
      }
      bool isSame = true;
      for (Index v = 0; v < this->Mesh.numberOfVertices(); ++v)
      {
        const Index point = newId[this->Mesh.pointOfVertex(v)];
        if (mesh->vertexOfPoint(point) == NoIndex)
        {
          continue;
        }
        const double there = (*field)[mesh->vertexOfPoint(point)];
        isSame = isSame &&
          (there == 2.0 * known->second[v] ||
            std::abs(there - 2.0 * known->second[v]) <= 2.0 * this->rounding(known->second[v]));
      }
      this->expect(isSame, std::string(name) + " changes with order, axes or size");
      // From the other end.
      const Index far = this->Mesh.triangles().back()[0];
      const Seed back = Seed::atPoint(this->Mesh.pointAtVertex(far));
      if (const auto returned = this->solve(solverOfName(name), this->Test.mesh, { back }, {}))
      {
        const double there = known->second[far];
        const double here = (*returned)[vertex];
        this->expect(there == here || std::abs(there - here) <= this->rounding(there),
          std::string(name) + " is not the same from both ends");
      }
    }
  }

  void checkPaths()
  {
    const std::vector<SurfacePoint> starts{ { 0, { 0.2, 0.3, 0.5 } },
      { this->Mesh.numberOfTriangles() - 1, { 1.0, 0.0, 0.0 } } };
    const Seed& seed = this->Test.seeds[0];
    if (seed.kind != Seed::Kind::Point)
    {
      return;
    }
    for (const char* name : { "FastMarching", "Dijkstra", "Exact" })
    {
      for (const SurfacePoint& start : starts)
      {
        const bool isAlongEdges = std::string(name) == "Dijkstra";
        const PathStyle style{ isAlongEdges ? PathOrder::Vertices : PathOrder::Edges,
          !isAlongEdges };
        this->checkPath(name, start, seed.points[0], style);
      }
    }
  }

  void checkPath(const std::string& name, const SurfacePoint& start, const SurfacePoint& end,
    const PathStyle& style)
  {
    const std::string what = name + ": a path ";
    try
    {
      const auto solver = solverOfName(name).make(this->Test.mesh);
      const std::size_t before = WorkCount::steps();
      bool isTooLong = false;
      SolveOptions options = this->Test.options();
      options.onProgress = [&](std::size_t)
      { return !(isTooLong = WorkCount::steps() - before > MostSteps); };
      const auto path = shortestPath(*solver, start, end, options, style);
      this->expect(!isTooLong, what + "does not end");
      if (!path)
      {
        return;
      }
      ++this->Report.paths;
      const Vector3 from = this->Mesh.positionOf(start);
      const Vector3 to = this->Mesh.positionOf(end);
      const double length = lengthOf(this->Mesh, *path);
      this->expect(length < Infinity && length + this->rounding(length) >= norm(from - to),
        what + "is shorter than the straight line");
      this->expect(norm(path->front().position(this->Mesh) - from) <= this->rounding(length) &&
          norm(path->back().position(this->Mesh) - to) <= this->rounding(length),
        what + "begins or ends elsewhere");
      for (std::size_t i = 1; i < path->size(); ++i)
      {
        const Triangle face = faceOf(this->Mesh, (*path)[i - 1], (*path)[i]);
        this->expect(
          liesIn((*path)[i - 1], face) && liesIn((*path)[i], face), what + "leaves the surface");
      }
      const auto known = this->Fields.find(name);
      if (name == "Exact" && start.weights[0] == 1.0 && known != this->Fields.end())
      {
        const double distance = known->second[this->Mesh.triangle(start.triangle)[0]];
        this->expect(std::abs(length - distance) <= this->rounding(distance, 1e-7),
          what + "has another length than the field: " + textOf(length / distance));
      }
    }
    catch (const std::invalid_argument&)
    {
      ++this->Report.refusedRequests;
    }
    catch (const std::runtime_error& error)
    {
      ++this->Report.budgetsReached;
      this->expect(std::string(error.what()).find("does not settle") != std::string::npos,
        what + error.what());
    }
    catch (const std::exception& error)
    {
      this->expect(false, what + "throws " + error.what());
    }
  }

  const NastyCase& Test;
  PromiseReport& Report;
  const TriangleMesh& Mesh;
  /** The largest coordinate. */
  double Size = 0.0;
  std::map<std::string, Field> Fields;
  /** Whether the front of a tier of fast marching settled only roughly. */
  bool AreRough = false;
};

}

void checkPromises(const NastyCase& test, PromiseReport& report)
{
  ++report.cases;
  if (!test.mesh)
  {
    ++report.refusedSurfaces;
    if (test.refusal.find(test.kind == NastyKind::NotFinite ? "Point " : "1e+30") ==
      std::string::npos)
    {
      report.broken.push_back("A surface is refused without a reason: " + test.refusal);
    }
    return;
  }
  if (test.kind == NastyKind::NotFinite)
  {
    report.broken.push_back("A point that is not finite is taken");
  }
  if (test.mesh->numberOfTriangles() > 0)
  {
    Checker(test, report).check();
  }
}

}
