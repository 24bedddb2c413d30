// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VtkThreads.h
 * @brief How many threads VTK uses.
 */
#ifndef geodesic_bridge_VtkThreads_h
#define geodesic_bridge_VtkThreads_h

namespace geodesic::bridge
{

/** Returns how many threads vtkSMPTools uses at present, by its backend and settings: 1 or more.
 * Needed by VTK 9.1, whose vtkSMPTools.h is no C++20: only VtkThreads.cxx, in C++17, reads it. */
int threadsOfVtk();

}

#endif
