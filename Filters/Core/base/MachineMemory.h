// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MachineMemory_h
#define geodesic_MachineMemory_h

#include <unistd.h>

#include <cstddef>

namespace geodesic
{

/** The machine's memory in bytes. */
inline std::size_t machineMemory()
{
  return static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
    static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}

#endif
