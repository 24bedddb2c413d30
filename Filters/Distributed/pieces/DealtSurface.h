// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_DealtSurface_h
#define geodesic_distributed_DealtSurface_h

#include "base/BoundingBox.h"
#include "pieces/DividedMesh.h"
#include "pieces/SharedPoints.h"
#include "ranks/RankGroup.h"
#include "solve/DistanceField.h"
#include "solve/Seed.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace geodesic::distributed
{

/** To whom the triangles of a surface are dealt. */
struct Dealing
{
  /** Only to the first rank, for solvers that need the surface in one piece. */
  bool isToFirst = false;
  /** Only triangles within a distance of a box are dealt, and some beside them. */
  BoundingBox box = {};
  double distance = BoundingBox::infinity;

  bool operator==(const Dealing& other) const;
};

/**
 * A surface whose pieces were cut into patches, which are dealt out to the ranks in turn. Each rank
 * has patches in many places, so it has work wherever the front is; of compact pieces, one waits
 * for the front while another works. Or all triangles are dealt to the first rank.
 *
 * What is solved for are the dealt patches. Everything that a request says about the pieces is sent
 * along the same way as the triangles, and distances are sent back. A rank holds its piece and
 * about as many points of patches. All functions that take the ranks are collective.
 */
class DealtSurface
{
public:
  /** Cuts and deals. Time O(n log n). */
  DealtSurface(
    RankGroup& ranks, std::shared_ptr<const DividedMesh> pieces, const Dealing& dealing = {});

  /** The pieces of the surface that was dealt. */
  const std::shared_ptr<const DividedMesh>& origin() const { return this->Origin; }
  const Dealing& dealing() const { return this->How; }
  /** The patches of this rank. */
  const DividedMesh& divided() const { return *this->Divided; }
  const TriangleMesh& mesh() const { return this->Divided->mesh(); }

  /** Returns numbers of the piece's vertices for mesh(); 0 where a rank passes none. */
  std::vector<double> ofVertices(RankGroup& ranks, std::span<const double> values) const;
  /** The same with flags. */
  std::vector<std::uint8_t> ofVertices(RankGroup& ranks, std::span<const std::uint8_t> flags) const;
  /** Returns flags of the piece's triangles for mesh(); 0 where a rank passes none. */
  std::vector<std::uint8_t> ofTriangles(
    RankGroup& ranks, std::span<const std::uint8_t> flags) const;

  /** For each of some points its place, if it has one. */
  using Places = std::vector<std::vector<SurfacePoint>>;
  /**
   * Returns the places on mesh() of points of the surface.
   * @param points their places on this rank's piece
   */
  Places places(RankGroup& ranks, const Places& points) const;
  /** Returns seeds with their places on mesh(). Curves must be on the first rank, and all triangles
   * beside them dealt to it. */
  std::vector<Seed> seeds(RankGroup& ranks, std::vector<Seed> seeds) const;

  /**
   * Sets the distances and nearest seeds at the piece's vertices to those of a field on mesh().
   * @param dealt  null where mesh() has no triangles
   * @param reason why the run ended, the same on all ranks
   */
  void takeBack(
    RankGroup& ranks, const DistanceField* dealt, StopReason reason, DistanceField& ofPiece) const;

private:
  /** What this rank dealt to a rank: triangles and vertices of its piece. */
  struct Dealt
  {
    std::vector<Index> triangles;
    /** In ascending order. */
    std::vector<Index> vertices;
  };
  /** A rank's first point and first triangle among those that this rank got. */
  struct Got
  {
    Index firstPoint;
    Index firstTriangle;
  };

  void cut(const RankGroup& ranks);
  void deal(RankGroup& ranks);
  /** Returns the vertex of mesh() at the point with a number among those that a rank dealt; NoIndex
   * where no triangle of the vertex was dealt. */
  Index vertexAt(const Got& from, std::size_t number) const
  {
    return this->VertexOfPoint[from.firstPoint + static_cast<Index>(number)];
  }
  Index find(const GlobalVertex& vertex) const;
  /** A vertex that carries a point, and by which weight. */
  using Carrier = std::pair<GlobalVertex, double>;
  /** Returns the place on mesh() of a point, if it has one. */
  std::optional<SurfacePoint> placeOf(std::span<const Carrier> carriers) const;
  /** Returns the place on mesh() of a point of the piece, if it has one. */
  std::optional<SurfacePoint> placeOf(const SurfacePoint& point) const;

  std::shared_ptr<const DividedMesh> Origin;
  Dealing How;
  std::vector<Dealt> ToRank;
  std::vector<Got> FromRank;
  /** The points of mesh(), sorted by what vertex of the surface they are. */
  std::vector<std::pair<GlobalVertex, Index>> Points;
  /** Also of points that none of their sender's triangles has, but another's; NoIndex if none. */
  std::vector<Index> VertexOfPoint;
  std::unique_ptr<const DividedMesh> Divided;
};

}

#endif
