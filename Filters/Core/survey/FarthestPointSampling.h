// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FarthestPointSampling_h
#define geodesic_FarthestPointSampling_h

#include "base/Vector3.h"
#include "solve/DistanceField.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace geodesic
{

class DistanceSolver;
class SolverTeam;

/** A point of a sampling. */
struct Sample
{
  /** The same on all pieces of the surface. */
  Vector3 position;
  /** The distance from the nearest of the samples before, when it was chosen; infinity if none
   * reached it, and for the points given first, which are not chosen. */
  double distance = DistanceField::Unreached;
  /** The sample's vertex; NoIndex if it is none, or one that other pieces speak for (see
   * Partition::owns()). */
  Index vertex = NoIndex;
};

/** What to sample, and how long. */
struct SamplingRequest
{
  /** Points that are samples before any other. Each is one point, and no two are at one place. */
  std::span<const Seed> firstPoints;
  /** The number of samples, the first points included. 0: as many as the spacing needs. */
  std::size_t count = 0;
  /** Samples are taken until no vertex is farther than this from one. 0: until they are enough. */
  double spacing = 0.0;
  /** One flag for each vertex: non-zero where it can't be a sample. Empty: all can be. */
  std::span<const std::uint8_t> neverSamples;
  /** Cost, barriers, partition, memory and tolerance; the rest is not looked at. */
  SolveOptions options;
  /** Called now and then with the part of the work that is done, from 0 to 1. Returning false
   * cancels the sampling. */
  std::function<bool(double)> onProgress;
};

/** Samples, and the field that they make together. */
struct Sampling
{
  /** In the order in which they were taken. */
  std::vector<Sample> samples;
  /** The distance of each vertex from the nearest sample, whose number is its nearest seed. */
  DistanceField field;
  /** The largest distance of a vertex that can be a sample and that a sample reaches, on all
   * pieces. */
  double coveringRadius = 0.0;
  /** How many vertices of this piece can be samples and are reached by none. */
  std::size_t numberOfUnreached = 0;
  bool isCancelled = false;
};

/**
 * Spreads samples evenly over a surface: each is the vertex that is farthest from those before. No
 * vertex is then farther from a sample than the last sample was from the others, and no two
 * samples are closer than that. T. Gonzalez, Clustering to minimize the maximum intercluster
 * distance, Theor. Comput. Sci. 38 (1985); G. Peyre, L. Cohen, Geodesic remeshing using front
 * propagation, Int. J. Comput. Vision 69 (2006).
 *
 * Vertices whose distances are within 1e-9 of the largest are equally far, and of these the first
 * by position is taken (isBefore()), so that rounding, numbering and pieces do not matter. A vertex
 * that no sample reaches is farther than all others: each part of the surface gets a sample before
 * any part gets a second one. Vertices without an open triangle, and excluded ones, are no samples.
 *
 * The front of a new sample goes only as far as it is the nearest, and a little farther
 * (SolveOptions::usefulBelow). The first points march together. Collective on a surface in several
 * pieces.
 *
 * @return on all pieces the same samples; the field on this piece
 * @throws std::invalid_argument for neither a count nor a spacing, a spacing below 0, or more
 *         samples than there are points apart from each other
 * Time: about log(count) whole solves and O(log n) for each fall of a distance.
 */
Sampling sampleFarthest(DistanceSolver& solver, const SamplingRequest& request);

/**
 * The same with the solvers of a team, on whose number the result does not depend: the marches of
 * samples that will probably be taken soon are made together (see MarchesAhead). They end by older,
 * larger distances than those of the function above; bounded distances can so differ within their
 * tolerance, and others by rounding. A surface in several pieces is sampled by the first solver.
 */
Sampling sampleFarthest(SolverTeam& solvers, const SamplingRequest& request);

}

#endif
