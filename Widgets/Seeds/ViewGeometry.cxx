// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewGeometry.h"

#include "pqQVTKWidget.h"
#include "pqRenderView.h"
#include "pqServer.h"
#include "vtkCamera.h"
#include "vtkPVRenderView.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMRenderViewProxy.h"

#include <algorithm>

namespace seeds
{

ViewGeometry::ViewGeometry(pqRenderView* view)
  : View(view)
  , Renderer(view->getRenderViewProxy()->GetRenderer())
{
}

double ViewGeometry::pixelsPerPoint() const
{
  auto* widget = qobject_cast<pqQVTKWidget*>(this->View->widget());
  return widget->effectiveDevicePixelRatio();
}

int ViewGeometry::windowHeight() const
{
  return this->Renderer->GetVTKWindow()->GetSize()[1];
}

std::optional<QPointF> ViewGeometry::toWidget(const Position& point) const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  Position eye;
  Position ahead;
  camera->GetPosition(eye.data());
  camera->GetDirectionOfProjection(ahead.data());
  if (!camera->GetParallelProjection() && dot(point - eye, ahead) <= 0.0)
  {
    return {};
  }
  const Position pixel = this->toWindow(point);
  const double ratio = this->pixelsPerPoint();
  return QPointF(pixel[0] / ratio, (this->windowHeight() - pixel[1]) / ratio);
}

Position ViewGeometry::toWindow(const Position& point) const
{
  this->Renderer->SetWorldPoint(point[0], point[1], point[2], 1.0);
  this->Renderer->WorldToDisplay();
  Position pixel;
  this->Renderer->GetDisplayPoint(pixel.data());
  return pixel;
}

Position ViewGeometry::toSpace(double x, double y, double depth) const
{
  this->Renderer->SetDisplayPoint(x, y, depth);
  this->Renderer->DisplayToWorld();
  const double* p = this->Renderer->GetWorldPoint();
  return { p[0] / p[3], p[1] / p[3], p[2] / p[3] };
}

Ray ViewGeometry::rayThrough(const QPointF& place) const
{
  const double ratio = this->pixelsPerPoint();
  const double x = place.x() * ratio;
  const double y = this->windowHeight() - place.y() * ratio;
  const Position near = this->toSpace(x, y, 0.0);
  return { near, this->toSpace(x, y, 1.0) - near };
}

std::array<int, 2> ViewGeometry::pixelAt(const QPointF& place) const
{
  const double ratio = this->pixelsPerPoint();
  return { static_cast<int>(place.x() * ratio),
    this->windowHeight() - 1 - static_cast<int>(place.y() * ratio) };
}

double ViewGeometry::drawnDepth(const std::array<int, 2>& pixel) const
{
  auto* window = vtkRenderWindow::SafeDownCast(this->Renderer->GetVTKWindow());
  const int* size = window->GetSize();
  const auto clamped = [size](int value, int axis) { return std::clamp(value, 0, size[axis] - 1); };
  std::array<float, (2 * DepthReach + 1) * (2 * DepthReach + 1)> depths{};
  window->GetZbufferData(clamped(pixel[0] - DepthReach, 0), clamped(pixel[1] - DepthReach, 1),
    clamped(pixel[0] + DepthReach, 0), clamped(pixel[1] + DepthReach, 1), depths.data());
  return *std::max_element(depths.begin(), depths.end());
}

bool ViewGeometry::isDrawnHere() const
{
  auto* view =
    vtkPVRenderView::SafeDownCast(this->View->getRenderViewProxy()->GetClientSideObject());
  return !this->View->getServer()->isRemote() || !view->GetUseDistributedRenderingForRender();
}

bool ViewGeometry::isCovered(const Position& point, double tolerance) const
{
  const bool wasDrawn = !this->Renderer->GetRenderWindow()->GetNeverRendered();
  const auto place = wasDrawn && this->isDrawnHere() ? this->toWidget(point) : std::nullopt;
  if (!place)
  {
    return false;
  }
  Position ahead;
  this->Renderer->GetActiveCamera()->GetDirectionOfProjection(ahead.data());
  const Position nearer = point - tolerance * ahead;
  return this->drawnDepth(this->pixelAt(*place)) < this->toWindow(nearer)[2];
}

QWidget* drawingWidgetOf(pqRenderView* view)
{
  return qobject_cast<pqQVTKWidget*>(view->widget())->renderWidget();
}

}
