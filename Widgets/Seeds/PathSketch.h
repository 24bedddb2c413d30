// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_PathSketch_h
#define seeds_PathSketch_h

#include "Sketch.h"
#include "ViewSnapshot.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <QPointer>

#include <optional>

namespace seeds
{

/**
 * Draws the lines of a filter's output over a view, in the place of their actor.
 *
 * It can do so where the filter runs in this process, its lines are shown in this view alone and in
 * one plain colour, and no other filter uses them.
 */
class PathSketch : public Sketch
{
public:
  explicit PathSketch(vtkSMProxy* filter);
  ~PathSketch() override;

  bool begin(pqRenderView* view, SeedOverlay* overlay, double tolerance) override;
  bool update() override;
  void end() override;

private:
  vtkSmartPointer<vtkSMProxy> Filter;
  QPointer<pqRenderView> View;
  QPointer<SeedOverlay> Overlay;
  vtkSmartPointer<vtkActor> Actor;
  std::optional<ViewSnapshot> Snapshot;
  /** When the camera was moved last before the snapshot. */
  vtkMTimeType CameraTime = 0;
  double Tolerance = 0.0;
};

}

#endif
