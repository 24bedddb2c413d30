// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgeFields_h
#define geodesic_EdgeFields_h

#include "base/Index.h"
#include "path/SurfaceField.h"

#include <span>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/**
 * How a distance field runs along the edges, so that the faces with an edge have a level at the
 * same places of it: as the distance from a point or as that of a straight front, whichever suits
 * the faces better. Where faces differ in their cost it is the field of the face that the front
 * comes from; where that is none or several, of the cheapest, as fronts run along edges. Edges of a
 * seed's face in a varying cost have the seed's own distances. Edges with values of both signs have
 * linear ones.
 */
class EdgeFields
{
public:
  /** @param faces  those that have a field. Time O(n). */
  EdgeFields(const SurfaceField& field, std::span<const Index> faces);

  /** The cost along a half-edge's edge. */
  double cost(Index halfEdge) const { return this->Cost.empty() ? 1.0 : this->Cost[halfEdge]; }

  /**
   * Where an edge has a level: fractions of the way from the end with the smaller vertex, in
   * increasing order. There is one if just one end is below the level; if both are farther than it,
   * none or two; else none. Both ends must have values.
   */
  std::vector<double> places(Index halfEdge, double level) const;
  /** Whether the distance falls to 0 between the ends of an edge, as where a line of seeds crosses
   * it. */
  bool hasSource(Index halfEdge) const;

private:
  /** A seed of varying cost beside an edge, in the plane of the edge and the seed. */
  struct SeedBeside
  {
    /** From the end with the smaller vertex. */
    double along;
    double away;
    double costAtSeed;
  };

  void choose(std::span<const Index> faces);
  /** Whether values are so small for the cost that the distance from a point would fall to 0
   * between the ends, without a source there: so it is behind a jump of the cost. */
  bool isBehindJump(Index halfEdge) const;
  bool costVaries() const;
  void addSeed(Index halfEdge, const FlatFace& flat, const FaceField& field);
  std::vector<double> placesBesideSeed(Index halfEdge, const SeedBeside& seed, bool firstIsBelow,
    bool secondIsBelow, double level) const;

  SurfaceField Field;
  /** For each half-edge. */
  std::vector<bool> IsRound;
  std::vector<bool> HasLine;
  /** For each edge the largest error of its faces as round ones; 0 beside a seed. */
  std::vector<float> Error;
  /** For each half-edge; empty if it is 1 everywhere. */
  std::vector<double> Cost;
  /** By half-edge. */
  std::unordered_map<Index, SeedBeside> Seeds;
};

}

#endif
