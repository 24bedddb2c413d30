// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_TracedContour_h
#define geodesic_testing_TracedContour_h

#include "vtkContourWidget.h"
#include "vtkNew.h"
#include "vtkOrientedGlyphContourRepresentation.h"
#include "vtkPolyData.h"
#include "vtkPolygonalSurfaceContourLineInterpolator2.h"
#include "vtkPolygonalSurfacePointPlacer.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <string>
#include <utility>
#include <vector>

namespace geodesic::testing
{

/** Notes which lines it is asked for. */
class NotingInterpolator : public vtkPolygonalSurfaceContourLineInterpolator2
{
public:
  static NotingInterpolator* New();
  vtkTypeMacro(NotingInterpolator, vtkPolygonalSurfaceContourLineInterpolator2);
  int InterpolateLine(vtkRenderer* ren, vtkContourRepresentation* rep, int idx1, int idx2) override;

  using Line = std::pair<int, int>;
  /** The lines since the last call, with the result of each. */
  std::vector<Line> takeLines() { return std::exchange(this->Lines, {}); }
  int lastResult() const { return this->LastResult; }

private:
  std::vector<Line> Lines;
  int LastResult = -1;
};

/** A contour widget on surfaces, in a window of 400 x 400 that shows [-2, 23]^2 of the xy plane. */
class TracedContour
{
public:
  TracedContour();

  /** Shows a surface and lets contours be drawn on it. */
  void addSurface(vtkPolyData* surface);

  /** A node as if the placer had picked a point, given by its id. */
  void addNode(vtkPolyData* surface, vtkIdType id);
  /** The same for an existing node. */
  void moveNode(int node, vtkPolyData* surface, vtkIdType id);
  void clear();

  /** Ids of the points of the line that begins at a node. */
  std::vector<vtkIdType> lineIds(int node) const;
  /** Length of the line that begins at a node. */
  double lineLength(int node) const;
  std::vector<vtkIdType> contourIds() const;

  /** Sends the interactor events: names and positions in the plane, played as a recording. */
  struct Event
  {
    std::string name;
    double x = 0.0;
    double y = 0.0;
    std::string key = "0";
  };
  void play(const std::vector<Event>& events);

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkPolygonalSurfacePointPlacer> Placer;
  vtkNew<NotingInterpolator> Interpolator;
  vtkNew<vtkOrientedGlyphContourRepresentation> Contour;
  vtkNew<vtkContourWidget> Widget;

private:
  void tellPlacer(vtkPolyData* surface, vtkIdType id, double position[3]);
};

/** A press and a release of the left button. */
std::vector<TracedContour::Event> click(double x, double y);
std::vector<TracedContour::Event> drag(double fromX, double fromY, double toX, double toY);
std::vector<TracedContour::Event> pressKey(const std::string& key, double x, double y);

/** Has an interactor play events in the format of vtkInteractorEventRecorder. */
void playRecording(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer,
  const std::vector<TracedContour::Event>& events);
/** A camera that shows [-2, 23]^2 of the xy plane. */
void lookAtPlane(vtkRenderer* renderer);

}

#endif
