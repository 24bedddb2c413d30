// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_LiveUpdate_h
#define seeds_LiveUpdate_h

#include "Sketch.h"

#include "vtkSmartPointer.h"

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <QVector>

#include <memory>
#include <vector>

class pqRenderView;
class vtkSMDoubleVectorProperty;
class vtkSMProperty;
class vtkSMProxy;

namespace seeds
{

class SeedOverlay;

/**
 * Gives a filter the points while they are dragged, and draws its results, as often as the filter
 * can keep up and always for the last points. Where one of the sketches can show the results, they
 * are sketched until the drag ends. The whole drag is one step to undo.
 *
 * Users turn it on and off by a setting, which is kept among ParaView's settings. Before they do,
 * it is on where the filter is fast.
 */
class LiveUpdate : public QObject
{
  Q_OBJECT

public:
  /** @param dragged  a property that tells the filter whether a drag is under way; may be null */
  LiveUpdate(vtkSMProxy* filter, vtkSMDoubleVectorProperty* property, vtkSMProperty* dragged);

  /** Below this a run counts as fast, in seconds. */
  static constexpr double FastRun = 0.05;

  /** What the user has chosen; without a choice, whether the last run was fast. */
  static bool isWanted(double runTime);
  static void setWanted(bool isWanted);

  /** Whether the filter can be updated without Apply, because it has been applied before. */
  bool isPossible() const;

  /**
   * @param view       where the points are dragged
   * @param tolerance  see Sketch::begin
   */
  void begin(pqRenderView* view, SeedOverlay* overlay, double tolerance);
  void push(const QVector<double>& values);
  void finish();
  /** Ends a drag whose view is no longer there; what it has changed stays. */
  void abandon();

private:
  void update();
  void beginSketch();
  void endSketch();
  void draw();
  void give(const QVector<double>& values, bool isDragged);
  /** Gives the filter the points of a drag that is over. */
  void giveLast();

  vtkSmartPointer<vtkSMProxy> Filter;
  vtkSmartPointer<vtkSMDoubleVectorProperty> Property;
  vtkSmartPointer<vtkSMProperty> Dragged;
  QTimer WhenIdle;
  std::vector<std::unique_ptr<Sketch>> Sketches;
  /** That of them which shows the drag; null if the view does. */
  Sketch* Current = nullptr;
  QPointer<pqRenderView> View;
  QPointer<SeedOverlay> Overlay;
  double Tolerance = 0.0;
  QVector<double> Before;
  QVector<double> Latest;
  /** Whether the filter was given points since the drag began. */
  bool IsGiven = false;
};

}

#endif
