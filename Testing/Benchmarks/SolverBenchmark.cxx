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
#include <random>
#include <string>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr int Runs = 5;

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

/** The true distance of each point from a source. */
using Truth = std::function<std::vector<double>(Index source)>;

/** Mean error of all points, in parts of the largest distance; a true -1 is a point off the
 * surface. */
double errorOfLargest(const std::vector<double>& distances, const std::vector<double>& truth)
{
  const double largest = *std::max_element(truth.begin(), truth.end());
  double sum = 0.0;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    if (truth[i] >= 0.0)
    {
      sum += std::abs(distances[i] - truth[i]);
      ++counted;
    }
  }
  return sum / largest / static_cast<double>(counted);
}

void measure(const std::string& name, const Surface& surface, const Truth& truth)
{
  const auto mesh = meshOf(surface);
  YardstickDijkstra dijkstra(*mesh);
  FastMarchingSolver solver(mesh);
  std::mt19937 random(1);
  std::vector<double> setup, yardstick, marching, ratio;
  double ofLargest = 0.0;
  double ofOwn = 0.0;
  for (int run = 0; run < Runs; ++run)
  {
    const Index source = random() % mesh->numberOfVertices();
    const Seed seed = Seed::atPoint(mesh->pointAtVertex(source));
    setup.push_back(seconds([&] { meshOf(surface); }));
    yardstick.push_back(seconds([&] { dijkstra.solve(source); }));
    marching.push_back(seconds([&] { solver.solve({ &seed, 1 }); }));
    ratio.push_back(marching.back() / yardstick.back());
    const auto d = distances<FastMarchingSolver>(mesh, { seed });
    const auto exact = truth(mesh->pointOfVertex(source));
    ofLargest += errorOfLargest(d, exact) / Runs;
    ofOwn += relativeError(d, exact).mean / Runs;
  }
  const double perVertex = 1e9 / mesh->numberOfVertices();
  std::printf("%-16s %8u vertices  Dijkstra %6.1f ns  setup %6.1f ns  march %6.1f ns  ratio %5.2f"
              "  mean error %.2e of the largest distance, %.2e of each point's own\n",
    name.c_str(), mesh->numberOfVertices(), perVertex * median(yardstick),
    perVertex * median(setup), perVertex * median(marching), median(ratio), ofLargest, ofOwn);
}

std::vector<double> straightLines(const Surface& surface, Index source)
{
  std::vector<double> truth;
  for (const Vector3& p : surface.points)
  {
    truth.push_back(norm(p - surface.points[source]));
  }
  return truth;
}

std::vector<double> greatCircles(const Surface& sphere, Index source)
{
  std::vector<double> truth;
  const Vector3& a = sphere.points[source];
  for (const Vector3& b : sphere.points)
  {
    truth.push_back(std::atan2(norm(cross(a, b)), dot(a, b)));
  }
  return truth;
}

}

int main()
{
  for (int levels : { 5, 7, 8 })
  {
    const Surface sphere = icosphere(levels);
    measure("icosphere", sphere, [&](Index source) { return greatCircles(sphere, source); });
  }
  const Surface plane = delaunayPlane(160000, 1);
  measure("Delaunay plane", plane, [&](Index source) { return straightLines(plane, source); });
  const Surface thin = jitteredGrid(1265, 126, 1.0, 1.0, 0.4, 1);
  measure("thin grid", thin, [&](Index source) { return straightLines(thin, source); });
  const Surface bunny = readOff(GEODESICS_OFF_DIRECTORY "/Bunny.off");
  measure("Bunny", bunny, [&](Index source) { return exactDistances(bunny, { source }); });
  return 0;
}
