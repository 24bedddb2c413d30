// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMSurfaceOfLines
 * @brief lets a filter that takes a surface and lines be made on the lines alone
 *
 * For the hints of a filter's proxy:
 *
 *     <InitializationHelper class="vtkSMSurfaceOfLines" lines="Lines" maker="GeodesicPath" />
 *
 * Where the filter is made with lines as its Input, the output of a proxy of the maker's name,
 * these become the property of the attribute `lines`, and Input becomes the surface that they were
 * made on. Nothing changes where that property is set already.
 */
#ifndef vtkSMSurfaceOfLines_h
#define vtkSMSurfaceOfLines_h

#include "vtkSMProxyInitializationHelper.h"
#include "vtkWidgetsLinesModule.h" // For the export macro

class VTKWIDGETSLINES_EXPORT vtkSMSurfaceOfLines : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMSurfaceOfLines* New();
  vtkTypeMacro(vtkSMSurfaceOfLines, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMSurfaceOfLines() = default;
  ~vtkSMSurfaceOfLines() override = default;

private:
  vtkSMSurfaceOfLines(const vtkSMSurfaceOfLines&) = delete;
  void operator=(const vtkSMSurfaceOfLines&) = delete;
};

#endif
