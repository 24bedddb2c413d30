// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_PathSketch_h
#define seeds_PathSketch_h

#include "ViewSnapshot.h"

#include "vtkSmartPointer.h"

#include <QPointer>

#include <optional>

class pqRenderView;
class vtkActor;
class vtkSMProxy;

namespace seeds
{

class SeedOverlay;

/**
 * Draws the lines of a filter's output over a view, in the place of their actor, so that the scene
 * need not be drawn again while they change. Without a graphics card that takes a tenth of a second
 * and more for large surfaces.
 *
 * It can do so where the filter runs in this process, its lines are shown in this view alone and in
 * one plain colour, and no other filter uses them.
 */
class PathSketch
{
public:
  explicit PathSketch(vtkSMProxy* filter);
  ~PathSketch();

  /**
   * Takes the lines out of the scene, which is drawn once more; false if they can't be sketched.
   * @param tolerance  how far a point can be behind a drawn surface and still count as visible
   */
  bool begin(pqRenderView* view, SeedOverlay* overlay, double tolerance);
  bool isOn() const { return this->Snapshot.has_value(); }
  /** Runs the filter and draws its lines. */
  void update();
  /** Gives the lines back to the scene, which is not drawn yet. */
  void end();

private:
  /** What draws the lines in a view; null if they can't be sketched there. */
  vtkActor* actorIn(pqRenderView* view) const;

  vtkSmartPointer<vtkSMProxy> Filter;
  QPointer<SeedOverlay> Overlay;
  vtkSmartPointer<vtkActor> Actor;
  std::optional<ViewSnapshot> Snapshot;
  double Tolerance = 0.0;
};

}

#endif
