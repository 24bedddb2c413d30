// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMSurfaceLinesDefaults
 * @brief the width and colour of lines when they are first shown
 *
 * For the hints of a representation's proxy, whose properties of these names cannot have other
 * defaults in XML, because it shares them with ParaView's other representations:
 *
 *     <InitializationHelper class="vtkSMSurfaceLinesDefaults" width="4" color="0.85 0 0.85" />
 *
 * The width is in pixels. The colour is one for all lines; arrays colour them on request. What the
 * user has saved as default, or has set already, stays.
 */
#ifndef vtkSMSurfaceLinesDefaults_h
#define vtkSMSurfaceLinesDefaults_h

#include "vtkSMProxyInitializationHelper.h"
#include "vtkWidgetsLinesModule.h" // For the export macro

class VTKWIDGETSLINES_EXPORT vtkSMSurfaceLinesDefaults : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMSurfaceLinesDefaults* New();
  vtkTypeMacro(vtkSMSurfaceLinesDefaults, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMSurfaceLinesDefaults() = default;
  ~vtkSMSurfaceLinesDefaults() override = default;

private:
  vtkSMSurfaceLinesDefaults(const vtkSMSurfaceLinesDefaults&) = delete;
  void operator=(const vtkSMSurfaceLinesDefaults&) = delete;
};

#endif
