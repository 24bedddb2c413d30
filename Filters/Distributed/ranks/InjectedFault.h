// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_InjectedFault_h
#define geodesic_distributed_InjectedFault_h

#if SURFACEGEODESICS_INJECTS_FAULTS
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#endif

namespace geodesic::distributed
{

/**
 * In the tests' build, throws an error in the phase of a run whose number the environment variable
 * SURFACEGEODESICS_FAULT of this rank holds, and raises SIGUSR1 in that of SURFACEGEODESICS_ABORT,
 * so that a test can abort the run there. In what is installed it does nothing; see the CMake
 * option SURFACEGEODESICS_INJECT_FAULTS.
 * @param phase the phases that this rank has begun in this run, counted from 1
 */
inline void injectFault([[maybe_unused]] int phase)
{
#if SURFACEGEODESICS_INJECTS_FAULTS
  const auto isChosen = [&](const char* variable)
  {
    const char* const chosen = std::getenv(variable);
    return chosen && std::to_string(phase) == chosen;
  };
  if (isChosen("SURFACEGEODESICS_ABORT"))
  {
    std::raise(SIGUSR1);
  }
  if (isChosen("SURFACEGEODESICS_FAULT"))
  {
    throw std::runtime_error("A fault was injected in phase " + std::to_string(phase) + ".");
  }
#endif
}

}

#endif
