// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_ErrorMessage_h
#define geodesic_bridge_ErrorMessage_h

#include <exception>
#include <new>
#include <string>

namespace geodesic::bridge
{

/** The message that a filter shows its user for an exception from Core or Bridge. */
inline std::string messageOf(const std::exception& error)
{
  if (dynamic_cast<const std::bad_alloc*>(&error))
  {
    return "There is not enough memory for this surface, which takes some 150 bytes a point beside "
           "the input. Use a smaller part of it or a larger machine.";
  }
  return error.what();
}

}

#endif
