// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_Surfaces_h
#define geodesic_testing_Surfaces_h

#include "base/Index.h"
#include "base/Vector3.h"

#include <string>
#include <vector>

namespace geodesic::testing
{

/** Points and triangles, as an input would give them. */
struct Surface
{
  std::vector<Vector3> points;
  std::vector<Triangle> triangles;
};

/** The rectangle [0, width] x [0, height] as columns x rows cells, each cut by a diagonal. */
Surface planeGrid(Index columns, Index rows, double width, double height);
/** The same with every inner point moved at random by up to @p fraction of the cell's short side.
 */
Surface jitteredGrid(
  Index columns, Index rows, double width, double height, double fraction, unsigned seed);
/** Unit squares, z = 3 sin(x/9) cos(y/7). */
Surface hillyGrid(Index columns, Index rows);
/** Unit squares whose points are raised at random: most of them are tips or saddles. */
Surface roughGrid(Index cells);
/** Unit sphere: an icosahedron whose triangles are cut in four @p levels times; 10 4^levels + 2
 * points. */
Surface icosphere(int levels);
/** The surface with each triangle cut in four, several times; its shape stays. */
Surface subdivided(Surface surface, int times);
/** Torus of the given radii round the z axis. */
Surface torus(Index around, Index across, double majorRadius, double minorRadius);
/** Open cylinder round the z axis without a double seam; its cells touch the true surface. */
Surface cylinder(Index around, Index along, double radius, double height);
/** Triangles that all share the edge between points 0 and 1, of length 1; each goes as far from it.
 */
Surface pages(Index count);
/** Unit disc of triangles round one point, point 0. */
Surface disc(Index around);
/** Open cone with its apex (point 0) at the origin; @p slope is the side's length. */
Surface cone(Index around, Index along, double radius, double slope);
/**
 * A closed box with rounded edges and corners, as CAD programs mesh it: two triangles for each flat
 * side, needles that are as long as the box along the edges, small triangles at the corners.
 * @param perHalf  edges along half of a fillet
 */
Surface boxWithFillets(Index perHalf);
/** Adds the cells between rings of points; the last point of a ring is followed by its first. */
void addRingCells(Surface& surface, Index first, Index around, Index rings);
/** Several surfaces as one, not connected. */
Surface joined(const Surface& a, const Surface& b);
/** The same surface with its points in random order; newId[i] is point i's new id. */
Surface withPointsShuffled(const Surface& surface, unsigned seed, std::vector<Index>& newId);
/** The same with points, triangles and the corners of these in random order. */
Surface shuffled(const Surface& surface, unsigned seed, std::vector<Index>& newId);
/** The surface of an OFF file of triangles; throws std::runtime_error. */
Surface readOff(const std::string& file);
const Surface& spot();
const Surface& bunny();

}

#endif
