// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_WorstSeeds_h
#define geodesic_testing_WorstSeeds_h

#include "mesh/TriangleMesh.h"
#include "solve/Seed.h"

#include <functional>
#include <random>
#include <vector>

namespace geodesic::testing
{

/** Different vertices at random; all of them if there are not more than @p count. */
std::vector<Index> randomVertices(const TriangleMesh& mesh, Index count, std::mt19937& random);

/** A point anywhere in a face, every face as likely as another. */
SurfacePoint randomPoint(const TriangleMesh& mesh, std::mt19937& random);

/** The triangles whose centres are the nearest to that of one, in space. */
std::vector<Index> trianglesRound(const TriangleMesh& mesh, Index triangle, Index count);

using Segment = std::array<SurfacePoint, 2>;

/** Where a function of the position crosses 0, as a contour filter or a slice would give it. */
std::vector<Segment> segmentsAtZero(
  const TriangleMesh& mesh, const std::function<double(const Vector3&)>& height);

/** Edges of one triangle. */
std::vector<Segment> boundarySegments(const TriangleMesh& mesh);

/** Random edges, each once or more. */
std::vector<Segment> randomEdges(const TriangleMesh& mesh, Index count, std::mt19937& random);

/** A seed for each segment. */
std::vector<Seed> looseSeeds(const std::vector<Segment>& segments);

/** One seed of all segments, which go on from each other where they are sorted by x. */
Seed seedAlong(const TriangleMesh& mesh, std::vector<Segment> segments);

}

#endif
