// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef bridge_MissingSegments_h
#define bridge_MissingSegments_h

#include <cstddef>
#include <string>
#include <vector>

namespace geodesic::bridge
{

/**
 * Returns what to say of segments between whose ends there is no path; the first five are named.
 * @param names     "from ... to ..." for each of them, at least one
 * @param segments  how many segments were sought
 */
std::string messageOfMissing(const std::vector<std::string>& names, std::size_t segments);

}

#endif
