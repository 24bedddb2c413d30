// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceSeedsWidget_h
#define SurfaceSeedsWidget_h

#include "pqPropertyGroupWidget.h"

#include <QList>
#include <QVariant>

#include <memory>

class pqRenderView;

/**
 * The panel widget of a property group of points on a surface. It shows the points in a table and
 * in the active render view, where they can be picked and dragged. In XML:
 *
 *   <PropertyGroup label="Seeds" panel_widget="SurfaceSeeds">
 *     <Property name="SeedPositions" function="Positions" />
 *     <Property name="Input" function="Input" />
 *     <Hints>
 *       <SurfaceSeeds role="seed" color="0.9 0.3 0.1" joined="0" />
 *     </Hints>
 *   </PropertyGroup>
 *
 * Positions is a repeatable DoubleVectorProperty of x y z, Input an InputProperty; the hints are in
 * SeedRole.h. The property holds the whole state. Information properties with the functions Result,
 * Lengths, Middles, Error and RunTime (ResultNumbers.h) are shown after each run. An internal
 * integer property with the function Dragged is 1 while a drag with live update is under way, so
 * that the filter may leave out what takes long.
 *
 * If several groups of one proxy share their Input, ParaView's panel puts the Input into the last
 * group that names it. So the group that should come first in the panel must be the last in the
 * XML.
 */
class SurfaceSeedsWidget : public pqPropertyGroupWidget
{
  Q_OBJECT
  Q_PROPERTY(QList<QVariant> positions READ positions WRITE setPositions NOTIFY positionsChanged)

public:
  SurfaceSeedsWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~SurfaceSeedsWidget() override;

  ///@{
  /** The values that are linked to the property. */
  QList<QVariant> positions() const;
  void setPositions(const QList<QVariant>& positions);
  ///@}

public Q_SLOTS:
  void setView(pqView* view) override;

Q_SIGNALS:
  void positionsChanged();

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  struct Internals;

  void connectPanel();
  void connectPicker();

  void setPicking(bool isOn);
  void attachTo(pqRenderView* view);
  void detach();
  void showPoints();
  void showLines();
  /** Follows whether the filter waits for Apply. */
  void followState();
  bool isModified() const;
  /** Shows what the filter's last run has measured. */
  void showResult();
  /** Shows the last run's error where its property is, or here. */
  void showError();
  /** Takes away what was measured for other points than those in the table. */
  void forgetLengths();

  /** Null if the group lacks a function; the widget then says so and does nothing else. */
  std::unique_ptr<Internals> Internal;
};

#endif
