// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ParaViewVersions.h
 * @brief What differs from one version of ParaView's client to another, each with the version that
 * needs it. What differs in VTK is in Filters/Bridge/filter/VtkVersions.h.
 */
#ifndef seeds_ParaViewVersions_h
#define seeds_ParaViewVersions_h

#include "pqCoreUtilities.h"
#include "pqDoubleLineEdit.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProxy.h"

#include <QString>

namespace seeds
{

/** A number in the digits and notation of ParaView's settings. From ParaView 5.13 on another
 * class has the function. */
template <class Present = pqCoreUtilities, class Before = pqDoubleLineEdit>
QString shownNumber(double value)
{
  if constexpr (requires { Present::formatNumber(value); })
  {
    return Present::formatNumber(value);
  }
  else
  {
    return Before::formatDoubleUsingGlobalPrecisionAndNotation(value);
  }
}

/**
 * Shows the legend of what a representation is coloured by. It is a static method up to ParaView
 * 5.12 and one of the representation's proxy from 5.13 on.
 */
template <class Proxy = vtkSMPVRepresentationProxy>
void showLegend(vtkSMProxy* representation, vtkSMProxy* view)
{
  if constexpr (requires { Proxy::SetScalarBarVisibility(representation, view, true); })
  {
    Proxy::SetScalarBarVisibility(representation, view, true);
  }
  else if (auto* colored = Proxy::SafeDownCast(representation))
  {
    colored->SetScalarBarVisibility(view, true);
  }
}

/** The property by which a representation is moved. ParaView 5.13 renamed it. */
inline const char* translationOf(vtkSMProxy* representation)
{
  return representation->GetProperty("Translation") ? "Translation" : "Position";
}

}

#endif
