// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathSketch.h"

#include "SeedOverlay.h"
#include "ShownSurface.h"
#include "ViewGeometry.h"

#include "pqRenderView.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

#include <QPainterPath>

namespace seeds
{

PathSketch::PathSketch(vtkSMProxy* filter)
  : Filter(filter)
{
}

PathSketch::~PathSketch()
{
  this->end();
}

bool PathSketch::begin(pqRenderView* view, SeedOverlay* overlay, double tolerance)
{
  vtkPolyData* lines = outputOf(this->Filter);
  vtkActor* actor = lines && lines->GetNumberOfPolys() == 0 && ViewGeometry(view).isDrawnHere()
    ? soleActorIn(view, this->Filter)
    : nullptr;
  if (!actor || actor->GetProperty()->GetLighting() || actor->GetMapper()->GetScalarVisibility())
  {
    return false;
  }
  this->View = view;
  this->Overlay = overlay;
  this->Tolerance = tolerance;
  this->Actor = actor;
  this->Actor->SetVisibility(false);
  view->forceRender();
  this->Snapshot.emplace(view);
  this->CameraTime = cameraTimeOf(view);
  return true;
}

bool PathSketch::update()
{
  if (!this->View || cameraTimeOf(this->View) != this->CameraTime)
  {
    return false;
  }
  vtkSMSourceProxy::SafeDownCast(this->Filter)->UpdatePipeline();
  vtkPolyData* lines = outputOf(this->Filter);
  vtkMatrix4x4* placement = this->Actor->GetMatrix();
  QPainterPath path;
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  vtkCellArray* cells = lines->GetLines();
  for (cells->InitTraversal(); cells->GetNextCell(count, ids);)
  {
    bool isSeen = false;
    for (vtkIdType i = 0; i < count; ++i)
    {
      Position point;
      lines->GetPoint(ids[i], point.data());
      const auto place = this->Snapshot->placeOf(transformed(placement, point), this->Tolerance);
      if (place && isSeen)
      {
        path.lineTo(*place);
      }
      else if (place)
      {
        path.moveTo(*place);
      }
      isSeen = place.has_value();
    }
  }
  if (this->Overlay)
  {
    double rgb[3];
    this->Actor->GetProperty()->GetColor(rgb);
    this->Overlay->setSketch(
      path, QColor::fromRgbF(rgb[0], rgb[1], rgb[2]), this->Actor->GetProperty()->GetLineWidth());
  }
  return true;
}

void PathSketch::end()
{
  if (!this->Snapshot)
  {
    return;
  }
  this->Snapshot.reset();
  this->Actor->SetVisibility(true);
  this->Actor = nullptr;
  if (this->Overlay)
  {
    this->Overlay->setSketch({}, {}, 0.0);
  }
}

}
