// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_ObjectVersion_h
#define geodesic_bridge_ObjectVersion_h

#include "vtkObject.h"

namespace geodesic::bridge
{

/**
 * Identifies the present state of a VTK object, which may be null, by its address and its
 * modification time. VTK never gives a modification time twice, so an address that is used again
 * does not matter.
 */
struct ObjectVersion
{
  ObjectVersion(vtkObject* o)
    : object(o)
    , time(o ? o->GetMTime() : 0)
  {
  }

  vtkObject* object;
  vtkMTimeType time;

  friend bool operator==(const ObjectVersion&, const ObjectVersion&) = default;
};

}

#endif
