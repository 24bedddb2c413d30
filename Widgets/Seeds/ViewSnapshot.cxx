// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewSnapshot.h"

#include "ViewGeometry.h"

#include "pqRenderView.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMRenderViewProxy.h"

#include <algorithm>

namespace seeds
{
namespace
{

/** Replaces each of some values, which lie a stride apart, by the largest one not far from it. */
void spreadLargest(float* values, int count, std::ptrdiff_t stride)
{
  std::vector<float> before(count);
  for (int i = 0; i < count; ++i)
  {
    before[i] = values[i * stride];
  }
  for (int i = 0; i < count; ++i)
  {
    const auto first = before.begin() + std::max(i - ViewGeometry::DepthReach, 0);
    const auto last = before.begin() + std::min(i + ViewGeometry::DepthReach + 1, count);
    values[i * stride] = *std::max_element(first, last);
  }
}

}

ViewSnapshot::ViewSnapshot(pqRenderView* view)
  : PixelsPerPoint(ViewGeometry(view).pixelsPerPoint())
{
  vtkRenderer* renderer = view->getRenderViewProxy()->GetRenderer();
  auto* window = vtkRenderWindow::SafeDownCast(renderer->GetVTKWindow());
  this->Width = window->GetSize()[0];
  this->Height = window->GetSize()[1];
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->GetDirectionOfProjection(this->Ahead.data());
  const double* matrix =
    camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), 0.0, 1.0)
      ->GetData();
  std::copy_n(matrix, this->Matrix.size(), this->Matrix.begin());
  this->Depths.resize(static_cast<std::size_t>(this->Width) * this->Height);
  window->GetZbufferData(0, 0, this->Width - 1, this->Height - 1, this->Depths.data());
  for (int y = 0; y < this->Height; ++y)
  {
    spreadLargest(this->Depths.data() + std::ptrdiff_t{ y } * this->Width, this->Width, 1);
  }
  for (int x = 0; x < this->Width; ++x)
  {
    spreadLargest(this->Depths.data() + x, this->Height, this->Width);
  }
}

std::optional<Position> ViewSnapshot::project(const Position& point) const
{
  std::array<double, 4> clip{};
  for (int row = 0; row < 4; ++row)
  {
    const double* m = this->Matrix.data() + 4 * row;
    clip[row] = m[0] * point[0] + m[1] * point[1] + m[2] * point[2] + m[3];
  }
  if (clip[3] <= 0.0)
  {
    return {};
  }
  return Position{ 0.5 * (clip[0] / clip[3] + 1.0), 0.5 * (clip[1] / clip[3] + 1.0),
    clip[2] / clip[3] };
}

std::optional<QPointF> ViewSnapshot::placeOf(const Position& point, double tolerance) const
{
  const auto seen = this->project(point);
  const auto nearer = this->project(point - tolerance * this->Ahead);
  if (!seen || !nearer)
  {
    return {};
  }
  const double x = (*seen)[0] * this->Width;
  const double y = (*seen)[1] * this->Height;
  if (!(x >= 0.0 && x < this->Width && y >= 0.0 && y < this->Height))
  {
    return {};
  }
  const std::size_t pixel = static_cast<std::size_t>(y) * this->Width + static_cast<std::size_t>(x);
  if (this->Depths[pixel] < (*nearer)[2])
  {
    return {};
  }
  return QPointF(x / this->PixelsPerPoint, (this->Height - y) / this->PixelsPerPoint);
}

}
