// The whole-field solve beside Dijkstra's on the same mesh, with the relative error of the field:
//   SolverBenchmark
// Times are medians in nanoseconds a vertex, ratios medians of the runs' ratios; to be run on one
// core.

#include "DijkstraSolver.h"
#include "ExactDistances.h"
#include "FastMarchingSolver.h"
#include "Solving.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <queue>
#include <string>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr int Runs = 7;

double seconds(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/** The yardstick: textbook Dijkstra with a binary heap on flat arrays, lengths stored. */
class YardstickDijkstra
{
public:
  explicit YardstickDijkstra(const TriangleMesh& mesh)
    : Distances(mesh.numberOfVertices())
  {
    for (Index v = 0; v < mesh.numberOfVertices(); ++v)
    {
      this->Starts.push_back(static_cast<Index>(this->Edges.size()));
      std::vector<Index> neighbours;
      for (const RingEntry& entry : mesh.ring(v))
      {
        neighbours.push_back(entry.neighbour());
      }
      std::sort(neighbours.begin(), neighbours.end());
      neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
      for (Index n : neighbours)
      {
        this->Edges.push_back({ norm(mesh.position(n) - mesh.position(v)), n });
      }
    }
    this->Starts.push_back(static_cast<Index>(this->Edges.size()));
  }

  double solve(Index source)
  {
    std::fill(this->Distances.begin(), this->Distances.end(), DistanceField::Unreached);
    std::priority_queue<Trial, std::vector<Trial>, std::greater<>> heap;
    this->Distances[source] = 0.0;
    heap.push({ 0.0, source });
    double last = 0.0;
    while (!heap.empty())
    {
      const auto [distance, vertex] = heap.top();
      heap.pop();
      if (distance > this->Distances[vertex])
      {
        continue;
      }
      last = distance;
      for (Index e = this->Starts[vertex]; e < this->Starts[vertex + 1]; ++e)
      {
        const double through = distance + this->Edges[e].length;
        if (through < this->Distances[this->Edges[e].to])
        {
          this->Distances[this->Edges[e].to] = through;
          heap.push({ through, this->Edges[e].to });
        }
      }
    }
    return last;
  }

private:
  struct Edge
  {
    double length;
    Index to;
  };
  using Trial = std::pair<double, Index>;
  std::vector<Index> Starts;
  std::vector<Edge> Edges;
  std::vector<double> Distances;
};

using Truth = std::function<double(Index point)>;

void measure(const std::string& name, const Surface& surface, Index source, const Truth& truth)
{
  std::shared_ptr<const TriangleMesh> mesh;
  std::vector<double> setup, yardstick, marching, ratio;
  setup.push_back(
    seconds([&] { mesh = std::make_shared<TriangleMesh>(surface.points, surface.triangles); }));
  YardstickDijkstra dijkstra(*mesh);
  FastMarchingSolver solver(mesh);
  const Index vertex = mesh->vertexOfPoint(source);
  const Seed seed = seedAt(*mesh, source);
  const DistanceField* field = nullptr;
  for (int run = 0; run < Runs; ++run)
  {
    setup.push_back(seconds([&] { TriangleMesh again(surface.points, surface.triangles); }));
    yardstick.push_back(seconds([&] { dijkstra.solve(vertex); }));
    marching.push_back(seconds([&] { field = &solver.solve({ &seed, 1 }); }));
    ratio.push_back(marching.back() / yardstick.back());
  }
  double sum = 0.0, largest = 0.0, worst = 0.0;
  std::size_t counted = 0;
  for (Index i = 0; i < surface.points.size(); ++i)
  {
    largest = std::max(largest, truth(i));
  }
  for (Index i = 0; i < surface.points.size(); ++i)
  {
    const double exact = truth(i);
    if (exact > 0.0 && mesh->vertexOfPoint(i) != NoIndex)
    {
      const double error = std::abs(field->distance(mesh->vertexOfPoint(i)) - exact) / exact;
      sum += error;
      worst = exact > 0.05 * largest ? std::max(worst, error) : worst;
      ++counted;
    }
  }
  const double perVertex = 1e9 / mesh->numberOfVertices();
  std::printf("%-16s %8u vertices  Dijkstra %6.1f ns  setup %6.1f ns  march %6.1f ns  ratio %5.2f"
              "  error mean %.2e max %.2e\n",
    name.c_str(), mesh->numberOfVertices(), perVertex * median(yardstick),
    perVertex * median(setup), perVertex * median(marching), median(ratio), sum / counted, worst);
}

Truth straightLine(const Surface& surface, Index source)
{
  return [&surface, source](Index i) { return norm(surface.points[i] - surface.points[source]); };
}

}

int main()
{
  for (int levels : { 5, 7, 8 })
  {
    const Surface sphere = icosphere(levels);
    measure("icosphere", sphere, 0,
      [&](Index i)
      {
        const Vector3& a = sphere.points[0];
        const Vector3& b = sphere.points[i];
        return std::atan2(norm(cross(a, b)), dot(a, b));
      });
  }
  const Surface plane = delaunayPlane(160000, 1);
  measure("Delaunay plane", plane, 80000, straightLine(plane, 80000));
  const Surface thin = jitteredGrid(1265, 126, 1.0, 1.0, 0.4, 1);
  measure("thin grid", thin, 80000, straightLine(thin, 80000));
  const Surface bunny = readOff(GEODESICS_OFF_DIRECTORY "/Bunny.off");
  const std::vector<double> exact = exactDistances(bunny, { 0 });
  measure("Bunny", bunny, 0, [&](Index i) { return exact[i]; });
  return 0;
}
