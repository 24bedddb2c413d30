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
 * A filter's surface as a view shows it: by a representation of the filter's input or of its
 * output, which can be moved and turned.
 */
class ShownSurface
{
public:
  /**
   * @param filter  the proxy whose points are picked
   * @param input   the filter's property that holds the surface
   */
  ShownSurface(vtkSMProxy* filter, vtkSMProperty* input);

  /** The port that gives the surface; null if there is no input. */
  pqOutputPort* inputPort() const;
  /**
   * The representation that shows the surface in a view: the input's or, if that is hidden, the
   * output's. Null if both are hidden.
   */
  pqDataRepresentation* representationIn(pqRenderView* view) const;
  /** Whether a representation is of the input or of the filter. */
  bool isShownBy(vtkSMProxy* representation) const;
  /** The transformation from the data's coordinates to those of a view. */
  vtkSmartPointer<vtkMatrix4x4> placementIn(pqRenderView* view) const;
  /**
   * Points that are nearer to the surface than this count as lying on it. A small part of the
   * surface's size.
   */
  double thickness() const;
  /** The middle of the input's bounding box; 0 if there is no input. */
  Position center() const;

private:
  vtkSmartPointer<vtkSMProxy> Filter;
  vtkSmartPointer<vtkSMProperty> Input;
};

Position transformed(vtkMatrix4x4* matrix, const Position& point);

}

#endif
