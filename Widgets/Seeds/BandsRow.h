// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_BandsRow_h
#define seeds_BandsRow_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

class QCheckBox;
class pqDataRepresentation;
class pqDoubleLineEdit;
class pqView;
class vtkEventQtSlotConnect;
class vtkSMProxy;

namespace seeds
{

/**
 * A check box and a width: whether a filter's distances are coloured in bands. It sets the colour
 * map of the array (ColorBands.h) and nothing of the filter, and keeps the width of the bands where
 * the largest distance or the range of the map changes.
 */
class BandsRow : public QWidget
{
  Q_OBJECT

public:
  /** @param arrayName  the filter's property that names the array of distances */
  BandsRow(vtkSMProxy* filter, const char* arrayName, QWidget* parent);
  ~BandsRow() override;

  void setView(pqView* view);
  /** Tells the largest distance of the last run; 0 where there is none. */
  void showLargest(double largest);

Q_SIGNALS:
  /** A width was refused, for the given reason. */
  void refused(const QString& reason);

protected:
  void showEvent(QShowEvent* event) override;

private:
  QByteArray arrayName() const;
  /** What shows the filter's output in the view, coloured by the array; null if nothing does. */
  pqDataRepresentation* shown() const;
  /** Has the legend name the bands, if the view has one. */
  void labelLegend(vtkSMProxy* map) const;
  /** The colour map of the array; null before the array is there. */
  vtkSMProxy* findMap() const;
  void toggle(bool isOn);
  void takeSpacing();
  void refuse(double spacing);
  /** Has the bands set again when something else changes the colour map. */
  void watch(vtkSMProxy* map);
  /** Shows the bands that the colour map has. */
  void readMap();
  /** Gives the colour map the bands that are shown. */
  void writeMap();
  void showSpacing(double spacing);

  vtkSmartPointer<vtkSMProxy> Filter;
  QByteArray NameProperty;
  QPointer<pqView> View;
  QCheckBox* Box = nullptr;
  pqDoubleLineEdit* Edit = nullptr;
  double Spacing = 0.0;
  double Largest = 0.0;
  vtkNew<vtkEventQtSlotConnect> MapEvents;
  /** ParaView sets the range of the map after a run; the bands are set after that. */
  QTimer WhenIdle;
};

}

#endif
