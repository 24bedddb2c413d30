// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TracedContour.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkIdList.h"
#include "vtkInteractorEventRecorder.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataCollection.h"
#include "vtkPolyDataMapper.h"

#include <cmath>
#include <map>
#include <sstream>

namespace geodesic::testing
{

vtkStandardNewMacro(NotingInterpolator);

int NotingInterpolator::InterpolateLine(
  vtkRenderer* ren, vtkContourRepresentation* rep, int idx1, int idx2)
{
  this->Lines.emplace_back(idx1, idx2);
  this->LastResult = this->Superclass::InterpolateLine(ren, rep, idx1, idx2);
  return this->LastResult;
}

TracedContour::TracedContour()
{
  lookAtPlane(this->Renderer);
  this->Window->SetSize(400, 400);
  this->Window->OffScreenRenderingOn();
  this->Window->AddRenderer(this->Renderer);
  this->Interactor->SetRenderWindow(this->Window);
  this->Interactor->Initialize();
  this->Contour->SetPointPlacer(this->Placer);
  this->Contour->SetLineInterpolator(this->Interpolator);
  this->Widget->SetInteractor(this->Interactor);
  this->Widget->SetDefaultRenderer(this->Renderer);
  this->Widget->SetRepresentation(this->Contour);
  this->Widget->On();
}

void TracedContour::addSurface(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  this->Renderer->ResetCameraClippingRange();
  this->Placer->AddProp(actor);
  this->Placer->GetPolys()->AddItem(surface);
  this->Interpolator->GetPolys()->AddItem(surface);
}

void TracedContour::tellPlacer(vtkPolyData* surface, vtkIdType id, double position[3])
{
  surface->GetPoint(id, position);
  // The placer records such a node on the first surface of its list.
  vtkPolyDataCollection* surfaces = this->Placer->GetPolys();
  surfaces->RemoveAllItems();
  surfaces->AddItem(surface);
  this->Placer->UpdateNodeWorldPosition(position, id);
}

void TracedContour::addNode(vtkPolyData* surface, vtkIdType id)
{
  double position[3];
  this->tellPlacer(surface, id, position);
  this->Contour->AddNodeAtWorldPosition(position);
}

void TracedContour::moveNode(int node, vtkPolyData* surface, vtkIdType id)
{
  double position[3];
  this->tellPlacer(surface, id, position);
  this->Contour->SetNthNodeWorldPosition(node, position);
}

void TracedContour::clear()
{
  this->Contour->ClearAllNodes();
  this->Contour->ClosedLoopOff();
}

std::vector<vtkIdType> TracedContour::lineIds(int node) const
{
  std::vector<vtkIdType> ids;
  for (const vtkContourRepresentationPoint* point : this->Contour->GetNthNode(node)->Points)
  {
    ids.push_back(point->PointId);
  }
  return ids;
}

double TracedContour::lineLength(int node) const
{
  const auto& points = this->Contour->GetNthNode(node)->Points;
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += std::sqrt(
      vtkMath::Distance2BetweenPoints(points[i - 1]->WorldPosition, points[i]->WorldPosition));
  }
  return length;
}

std::vector<vtkIdType> TracedContour::contourIds() const
{
  vtkNew<vtkIdList> ids;
  this->Interpolator->GetContourPointIds(this->Contour, ids);
  return { ids->begin(), ids->end() };
}

void TracedContour::play(const std::vector<Event>& events)
{
  playRecording(this->Interactor, this->Renderer, events);
}

void lookAtPlane(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(10.5, 10.5, 0.0);
  camera->SetPosition(10.5, 10.5, 100.0);
  camera->SetParallelScale(12.5);
  camera->SetClippingRange(1.0, 200.0);
}

std::vector<TracedContour::Event> click(double x, double y)
{
  return { { "MouseMoveEvent", x, y }, { "LeftButtonPressEvent", x, y },
    { "LeftButtonReleaseEvent", x, y } };
}

std::vector<TracedContour::Event> drag(double fromX, double fromY, double toX, double toY)
{
  return { { "MouseMoveEvent", fromX, fromY }, { "LeftButtonPressEvent", fromX, fromY },
    { "MouseMoveEvent", 0.5 * (fromX + toX), 0.5 * (fromY + toY) }, { "MouseMoveEvent", toX, toY },
    { "LeftButtonReleaseEvent", toX, toY } };
}

std::vector<TracedContour::Event> pressKey(const std::string& key, double x, double y)
{
  return { { "MouseMoveEvent", x, y }, { "KeyPressEvent", x, y, key },
    { "KeyReleaseEvent", x, y, key } };
}

void playRecording(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer,
  const std::vector<TracedContour::Event>& events)
{
  const std::map<std::string, int> codes{ { "0", 0 }, { "Delete", 127 }, { "z", 'z' } };
  std::ostringstream recording;
  recording << "# StreamVersion 1.1\n";
  for (const TracedContour::Event& event : events)
  {
    renderer->SetWorldPoint(event.x, event.y, 0.0, 1.0);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    recording << event.name << " " << std::lround(display[0]) << " " << std::lround(display[1])
              << " 0 " << codes.at(event.key) << " 0 " << event.key << "\n";
  }
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(interactor);
  recorder->ReadFromInputStringOn();
  recorder->SetInputString(recording.str().c_str());
  recorder->Play();
}

}
