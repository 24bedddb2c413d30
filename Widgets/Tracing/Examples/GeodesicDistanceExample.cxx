// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours a surface by the geodesic distance from a point, and writes it with the distances.

#include "DistanceColors.h"
#include "SurfaceContour.h"
#include "SurfaceFile.h"

#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkInteractorObserver.h"
#include "vtkPointData.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>

using namespace geodesic::examples;

namespace
{

constexpr const char* usage =
  "usage: GeodesicDistanceExample mesh.vtp out.vtp [options]\n"
  "\n"
  "Click on the surface: the distances from there, in the array FMMDist, colour it and\n"
  "are written to out.vtp. What no distance is known of has -1 and stays grey.\n"
  "With --exclusionContour first trace a closed contour round the point, see\n"
  "GeodesicPathExample; the distances end there.\n"
  "Drag to turn the surface; q quits.\n";

struct DistanceOptions
{
  std::string mesh;
  std::string output;
  /** Negative: no limit. */
  double maximumDistance = -1.0;
  /** Empty: none. */
  std::string weights;
  bool hasContour = false;
};

/** The surface, where its seeds are, and the distances from them. */
class DistanceProgram
{
public:
  DistanceProgram(const DistanceOptions& options, const RunOptions& runOptions);

  void run();

private:
  void setOptions();
  /** @return whether the seeds are complete; with a contour, they are once it is closed */
  bool isReady() const { return !this->Contour || this->Contour->isClosed(); }
  void computeFrom(const std::vector<vtkIdType>& seeds);
  void onPress(vtkObject*, unsigned long, void*);
  void onRelease(vtkObject*, unsigned long, void*);

  DistanceOptions Options;
  std::vector<vtkIdType> Seeds;
  vtkSmartPointer<vtkPolyData> Surface;
  vtkNew<vtkFastMarchingGeodesicDistance> Distance;
  SurfaceWindow Window;
  DistanceColors Colors;
  std::optional<SurfaceContour> Contour;
  std::optional<std::array<int, 2>> PressedAt;
};

DistanceProgram::DistanceProgram(const DistanceOptions& options, const RunOptions& runOptions)
  : Options(options)
  , Seeds(runOptions.seeds)
  , Surface(readSurface(options.mesh))
  , Window("Geodesic distance", this->Surface, runOptions)
  , Colors(this->Window)
{
  this->setOptions();
  if (options.hasContour)
  {
    this->Contour.emplace(
      this->Window, vtkPolygonalSurfaceContourLineInterpolator2::DijkstraMethod, 0, 0.0);
  }
  // The press is observed after the contour's widget, which keeps the events that it uses from
  // others, and before the camera's style, which keeps all events from the press on. The style
  // itself tells when the interaction ends.
  vtkRenderWindowInteractor* interactor = this->Window.interactor();
  interactor->AddObserver(vtkCommand::LeftButtonPressEvent, this, &DistanceProgram::onPress, 0.1f);
  interactor->GetInteractorStyle()->AddObserver(
    vtkCommand::EndInteractionEvent, this, &DistanceProgram::onRelease);
}

void DistanceProgram::setOptions()
{
  this->Distance->SetInputData(this->Surface);
  this->Distance->SetFieldDataName("FMMDist");
  this->Distance->SetDistanceStopCriterion(this->Options.maximumDistance);
  if (!this->Options.weights.empty())
  {
    vtkDataArray* weights = this->Surface->GetPointData()->GetArray(this->Options.weights.c_str());
    if (!weights)
    {
      throw std::invalid_argument(
        this->Options.mesh + " has no point array \"" + this->Options.weights + "\".");
    }
    this->Distance->SetPropagationWeights(weights);
  }
}

void DistanceProgram::run()
{
  this->Window.run();
  if (!this->Seeds.empty())
  {
    if (!this->isReady())
    {
      throw std::runtime_error("The exclusion contour is not closed; let --events close it.");
    }
    this->computeFrom(this->Seeds);
  }
  this->Window.writeScreenshot();
}

void DistanceProgram::computeFrom(const std::vector<vtkIdType>& seeds)
{
  const auto listOf = [](const std::vector<vtkIdType>& ids)
  {
    auto list = vtkSmartPointer<vtkIdList>::New();
    for (vtkIdType id : ids)
    {
      list->InsertNextId(id);
    }
    return list;
  };
  this->Distance->SetSeeds(listOf(seeds));
  if (this->Contour)
  {
    this->Distance->SetExclusionPointIds(listOf(this->Contour->pointIds()));
  }
  this->Distance->Update();
  vtkPolyData* output = this->Distance->GetOutput();
  if (output->GetNumberOfPoints() == 0)
  {
    throw std::runtime_error("No distances were computed: the message above says why.");
  }
  this->Colors.show(
    output->GetPointData()->GetArray("FMMDist"), this->Distance->GetMaximumDistance());
  this->Colors.markSeeds(seeds);
  writeSurface(output, this->Options.output);
  std::cout << "seed";
  for (vtkIdType id : seeds)
  {
    std::cout << " " << id;
  }
  std::cout << ", maximum distance " << this->Distance->GetMaximumDistance() << ", points "
            << this->Distance->GetNumberOfVisitedPoints() << std::endl;
}

void DistanceProgram::onPress(vtkObject*, unsigned long, void*)
{
  const int* position = this->Window.interactor()->GetEventPosition();
  this->PressedAt = { position[0], position[1] };
}

void DistanceProgram::onRelease(vtkObject*, unsigned long, void*)
{
  constexpr double mostMoved = 3.0;
  const int* position = this->Window.interactor()->GetEventPosition();
  const bool isClick = this->PressedAt &&
    std::hypot(position[0] - (*this->PressedAt)[0], position[1] - (*this->PressedAt)[1]) <=
      mostMoved;
  this->PressedAt.reset();
  const std::optional<vtkIdType> id =
    isClick && this->isReady() ? this->Window.pointAt(position[0], position[1]) : std::nullopt;
  if (id)
  {
    this->computeFrom({ *id });
    this->Window.interactor()->Render();
  }
}

int run(int argc, char* argv[])
{
  Arguments arguments(usage);
  DistanceOptions options;
  std::string maximum;
  arguments.addText("--maxDist", maximum, "Distances end here, in the mesh's unit of length.");
  arguments.addText("--propagationWts", options.weights,
    "A point array with the cost of a unit of length; all of it positive.");
  arguments.addFlag("--exclusionContour", options.hasContour,
    "The distances end at a closed contour, which is traced first.");
  if (!arguments.parse(argc, argv, 2, 2))
  {
    return EXIT_SUCCESS;
  }
  options.mesh = arguments.positional()[0];
  options.output = arguments.positional()[1];
  if (!maximum.empty())
  {
    options.maximumDistance = numberIn(maximum, "--maxDist");
    if (options.maximumDistance < 0.0)
    {
      throw std::invalid_argument("--maxDist is " + maximum + "; it must not be negative.");
    }
  }
  DistanceProgram(options, arguments.runOptions()).run();
  return EXIT_SUCCESS;
}

}

int main(int argc, char* argv[])
{
  try
  {
    return run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::cerr << "GeodesicDistanceExample: " << error.what() << " See --help." << std::endl;
    return EXIT_FAILURE;
  }
}
