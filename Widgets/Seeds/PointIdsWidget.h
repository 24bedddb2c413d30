// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointIdsWidget_h
#define PointIdsWidget_h

#include "pqPropertyWidget.h"

class pqScalarValueListPropertyWidget;

/**
 * The panel widget of a repeatable IdTypeVectorProperty: a list of ids, as ParaView shows one of
 * integers. ParaView 5.11 has no widget for properties of this type, and those of integers end at
 * 2^31. In XML:
 *
 *   <IdTypeVectorProperty name="SeedPointIds" panel_widget="PointIds" ... />
 *
 * What is typed and is no integer becomes 0, and the list shows it.
 */
class PointIdsWidget : public pqPropertyWidget
{
  Q_OBJECT

public:
  PointIdsWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);

  void apply() override;

private:
  /** Shows as numbers what was typed as text. */
  void showAsNumbers();

  pqScalarValueListPropertyWidget* List;
};

#endif
