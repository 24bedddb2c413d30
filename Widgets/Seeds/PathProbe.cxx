// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathProbe.h"

#include "ViewGeometry.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "vtkMatrix4x4.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <array>

namespace seeds
{
namespace
{

/** In Qt's pixels. */
constexpr double Reach = 7.0;

}

PathProbe::PathProbe(vtkSMProxy* filter, const ShownSurface& surface, const QByteArray& segments)
  : Filter(filter)
  , Surface(surface)
  , Segments(segments)
{
  if (segments.isEmpty())
  {
    return;
  }
  SCOPED_UNDO_EXCLUDE();
  this->Finder.TakeReference(filter->GetSessionProxyManager()->NewProxy("misc", "NearestOnLines"));
  this->Finder->PrototypeOn();
  vtkSMPropertyHelper(this->Finder, "ArrayName").Set(segments.constData());
}

void PathProbe::setCounts(int waypoints, int segments)
{
  // A closed path has one segment more. Any other number is of other points.
  this->JoinsWaypoints = waypoints > 1 && (segments == waypoints - 1 || segments == waypoints);
}

bool PathProbe::isShownIn(pqRenderView* view) const
{
  auto* source =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
      this->Filter.Get());
  if (!source || source->modifiedState() != pqProxy::UNMODIFIED)
  {
    return false;
  }
  const pqDataRepresentation* path = source->getOutputPort(0)->getRepresentation(view);
  return path && path->isVisible();
}

std::optional<PathPlace> PathProbe::at(
  pqRenderView* view, const QPointF& place, const Position& onSurface) const
{
  if (!this->Finder || !this->JoinsWaypoints || !this->isShownIn(view))
  {
    return {};
  }
  SCOPED_UNDO_EXCLUDE();
  vtkSMPropertyHelper(this->Finder, "Input").Set(this->Filter.Get());
  vtkSMPropertyHelper(this->Finder, "Position").Set(onSurface.data(), 3);
  this->Finder->UpdateVTKObjects();
  this->Finder->InvokeCommand("Find");
  this->Finder->UpdatePropertyInformation(this->Finder->GetProperty("Answer"));
  std::array<double, 4> answer{};
  vtkSMPropertyHelper(this->Finder, "Answer").Get(answer.data(), 4);
  if (answer[0] < 0.0)
  {
    return {};
  }
  const Position point{ answer[1], answer[2], answer[3] };
  const auto drawn =
    ViewGeometry(view).toWidget(transformed(this->Surface.placementIn(view), point));
  const QPointF away = drawn ? *drawn - place : QPointF();
  if (!drawn || QPointF::dotProduct(away, away) > Reach * Reach)
  {
    return {};
  }
  return PathPlace{ static_cast<int>(answer[0]) + 1, point };
}

}
