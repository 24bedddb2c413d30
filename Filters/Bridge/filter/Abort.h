// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Abort.h
 * @brief Aborts a filter by the means that the VTK version has.
 *
 * Versions after VTK 9.1 mark an incomplete output by a flag of its own, and abort a filter as well
 * when a filter upstream was aborted. VTK 9.1 has AbortExecute only, which the executive resets
 * before each run.
 */
#ifndef geodesic_bridge_Abort_h
#define geodesic_bridge_Abort_h

namespace geodesic::bridge
{

/** Returns whether a running filter must stop. If so, its output counts as aborted. */
template <class Filter>
bool checkAbort(Filter& filter)
{
  if constexpr (requires { filter.CheckAbort(); })
  {
    return filter.CheckAbort();
  }
  else
  {
    return filter.GetAbortExecute() != 0;
  }
}

/** Marks the output of a filter as incomplete. */
template <class Filter>
void setAborted(Filter& filter)
{
  if constexpr (requires { filter.SetAbortOutput(true); })
  {
    filter.SetAbortOutput(true);
  }
  else
  {
    filter.SetAbortExecute(1);
  }
}

/** Returns whether the output of a filter is marked as incomplete. */
template <class Filter>
bool isAborted(Filter& filter)
{
  if constexpr (requires { filter.GetAbortOutput(); })
  {
    return filter.GetAbortOutput();
  }
  else
  {
    return filter.GetAbortExecute() != 0;
  }
}

}

#endif
