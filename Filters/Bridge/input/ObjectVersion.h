// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_ObjectVersion_h
#define geodesic_bridge_ObjectVersion_h

#include "vtkObject.h"

namespace geodesic::bridge
{

/**
 * An object as it is now; null is allowed. Modification times are never used twice, so a reused
 * address does not matter.
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
