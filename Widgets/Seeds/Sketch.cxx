// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sketch.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkCompositeRepresentation.h"
#include "vtkGeometryRepresentation.h"
#include "vtkPVLODActor.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSMProxy.h"
#include "vtkSMRenderViewProxy.h"

namespace seeds
{

vtkPolyData* outputOf(vtkSMProxy* filter)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(filter->GetClientSideObject());
  return algorithm ? vtkPolyData::SafeDownCast(algorithm->GetOutputDataObject(0)) : nullptr;
}

vtkActor* soleActorIn(pqRenderView* view, vtkSMProxy* filter)
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  auto* source = model->findItem<pqPipelineSource*>(filter);
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
  return geometry ? geometry->GetActor() : nullptr;
}

vtkMTimeType cameraTimeOf(pqRenderView* view)
{
  return view->getRenderViewProxy()->GetRenderer()->GetActiveCamera()->GetMTime();
}

}
