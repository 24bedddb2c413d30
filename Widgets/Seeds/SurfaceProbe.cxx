// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceProbe.h"

#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqUndoStack.h"
#include "vtkMatrix4x4.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <QCoreApplication>

namespace seeds
{
namespace
{

QString tr(const char* text)
{
  return QCoreApplication::translate("SurfaceProbe", text);
}

Ray transformedRay(vtkMatrix4x4* matrix, const Ray& ray)
{
  const Position origin = transformed(matrix, ray.origin);
  return { origin, transformed(matrix, ray.origin + ray.direction) - origin };
}

}

SurfaceProbe::SurfaceProbe(vtkSMProxy* filter, const ShownSurface& surface)
  : Surface(surface)
{
  SCOPED_UNDO_EXCLUDE();
  this->Picker.TakeReference(
    filter->GetSessionProxyManager()->NewProxy("misc", "SurfacePointPicker"));
  this->Picker->PrototypeOn();
}

Probed SurfaceProbe::at(pqRenderView* view, const QPointF& place, Snap snap, Care care)
{
  if (!this->Surface.inputPort())
  {
    return { {}, tr("There is no input") };
  }
  if (!this->Surface.representationIn(view))
  {
    return { {}, tr("The surface is hidden in this view") };
  }
  const Ray ray = ViewGeometry(view).rayThrough(place);
  const auto placement = this->Surface.placementIn(view);
  vtkNew<vtkMatrix4x4> toData;
  vtkMatrix4x4::Invert(placement, toData);
  const Ray rayInData = transformedRay(toData, ray);
  const auto met = this->ask(rayInData, Snap::ToSurface);
  if (!met)
  {
    return { {}, tr("The surface is not here"), true };
  }
  if (this->isCovered(view, place, transformed(placement, *met), care))
  {
    return { {}, tr("Another surface is in front") };
  }
  return { snap == Snap::ToMeshPoint ? this->ask(rayInData, snap) : met, {} };
}

std::optional<QPointF> SurfaceProbe::placeOf(pqRenderView* view, const Position& point) const
{
  return ViewGeometry(view).toWidget(transformed(this->Surface.placementIn(view), point));
}

std::optional<Position> SurfaceProbe::ask(const Ray& ray, Snap snap)
{
  SCOPED_UNDO_EXCLUDE();
  pqOutputPort* input = this->Surface.inputPort();
  vtkSMPropertyHelper(this->Picker, "Input")
    .Set(input->getSource()->getProxy(), static_cast<unsigned int>(input->getPortNumber()));
  vtkSMPropertyHelper(this->Picker, "Origin").Set(ray.origin.data(), 3);
  vtkSMPropertyHelper(this->Picker, "Direction").Set(ray.direction.data(), 3);
  vtkSMPropertyHelper(this->Picker, "SnapToPoint").Set(snap == Snap::ToMeshPoint ? 1 : 0);
  this->Picker->UpdateVTKObjects();
  this->Picker->InvokeCommand("Pick");
  this->Picker->UpdatePropertyInformation(this->Picker->GetProperty("Answer"));
  std::array<double, 4> answer{};
  vtkSMPropertyHelper(this->Picker, "Answer").Get(answer.data(), 4);
  if (answer[0] == 0.0)
  {
    return {};
  }
  return Position{ answer[1], answer[2], answer[3] };
}

bool SurfaceProbe::isCovered(
  pqRenderView* view, const QPointF& place, const Position& point, Care care) const
{
  const ViewGeometry geometry(view);
  if (geometry.isDrawnHere())
  {
    return geometry.isCovered(point, this->Surface.thickness());
  }
  if (care == Care::Preview)
  {
    return false;
  }
  const auto [x, y] = geometry.pixelAt(place);
  vtkSMRepresentationProxy* drawn = view->getRenderViewProxy()->Pick(x, y);
  return drawn && !this->Surface.isShownBy(drawn);
}

}
