// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathSketch.h"

#include "SeedOverlay.h"
#include "ShownSurface.h"
#include "ViewGeometry.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCompositeRepresentation.h"
#include "vtkGeometryRepresentation.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPVLODActor.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

#include <QPainterPath>

namespace seeds
{
namespace
{

/** The lines of a filter that runs in this process; null if it does not, or makes others. */
vtkPolyData* linesOf(vtkSMProxy* filter)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(filter->GetClientSideObject());
  return algorithm ? vtkPolyData::SafeDownCast(algorithm->GetOutputDataObject(0)) : nullptr;
}

}

PathSketch::PathSketch(vtkSMProxy* filter)
  : Filter(filter)
{
}

PathSketch::~PathSketch()
{
  this->end();
}

vtkActor* PathSketch::actorIn(pqRenderView* view) const
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  auto* source = model->findItem<pqPipelineSource*>(this->Filter.Get());
  pqOutputPort* port = source ? source->getOutputPort(0) : nullptr;
  if (!port || port->getNumberOfConsumers() > 0)
  {
    return nullptr;
  }
  for (pqView* other : model->findItems<pqView*>())
  {
    const pqDataRepresentation* shown = port->getRepresentation(other);
    if (other != view && shown && shown->isVisible())
    {
      return nullptr;
    }
  }
  const pqDataRepresentation* shown = port->getRepresentation(view);
  auto* choice = shown && shown->isVisible()
    ? vtkCompositeRepresentation::SafeDownCast(shown->getProxy()->GetClientSideObject())
    : nullptr;
  auto* geometry =
    choice ? vtkGeometryRepresentation::SafeDownCast(choice->GetActiveRepresentation()) : nullptr;
  vtkActor* actor = geometry ? geometry->GetActor() : nullptr;
  const bool isPlain =
    actor && !actor->GetProperty()->GetLighting() && !actor->GetMapper()->GetScalarVisibility();
  return isPlain ? actor : nullptr;
}

bool PathSketch::begin(pqRenderView* view, SeedOverlay* overlay, double tolerance)
{
  vtkPolyData* lines = linesOf(this->Filter);
  vtkActor* actor = lines && lines->GetNumberOfPolys() == 0 && ViewGeometry(view).isDrawnHere()
    ? this->actorIn(view)
    : nullptr;
  if (!actor)
  {
    return false;
  }
  this->Overlay = overlay;
  this->Tolerance = tolerance;
  this->Actor = actor;
  this->Actor->SetVisibility(false);
  view->forceRender();
  this->Snapshot.emplace(view);
  return true;
}

void PathSketch::update()
{
  vtkSMSourceProxy::SafeDownCast(this->Filter)->UpdatePipeline();
  vtkPolyData* lines = linesOf(this->Filter);
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
}

void PathSketch::end()
{
  if (!this->isOn())
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
