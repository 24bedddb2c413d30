// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_ShownSurface_h
#define seeds_ShownSurface_h

#include "Position.h"

#include "vtkSMProperty.h"
#include "vtkSMProxy.h"
#include "vtkSmartPointer.h"

class pqDataRepresentation;
class pqOutputPort;
class pqRenderView;
class vtkMatrix4x4;

namespace seeds
{

/**
 * A filter's surface as a view shows it: by the filter's input or by its own output, and where that
 * representation puts it.
 */
class ShownSurface
{
public:
  /**
   * @param filter  the proxy whose points are picked
   * @param input   its property that holds the surface
   */
  ShownSurface(vtkSMProxy* filter, vtkSMProperty* input);

  /** Null where there is no input. */
  pqOutputPort* inputPort() const;
  /** What shows the surface in a view, the input before the output; null where nothing does. */
  pqDataRepresentation* representationIn(pqRenderView* view) const;
  /** Whether a representation is of the input or of the filter. */
  bool isShownBy(vtkSMProxy* representation) const;
  /** From the data's coordinates to those of a view; representations can be moved and turned. */
  vtkSmartPointer<vtkMatrix4x4> placementIn(pqRenderView* view) const;
  /** What is nearer to the surface than this counts as lying on it; a small part of its size. */
  double thickness() const;
  /** The middle of the input's bounding box; 0 where there is none. */
  Position center() const;

private:
  vtkSmartPointer<vtkSMProxy> Filter;
  vtkSmartPointer<vtkSMProperty> Input;
};

Position transformed(vtkMatrix4x4* matrix, const Position& point);

}

#endif
