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

/** Has a proxy SurfacePointPicker answer; none where the ray misses. */
std::optional<Position> pick(vtkSMProxy* picker, const Ray& ray)
{
  vtkSMPropertyHelper(picker, "Origin").Set(ray.origin.data(), 3);
  vtkSMPropertyHelper(picker, "Direction").Set(ray.direction.data(), 3);
  picker->UpdateVTKObjects();
  picker->InvokeCommand("Pick");
  picker->UpdatePropertyInformation(picker->GetProperty("Answer"));
  std::array<double, 4> answer{};
  vtkSMPropertyHelper(picker, "Answer").Get(answer.data(), 4);
  if (answer[0] == 0.0)
  {
    return {};
  }
  return Position{ answer[1], answer[2], answer[3] };
}

}

SurfaceProbe::SurfaceProbe(vtkSMProxy* filter, const ShownSurface& surface)
  : Surface(surface)
  , Filter(filter)
{
  SCOPED_UNDO_EXCLUDE();
  for (vtkSmartPointer<vtkSMProxy>* proxy : { &this->Picker, &this->Meter })
  {
    proxy->TakeReference(filter->GetSessionProxyManager()->NewProxy("misc", "SurfacePointPicker"));
    (*proxy)->PrototypeOn();
  }
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
  const Ray ray = this->rayThrough(view, place);
  const auto met = this->ask(ray, Snap::ToSurface);
  if (!met)
  {
    return { {}, tr("The surface is not here"), true };
  }
  if (this->isCovered(view, place, transformed(this->Surface.placementIn(view), *met), care))
  {
    return { {}, tr("Another surface is in front") };
  }
  return { snap == Snap::ToMeshPoint ? this->ask(ray, snap) : met, {} };
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
  vtkSMPropertyHelper(this->Picker, "SnapToPoint").Set(snap == Snap::ToMeshPoint ? 1 : 0);
  return pick(this->Picker, ray);
}

Ray SurfaceProbe::rayThrough(pqRenderView* view, const QPointF& place) const
{
  vtkNew<vtkMatrix4x4> toData;
  vtkMatrix4x4::Invert(this->Surface.placementIn(view), toData);
  return transformedRay(toData, ViewGeometry(view).rayThrough(place));
}

std::optional<double> SurfaceProbe::valueAt(
  pqRenderView* view, const QPointF& place, const QByteArray& arrayName)
{
  if (!this->Surface.inputPort() || !this->Surface.representationIn(view))
  {
    return {};
  }
  SCOPED_UNDO_EXCLUDE();
  vtkSMPropertyHelper(this->Meter, "Input").Set(this->Filter.Get());
  vtkSMPropertyHelper(this->Meter, "ArrayName").Set(arrayName.constData());
  const auto met = pick(this->Meter, this->rayThrough(view, place));
  if (!met ||
    this->isCovered(view, place, transformed(this->Surface.placementIn(view), *met), Care::Preview))
  {
    return {};
  }
  this->Meter->UpdatePropertyInformation(this->Meter->GetProperty("Value"));
  return vtkSMPropertyHelper(this->Meter, "Value").GetAsDouble();
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
