// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewNumbers.h"

#include "SeedMenu.h"
#include "SeedOverlay.h"
#include "ShownSurface.h"
#include "SurfaceProbe.h"

#include "pqRenderView.h"
#include "vtkMatrix4x4.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <cmath>

namespace seeds
{

ViewNumbers::ViewNumbers(vtkSMProxy* filter, const QByteArray& distances,
  const ShownSurface& surface, SurfaceProbe& probe, const SeedMenu* menu)
  : Filter(filter)
  , Distances(distances)
  , Surface(surface)
  , Probe(probe)
  , Menu(menu)
{
  this->connect(menu, &SeedMenu::lengthsToggled, this, &ViewNumbers::writeLengths);
  this->connect(menu, &SeedMenu::distanceAtPointerToggled, this, &ViewNumbers::writeDistance);
}

void ViewNumbers::setView(pqRenderView* view, SeedOverlay* overlay)
{
  this->View = view;
  this->Overlay = overlay;
}

void ViewNumbers::setResult(const ResultNumbers& result)
{
  this->Result = result;
  this->writeLengths();
}

void ViewNumbers::setPointer(const std::optional<QPointF>& place)
{
  this->Pointer = place;
  this->writeDistance();
}

void ViewNumbers::writeLengths()
{
  if (!this->Overlay || !this->View)
  {
    return;
  }
  QVector<Position> points;
  QStringList texts;
  if (this->Menu->hasLengths() && this->Result.middles.size() == this->Result.lengths.size())
  {
    const auto placement = this->Surface.placementIn(this->View);
    for (int i = 0; i < this->Result.lengths.size(); ++i)
    {
      if (this->Result.lengths[i] >= 0.0)
      {
        points.append(transformed(placement, this->Result.middles[i]));
        texts.append(lengthText(this->Result.lengths[i]));
      }
    }
  }
  this->Overlay->setLabels(points, texts);
}

void ViewNumbers::writeDistance()
{
  if (!this->Overlay || !this->View)
  {
    return;
  }
  std::optional<double> distance;
  if (this->Pointer && this->Menu->hasDistanceAtPointer())
  {
    const QByteArray array =
      vtkSMPropertyHelper(this->Filter, this->Distances.constData()).GetAsString();
    distance =
      array.isEmpty() ? std::nullopt : this->Probe.valueAt(this->View, *this->Pointer, array);
  }
  const QString text = !distance ? QString()
    : std::isnan(*distance)      ? tr("no distance")
                                 : lengthText(*distance);
  this->Overlay->setNote(text, this->Pointer.value_or(QPointF()));
}

}
