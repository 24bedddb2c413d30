// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_RandomMeshes_h
#define geodesic_testing_RandomMeshes_h

#include "Surfaces.h"
#include "mesh/TriangleMesh.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace geodesic::testing
{

/** What kind of surface a random mesh is. A new kind goes to the end, and also into meshKinds(),
 * nameOf() and randomSurface(). It changes which kind a seed of randomCase() has. */
enum class MeshKind
{
  /** A closed blob. */
  Closed,
  /** A rough terrain over random points of the plane. */
  Terrain,
  /** A regular grid, with all its ties between equal ways. */
  Grid,
  /** A torus with bumps. */
  Torus,
  /** A blob with holes: some of its triangles are missing. */
  Holes,
  /** Edges of one to five triangles, and sheets that meet in a point. */
  NonManifold,
  /** A plane stretched until its triangles are needles. */
  Needles,
  /** Edge lengths from 1 to 1000. */
  Graded,
  /** Several parts of different kinds. */
  Parts,
  /** Many triangles round one point. */
  Fan,
  /** A long strip, one cell wide. */
  Strip,
  /** Triangles of mixed orientation, doubled ones, ones with a repeated point, unused points. */
  Careless
};

/** All kinds, in their order. */
std::span<const MeshKind> meshKinds();
std::string nameOf(MeshKind kind);

/** A surface of a kind: some hundred points, the same for the same @p seed. */
Surface randomSurface(MeshKind kind, unsigned seed);

/** A surface with a request on it. */
struct RandomCase
{
  MeshKind kind;
  std::shared_ptr<const TriangleMesh> mesh;
  std::vector<Seed> seeds;
  std::vector<double> cost;
  std::vector<std::uint8_t> excluded;
  std::vector<std::uint8_t> closedTriangles;

  /** Of cost and barriers, which live as long as this. */
  SolveOptions options() const;
  /** For messages. */
  std::string description() const;
};

/** What the request of a random case may have. */
struct CaseLimits
{
  /** Seeds: points at vertices, on edges and in faces. */
  unsigned mostSeeds = 1;
  bool mayHaveCosts = true;
  bool mayHaveBarriers = true;
};

/** A case, the same for the same @p seed; consecutive seeds go through @p kinds in turn. */
RandomCase randomCase(
  unsigned seed, const CaseLimits& limits, std::span<const MeshKind> kinds = meshKinds());

}

#endif
