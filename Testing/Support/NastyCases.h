// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_NastyCases_h
#define geodesic_testing_NastyCases_h

#include "Surfaces.h"
#include "mesh/TriangleMesh.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace geodesic::testing
{

/** Surfaces as no generator should make them; those that users do make are in RandomMeshes.h. A new
 * kind goes to the end, and also into nastySurface() and nameOf(). */
enum class NastyKind
{
  /** Random triangles with points of their own. */
  LooseSoup,
  /** Random triangles over few points, so that edges have many triangles. */
  Soup,
  /** The same in a plane, stretched up to 10,000 times. */
  FlatSoup,
  /** A terrain flattened until its triangles are slivers. */
  Slivers,
  /** A plane folded up like a map, so that its sheets lie on each other. */
  Folds,
  /** Triangles that are there several times, in both orientations. */
  Doubled,
  /** Edges with 2 to 50 triangles, side by side. */
  Books,
  /** Up to 500 triangles round a point, some of no area. */
  Fan,
  /** A strip, one triangle wide, that crosses itself. */
  Strip,
  /** Points that no triangle uses, not all finite, and triangles that repeat a corner. */
  Crumbs,
  /** A point that is not finite and that a triangle uses. */
  NotFinite,
  Count
};

std::string nameOf(NastyKind kind);

/** A nasty surface with a request on it. */
struct NastyCase
{
  NastyKind kind;
  Surface surface;
  CoincidentPoints coincident = CoincidentPoints::Separate;
  /** Null where the surface is refused: see refusal. */
  std::shared_ptr<const TriangleMesh> mesh;
  std::string refusal;
  std::vector<Seed> seeds;
  std::vector<double> cost;
  std::vector<std::uint8_t> excluded;
  std::vector<std::uint8_t> closedTriangles;

  SolveOptions options() const;
  bool hasBarriers() const { return !this->excluded.empty() || !this->closedTriangles.empty(); }
  std::string description() const;
};

/** A case, the same for the same @p number: a surface of 1 to some hundred triangles, a fourth of
 * them scaled by 1e-60 to 1e60 or moved away by 1e7 of their sizes; 0 to 10,000 seeds, points and
 * curves; costs from 1e-6 to 1e6; excluded vertices and closed triangles. */
NastyCase nastyCase(unsigned number);

}

#endif
