// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// How long one step of dragging a contour's node takes without rendering: the two lines beside it
// are traced again. Beside ours VTK's own interpolator, step by step in turn.
// usage: TracingBenchmark Bunny.vtp [STEPS]

#include "Measuring.h"

#include "vtkCamera.h"
#include "vtkContourRepresentation.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkOrientedGlyphContourRepresentation.h"
#include "vtkPolyData.h"
#include "vtkPolyDataCollection.h"
#include "vtkPolygonalSurfaceContourLineInterpolator.h"
#include "vtkPolygonalSurfaceContourLineInterpolator2.h"
#include "vtkPolygonalSurfacePointPlacer.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTriangle.h"
#include "vtkVersion.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace
{

/** An open contour of three nodes, of which the middle one is dragged. */
class DraggedContour
{
public:
  DraggedContour(vtkRenderer* renderer, vtkPolyData* surface, vtkContourLineInterpolator* lines)
    : Surface(surface)
  {
    this->Placer->GetPolys()->AddItem(surface);
    this->Contour->SetRenderer(renderer);
    this->Contour->SetPointPlacer(this->Placer);
    this->Contour->SetLineInterpolator(lines);
  }

  void setNodes(const std::array<vtkIdType, 3>& ids)
  {
    this->Contour->ClearAllNodes();
    for (vtkIdType id : ids)
    {
      double position[3];
      this->tellPlacer(id, position);
      this->Contour->AddNodeAtWorldPosition(position);
    }
  }

  /** Milliseconds of processor time. */
  double drag(vtkIdType id)
  {
    double position[3];
    this->tellPlacer(id, position);
    return 1e3 *
      geodesic::testing::seconds([&] { this->Contour->SetNthNodeWorldPosition(1, position); });
  }

  int numberOfPoints() const
  {
    return this->Contour->GetNumberOfIntermediatePoints(0) +
      this->Contour->GetNumberOfIntermediatePoints(1);
  }

private:
  void tellPlacer(vtkIdType id, double position[3])
  {
    this->Surface->GetPoint(id, position);
    this->Placer->UpdateNodeWorldPosition(position, id);
  }

  vtkPolyData* Surface;
  vtkNew<vtkPolygonalSurfacePointPlacer> Placer;
  vtkNew<vtkOrientedGlyphContourRepresentation> Contour;
};

/** Places on a surface, at random and as one clicks: a large cell is hit more often than a small.
 */
class Places
{
public:
  explicit Places(vtkPolyData* surface)
    : Surface(surface)
  {
    std::vector<double> areas;
    for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
    {
      const auto ids = this->corners(cell);
      double p[3][3];
      for (int i = 0; i < 3; ++i)
      {
        surface->GetPoint(ids[i], p[i]);
      }
      areas.push_back(vtkTriangle::TriangleArea(p[0], p[1], p[2]));
    }
    this->AnyCell = std::discrete_distribution<vtkIdType>(areas.begin(), areas.end());
  }

  vtkIdType any() { return this->corners(this->AnyCell(this->Random))[0]; }

  /** A point at a distance in space. */
  vtkIdType at(double distance, vtkIdType from)
  {
    for (;;)
    {
      const vtkIdType id = this->any();
      if (std::abs(this->distance(id, from) - distance) < 0.02 * distance)
      {
        return id;
      }
    }
  }

  /** A point beside, as from one move of the mouse to the next. */
  vtkIdType beside(vtkIdType from)
  {
    vtkNew<vtkIdList> cells;
    this->Surface->GetPointCells(from, cells);
    const auto ids = this->corners(cells->GetId(0));
    return *std::find_if(ids.begin(), ids.end(), [&](vtkIdType id) { return id != from; });
  }

private:
  std::vector<vtkIdType> corners(vtkIdType cell)
  {
    vtkNew<vtkIdList> ids;
    this->Surface->GetCellPoints(cell, ids);
    return { ids->begin(), ids->end() };
  }

  double distance(vtkIdType a, vtkIdType b)
  {
    double p[3];
    double q[3];
    this->Surface->GetPoint(a, p);
    this->Surface->GetPoint(b, q);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  vtkPolyData* Surface;
  std::discrete_distribution<vtkIdType> AnyCell;
  std::mt19937 Random{ 1 };
};

struct Subject
{
  const char* name;
  vtkSmartPointer<vtkContourLineInterpolator> interpolator;
  std::size_t mostSteps;
  std::vector<double> times;
};

std::vector<Subject> subjects(std::size_t steps)
{
  const auto ours = [](int method, int order)
  {
    auto lines = vtkSmartPointer<vtkPolygonalSurfaceContourLineInterpolator2>::New();
    lines->SetGeodesicMethod(method);
    lines->SetInterpolationOrder(order);
    return lines;
  };
  return {
    { "fast marching, order 1", ours(1, 1), steps, {} },
    { "fast marching, order 0", ours(1, 0), steps, {} },
    { "Dijkstra", ours(0, 0), steps, {} },
    { "VTK's interpolator", vtkSmartPointer<vtkPolygonalSurfaceContourLineInterpolator>::New(),
      std::min<std::size_t>(steps, 2), {} },
  };
}

void measure(const char* name, vtkPolyData* surface, double apart, std::size_t steps)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera();
  surface->BuildLinks();

  std::vector<Subject> all = subjects(steps);
  Places places(surface);
  std::printf("%s, %lld points, nodes %g %% of the bounding box apart\n", name,
    static_cast<long long>(surface->GetNumberOfPoints()), 100.0 * apart);
  int points = 0;
  for (std::size_t step = 0; step < steps; ++step)
  {
    const vtkIdType dragged = places.any();
    const double distance = apart * surface->GetLength();
    const vtkIdType before = places.at(distance, dragged);
    const vtkIdType after = places.at(distance, dragged);
    for (Subject& subject : all)
    {
      if (step < subject.mostSteps)
      {
        DraggedContour contour(renderer, surface, subject.interpolator);
        contour.setNodes({ before, dragged, after });
        subject.times.push_back(contour.drag(places.beside(dragged)));
        points = std::max(points, contour.numberOfPoints());
      }
    }
  }
  for (Subject& subject : all)
  {
    std::sort(subject.times.begin(), subject.times.end());
    const std::size_t count = subject.times.size();
    std::printf("  %-24s median %8.2f   90 %% within %8.2f   largest %8.2f ms, of %zu steps\n",
      subject.name, subject.times[count / 2], subject.times[9 * count / 10], subject.times.back(),
      count);
  }
  std::printf("  lines of up to %d points\n", points);
}

}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: TracingBenchmark Bunny.vtp [STEPS]\n");
    return EXIT_FAILURE;
  }
  const std::size_t steps = argc > 2 ? std::stoul(argv[2]) : 50;
  std::printf("VTK %s\n", vtkVersion::GetVTKVersion());
  vtkNew<vtkXMLPolyDataReader> bunny;
  bunny->SetFileName(argv[1]);
  bunny->Update();
  measure("Bunny", bunny->GetOutput(), 0.2, steps);

  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(1000);
  sphere->SetPhiResolution(1002);
  sphere->Update();
  measure("Sphere", sphere->GetOutput(), 0.05, steps);
  return EXIT_SUCCESS;
}
