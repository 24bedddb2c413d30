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

#include <QMouseEvent>
#include <QString>

#include <memory>

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

/** Where in its widget the pointer was. Qt 6 renamed it. */
template <class Event>
QPointF placeOf(const Event& event)
{
  if constexpr (requires { event.position(); })
  {
    return event.position();
  }
  else
  {
    return event.localPos();
  }
}

/** An event of the mouse that can be sent later. Qt 6 renamed the places. */
template <class Event>
std::unique_ptr<QMouseEvent> copyOf(const Event& event)
{
  const auto copyAt = [&](const QPointF& inWindow, const QPointF& onScreen)
  {
    return std::make_unique<QMouseEvent>(event.type(), placeOf(event), inWindow, onScreen,
      event.button(), event.buttons(), event.modifiers());
  };
  if constexpr (requires { event.scenePosition(); })
  {
    return copyAt(event.scenePosition(), event.globalPosition());
  }
  else
  {
    return copyAt(event.windowPos(), event.screenPos());
  }
}

/** The property by which a representation is moved. ParaView 5.13 renamed it. */
inline const char* translationOf(vtkSMProxy* representation)
{
  return representation->GetProperty("Translation") ? "Translation" : "Position";
}

}

#endif
