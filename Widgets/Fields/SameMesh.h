// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SameMesh_h
#define SameMesh_h

#include "vtkCellArray.h"
#include "vtkPolyData.h"

/**
 * Whether two data sets have the very same points and cells in memory, as shallow copies of one do.
 */
inline bool haveSameMesh(vtkPolyData* a, vtkPolyData* b)
{
  return a->GetPoints() == b->GetPoints() && a->GetVerts() == b->GetVerts() &&
    a->GetLines() == b->GetLines() && a->GetPolys() == b->GetPolys() &&
    a->GetStrips() == b->GetStrips();
}

#endif
