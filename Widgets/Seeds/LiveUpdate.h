// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_LiveUpdate_h
#define seeds_LiveUpdate_h

#include "vtkSmartPointer.h"

#include <QObject>
#include <QTimer>
#include <QVector>

class vtkSMDoubleVectorProperty;
class vtkSMProxy;

namespace seeds
{

/**
 * Gives a filter the points while they are dragged, and draws its results, as often as the filter
 * can keep up and always for the last points. The whole drag is one step to undo.
 *
 * Users turn it on and off by a setting, which is kept among ParaView's settings. Before they do,
 * it is on where the filter is fast.
 */
class LiveUpdate : public QObject
{
  Q_OBJECT

public:
  LiveUpdate(vtkSMProxy* filter, vtkSMDoubleVectorProperty* property);

  /** Below this a run counts as fast, in seconds. */
  static constexpr double FastRun = 0.05;

  /** What the user has chosen; without a choice, whether the last run was fast. */
  static bool isWanted(double runTime);
  static void setWanted(bool isWanted);

  /** Whether the filter can be updated without Apply, because it has been applied before. */
  bool isPossible() const;

  void begin();
  void push(const QVector<double>& values);
  void finish();

private:
  void update();
  void give(const QVector<double>& values);

  vtkSmartPointer<vtkSMProxy> Filter;
  vtkSmartPointer<vtkSMDoubleVectorProperty> Property;
  QTimer WhenIdle;
  QVector<double> Before;
  QVector<double> Latest;
};

}

#endif
