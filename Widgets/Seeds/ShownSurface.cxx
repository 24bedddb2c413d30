// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShownSurface.h"

#include "ParaViewVersions.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

namespace seeds
{
namespace
{

pqPipelineSource* sourceOf(vtkSMProxy* proxy)
{
  return pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(proxy);
}

pqDataRepresentation* visibleIn(pqOutputPort* port, pqRenderView* view)
{
  pqDataRepresentation* representation = port ? port->getRepresentation(view) : nullptr;
  return representation && representation->isVisible() ? representation : nullptr;
}

vtkBoundingBox boundsOf(pqOutputPort* port)
{
  vtkBoundingBox box;
  if (port)
  {
    box.SetBounds(port->getDataInformation()->GetBounds());
  }
  return box;
}

}

ShownSurface::ShownSurface(vtkSMProxy* filter, vtkSMProperty* input)
  : Filter(filter)
  , Input(input)
{
}

pqOutputPort* ShownSurface::inputPort() const
{
  vtkSMPropertyHelper helper(this->Input);
  pqPipelineSource* source =
    helper.GetNumberOfElements() > 0 ? sourceOf(helper.GetAsProxy()) : nullptr;
  return source ? source->getOutputPort(static_cast<int>(helper.GetOutputPort())) : nullptr;
}

pqDataRepresentation* ShownSurface::representationIn(pqRenderView* view) const
{
  if (pqDataRepresentation* ofInput = visibleIn(this->inputPort(), view))
  {
    return ofInput;
  }
  pqPipelineSource* filter = sourceOf(this->Filter);
  for (int port = 0; filter && port < filter->getNumberOfOutputPorts(); ++port)
  {
    if (pqDataRepresentation* ofOutput = visibleIn(filter->getOutputPort(port), view))
    {
      return ofOutput;
    }
  }
  return nullptr;
}

bool ShownSurface::isShownBy(vtkSMProxy* representation) const
{
  vtkSMProxy* shown = vtkSMPropertyHelper(representation, "Input", true).GetAsProxy();
  return shown == this->Filter || shown == vtkSMPropertyHelper(this->Input).GetAsProxy();
}

vtkSmartPointer<vtkMatrix4x4> ShownSurface::placementIn(pqRenderView* view) const
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  if (pqDataRepresentation* representation = this->representationIn(view))
  {
    vtkSMProxy* proxy = representation->getProxy();
    Position translation{ 0.0, 0.0, 0.0 };
    Position angles{ 0.0, 0.0, 0.0 };
    Position scale{ 1.0, 1.0, 1.0 };
    Position origin{ 0.0, 0.0, 0.0 };
    vtkSMPropertyHelper(proxy, translationOf(proxy), true).Get(translation.data(), 3);
    vtkSMPropertyHelper(proxy, "Orientation", true).Get(angles.data(), 3);
    vtkSMPropertyHelper(proxy, "Scale", true).Get(scale.data(), 3);
    vtkSMPropertyHelper(proxy, "Origin", true).Get(origin.data(), 3);
    vtkNew<vtkActor> actor;
    actor->SetPosition(translation.data());
    actor->SetOrientation(angles.data());
    actor->SetScale(scale.data());
    actor->SetOrigin(origin.data());
    actor->GetMatrix(matrix);
  }
  return matrix;
}

double ShownSurface::thickness() const
{
  const vtkBoundingBox box = boundsOf(this->inputPort());
  return box.IsValid() ? 2e-3 * box.GetDiagonalLength() : 0.0;
}

Position ShownSurface::center() const
{
  Position center{ 0.0, 0.0, 0.0 };
  const vtkBoundingBox box = boundsOf(this->inputPort());
  if (box.IsValid())
  {
    box.GetCenter(center.data());
  }
  return center;
}

Position transformed(vtkMatrix4x4* matrix, const Position& point)
{
  const double from[4] = { point[0], point[1], point[2], 1.0 };
  double to[4];
  matrix->MultiplyPoint(from, to);
  return { to[0] / to[3], to[1] / to[3], to[2] / to[3] };
}

}
