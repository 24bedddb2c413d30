// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_ViewNumbers_h
#define seeds_ViewNumbers_h

#include "ResultNumbers.h"

#include "vtkSmartPointer.h"

#include <QByteArray>
#include <QObject>
#include <QPointF>
#include <QPointer>

#include <optional>

class pqRenderView;
class vtkSMProxy;

namespace seeds
{

class SeedMenu;
class SeedOverlay;
class ShownSurface;
class SurfaceProbe;

/**
 * Writes numbers of a filter's last run in a view, as far as the panel's menu asks for them: the
 * length of each segment at its middle, and the distance under the pointer.
 */
class ViewNumbers : public QObject
{
  Q_OBJECT

public:
  /**
   * @param distances  the filter's property that names its array of distances; empty if it makes
   * none
   */
  ViewNumbers(vtkSMProxy* filter, const QByteArray& distances, const ShownSurface& surface,
    SurfaceProbe& probe, const SeedMenu* menu);

  /** Writes by an overlay of a view from now on. */
  void setView(pqRenderView* view, SeedOverlay* overlay);
  /** Tells what the last run has measured; an empty result takes the lengths away. */
  void setResult(const ResultNumbers& result);
  /** Tells where the pointer is in the view; none if it is not there, or does something else. */
  void setPointer(const std::optional<QPointF>& place);

public Q_SLOTS:
  void writeLengths();
  void writeDistance();

private:
  vtkSmartPointer<vtkSMProxy> Filter;
  QByteArray Distances;
  const ShownSurface& Surface;
  SurfaceProbe& Probe;
  const SeedMenu* Menu;
  QPointer<pqRenderView> View;
  QPointer<SeedOverlay> Overlay;
  ResultNumbers Result;
  std::optional<QPointF> Pointer;
};

}

#endif
