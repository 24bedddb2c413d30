// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceLinesActor.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSurfaceLinesActor);

namespace
{

/** How much of the world a pixel covers: of the distance to the eye, or in parallel projection as a
 * length. */
double pixelSize(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const int* size = renderer->GetSize();
  const double height = std::max(size[1], 1);
  if (camera->GetParallelProjection())
  {
    return 2.0 * camera->GetParallelScale() / height;
  }
  const double extent = camera->GetUseHorizontalViewAngle() ? std::max(size[0], 1) : height;
  return 2.0 * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())) / extent;
}

/** Moves everything towards the eye by so many pixels, each point on its own ray. */
void lead(vtkRenderer* renderer, double pixels, vtkTransform* transform)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double amount = pixels * pixelSize(renderer);
  if (camera->GetParallelProjection())
  {
    double ahead[3];
    camera->GetDirectionOfProjection(ahead);
    transform->Translate(-amount * ahead[0], -amount * ahead[1], -amount * ahead[2]);
    return;
  }
  double eye[3];
  camera->GetPosition(eye);
  const double scale = 1.0 - std::min(amount, 0.5);
  transform->Translate(eye);
  transform->Scale(scale, scale, scale);
  transform->Translate(-eye[0], -eye[1], -eye[2]);
}

}

void vtkSurfaceLinesActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  this->Renderer = renderer;
  this->GetProperty()->SetLighting(this->IsLit);
  // The device draws as if it had no matrix before it has computed one, and keeps that until it is
  // modified.
  this->GetMatrix(this->Device->GetUserMatrix());
  this->Device->Modified();
  this->Device->ComputeMatrix();
  this->Superclass::Render(renderer, mapper);
  this->Renderer = nullptr;
}

void vtkSurfaceLinesActor::GetMatrix(vtkMatrix4x4* result)
{
  this->Superclass::GetMatrix(result);
  if (this->Renderer)
  {
    vtkNew<vtkTransform> leading;
    lead(this->Renderer, LeadPerPixel * this->GetProperty()->GetLineWidth() + Lead, leading);
    vtkMatrix4x4::Multiply4x4(leading->GetMatrix(), result, result);
  }
}
