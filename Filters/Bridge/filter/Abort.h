// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Abort.h
 * @brief The abort of a filter, in VTK 9.1 as in later ones.
 *
 * Later ones have a flag of their own for an output that is incomplete, and can be aborted from
 * upstream. In 9.1 there is AbortExecute alone, which the executive takes back before each run.
 */
#ifndef geodesic_bridge_Abort_h
#define geodesic_bridge_Abort_h

namespace geodesic::bridge
{

/** Whether the filter, as it runs, is to stop. Its output counts as aborted then. */
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
