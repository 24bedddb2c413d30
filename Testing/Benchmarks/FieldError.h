// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_FieldError_h
#define geodesic_testing_FieldError_h

#include "Surfaces.h"

#include <string>

namespace geodesic::testing
{

/** Errors of distances, relative to the exact ones. */
struct FieldError
{
  /** Of the value that is too small by most. */
  double tooSmall = 0.0;
  /** Of all values, whichever sign. */
  double mean = 0.0;
};

/** The errors of a method, named as in the table of solvers, from some random points of a manifold
 * surface. */
FieldError errorOn(const Surface& surface, const std::string& method);

}

#endif
