// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_SimulatedRanks_h
#define geodesic_testing_SimulatedRanks_h

#include <functional>

class vtkMultiProcessController;

namespace geodesic::testing
{

/**
 * Runs work on as many ranks as are asked for, all in this process: each is a thread, and its
 * controller's messages go through memory. What the ranks do is what they would do on a cluster;
 * how long they take is not.
 * @param work called once for each rank, with the rank's controller
 * @throws what the lowest rank of those that failed threw; a rank that fails must not leave others
 *         waiting (see Agreement)
 */
void runOnRanks(int ranks, const std::function<void(vtkMultiProcessController*)>& work);

}

#endif
