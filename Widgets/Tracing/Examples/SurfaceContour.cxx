// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceContour.h"

#include "vtkCellArray.h"
#include "vtkCellPicker.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPolyDataCollection.h"
#include "vtkPolygonalSurfacePointPlacer.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace geodesic::examples
{

SurfaceContour::SurfaceContour(SurfaceWindow& window, int method, int order, double heightOffset)
  : Window(window)
{
  vtkNew<vtkPolygonalSurfacePointPlacer> placer;
  placer->AddProp(window.actor());
  placer->GetPolys()->AddItem(window.surface());
  placer->GetCellPicker()->AddLocator(window.locator());
  placer->SetDistanceOffset(heightOffset);
  this->Interpolator->GetPolys()->AddItem(window.surface());
  this->Interpolator->SetGeodesicMethod(method);
  this->Interpolator->SetInterpolationOrder(order);
  this->Interpolator->SetDistanceOffset(heightOffset);

  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(24);
  ball->Update();
  this->Representation->SetCursorShape(ball->GetOutput());
  this->Representation->SetActiveCursorShape(ball->GetOutput());
  this->Representation->SetHandleSize(0.012);
  this->Representation->GetProperty()->SetColor(0.85, 0.1, 0.1);
  this->Representation->GetActiveProperty()->SetColor(1.0, 0.6, 0.0);
  this->Representation->GetActiveProperty()->SetRepresentationToSurface();
  this->Representation->GetLinesProperty()->SetColor(0.1, 0.25, 0.75);
  this->Representation->GetLinesProperty()->SetLineWidth(4.0);
  this->Representation->SetPointPlacer(placer);
  this->Representation->SetLineInterpolator(this->Interpolator);

  this->Widget->SetInteractor(window.interactor());
  this->Widget->SetDefaultRenderer(window.renderer());
  this->Widget->SetRepresentation(this->Representation);
  this->Widget->On();

  // Undo goes back to the state before the widget handles a button or a key, so that state is
  // observed first.
  const float first = this->Widget->GetPriority() + 0.1f;
  for (unsigned long event : { vtkCommand::LeftButtonPressEvent, vtkCommand::RightButtonPressEvent,
         vtkCommand::MiddleButtonPressEvent, vtkCommand::KeyPressEvent })
  {
    window.interactor()->AddObserver(event, this, &SurfaceContour::remember, first);
  }
  window.interactor()->AddObserver(vtkCommand::KeyPressEvent, this, &SurfaceContour::onKey);
  for (unsigned long event : { vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent })
  {
    this->Widget->AddObserver(event, this, &SurfaceContour::onWidgetEvent);
  }
}

void SurfaceContour::setNodes(const std::vector<vtkIdType>& pointIds)
{
  vtkPolyData* surface = this->Window.surface();
  State state;
  for (vtkIdType id : pointIds)
  {
    if (id < 0 || id >= surface->GetNumberOfPoints())
    {
      throw std::invalid_argument("There is no point " + std::to_string(id) + ": the surface has " +
        std::to_string(surface->GetNumberOfPoints()) + " points, numbered from 0.");
    }
    Node node{ id, {} };
    surface->GetPoint(id, node.position.data());
    state.nodes.push_back(node);
  }
  state.isFinished = true;
  this->restore(state);
}

std::vector<vtkIdType> SurfaceContour::pointIds() const
{
  vtkNew<vtkIdList> ids;
  this->Interpolator->GetContourPointIds(this->Representation, ids);
  return { ids->begin(), ids->end() };
}

std::vector<vtkIdType> SurfaceContour::nodeIds() const
{
  const std::vector<vtkIdType> along = this->pointIds();
  std::vector<vtkIdType> ids;
  std::size_t next = 0;
  for (int i = 0; i < this->numberOfNodes(); ++i)
  {
    ids.push_back(along[next]);
    next += 1 + this->Representation->GetNumberOfIntermediatePoints(i);
  }
  return ids;
}

double SurfaceContour::length() const
{
  double length = 0.0;
  for (int i = 0; i < this->numberOfNodes(); ++i)
  {
    const auto& points = this->Representation->GetNthNode(i)->Points;
    for (std::size_t k = 1; k < points.size(); ++k)
    {
      length += std::sqrt(
        vtkMath::Distance2BetweenPoints(points[k - 1]->WorldPosition, points[k]->WorldPosition));
    }
  }
  return length;
}

SurfaceContour::State SurfaceContour::state() const
{
  State state;
  for (vtkIdType id : this->nodeIds())
  {
    Node node{ id, {} };
    const int number = static_cast<int>(state.nodes.size());
    this->Representation->GetNthNodeWorldPosition(number, node.position.data());
    state.nodes.push_back(node);
  }
  state.isClosed = this->isClosed();
  state.isFinished = this->Widget->GetWidgetState() == vtkContourWidget::Manipulate;
  return state;
}

void SurfaceContour::restore(const State& state)
{
  this->Representation->ClearAllNodes();
  this->Widget->Initialize(nullptr);
  if (!state.nodes.empty())
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkIdList> ids;
    vtkNew<vtkIdList> line;
    for (const Node& node : state.nodes)
    {
      line->InsertNextId(points->InsertNextPoint(node.position.data()));
      ids->InsertNextId(node.id);
    }
    if (state.isClosed)
    {
      line->InsertNextId(0);
    }
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(line);
    vtkNew<vtkPolyData> contour;
    contour->SetPoints(points);
    // A line needs at least two points.
    if (state.nodes.size() > 1)
    {
      contour->SetLines(cells);
    }
    else
    {
      contour->SetVerts(cells);
    }
    this->Widget->Initialize(contour, state.isFinished ? 1 : 0, ids);
  }
  this->Window.interactor()->Render();
}

void SurfaceContour::remember(vtkObject*, unsigned long, void*)
{
  State now = this->state();
  if (this->History.empty() || this->History.back() != now)
  {
    this->History.push_back(std::move(now));
  }
}

void SurfaceContour::onKey(vtkObject*, unsigned long, void*)
{
  const char* key = this->Window.interactor()->GetKeySym();
  if (!key || std::string(key) != "z")
  {
    return;
  }
  // The last state in the history is the one before this key, which changed nothing.
  if (this->History.size() > 1)
  {
    this->History.pop_back();
    this->restore(this->History.back());
    this->onWidgetEvent(nullptr, vtkCommand::EndInteractionEvent, nullptr);
  }
}

void SurfaceContour::onWidgetEvent(vtkObject*, unsigned long, void*)
{
  const bool isDragged =
    this->Representation->GetCurrentOperation() != vtkContourRepresentation::Inactive;
  if (this->Action && !isDragged)
  {
    this->Action();
  }
}

}
