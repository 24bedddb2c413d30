// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RunErrorWidget_h
#define RunErrorWidget_h

#include "pqPropertyGroupWidget.h"

#include <QPointer>

namespace seeds
{
class ErrorNote;
}

/**
 * The panel widget of a filter without points to pick: the error of its last run, in red under the
 * property that it names, or here. Without an error there is nothing to be seen. In XML:
 *
 *   <PropertyGroup panel_widget="RunError">
 *     <Property name="Input" function="Input" />
 *     <Property name="ErrorText" function="Error" />
 *   </PropertyGroup>
 *
 * ErrorText is an information property. ParaView's panel leaves out groups of nothing else, so the
 * group needs Input, by which it comes first in the panel.
 */
class RunErrorWidget : public pqPropertyGroupWidget
{
  Q_OBJECT

public:
  RunErrorWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~RunErrorWidget() override;

private:
  void showError();

  /** Null if there is no error, or the property has changed. */
  QPointer<seeds::ErrorNote> Error;
};

#endif
