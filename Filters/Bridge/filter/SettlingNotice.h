// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SettlingNotice_h
#define geodesic_bridge_SettlingNotice_h

#include "base/NumberText.h"
#include "solve/MarchControl.h"

#include <string>

namespace geodesic::bridge
{

/** What a filter tells its user where a front did not settle as it should.
 * @param raisedGain  see DistanceField, above 0
 * @param method      by which distances were measured
 * @param remedy      a sentence */
inline std::string settlingNotice(
  double raisedGain, const std::string& method, const std::string& remedy)
{
  return "The front settled only roughly: it took more than " +
    std::to_string(MarchControl::UsualUpdates) +
    " updates for each value, so that gains below a part of " + textOf(raisedGain) +
    " did not count any more. Distances of " + method +
    " are less exact than usual on this surface, and depend on the order of its points. " + remedy;
}

}

#endif
