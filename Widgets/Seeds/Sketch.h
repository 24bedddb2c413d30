// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_Sketch_h
#define seeds_Sketch_h

#include "vtkType.h"

class pqRenderView;
class vtkActor;
class vtkPolyData;
class vtkSMProxy;

namespace seeds
{

class SeedOverlay;

/**
 * Draws a filter's results over a view while they change and the camera stands still, so that the
 * scene need not be drawn again. Without a graphics card that takes a tenth of a second and more
 * for large surfaces.
 */
class Sketch
{
public:
  virtual ~Sketch() = default;

  /**
   * Draws the scene as the sketch needs it; false if this view can't be sketched.
   * @param tolerance  how far a point can be behind a drawn surface and still count as visible
   */
  virtual bool begin(pqRenderView* view, SeedOverlay* overlay, double tolerance) = 0;
  /** Runs the filter and sketches its results; false if they or the view are no longer such. */
  virtual bool update() = 0;
  /** Leaves all to the scene again, which is not drawn yet. Does nothing before begin. */
  virtual void end() = 0;
};

/** What a filter that runs in this process has made; null if it does not, or if that is no
 * polygonal data. */
vtkPolyData* outputOf(vtkSMProxy* filter);

/**
 * What draws a filter's output in a view; null if it is not shown there alone, or if another filter
 * uses it.
 */
vtkActor* soleActorIn(pqRenderView* view, vtkSMProxy* filter);

/** When a view's camera was moved last. */
vtkMTimeType cameraTimeOf(pqRenderView* view);

}

#endif
