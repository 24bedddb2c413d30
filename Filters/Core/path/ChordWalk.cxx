// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/ChordWalk.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace geodesic
{
namespace
{

/** The places of faces in a strip, by their corners. */
class FaceTable
{
public:
  explicit FaceTable(std::span<const StripFace> faces)
    : Faces(faces)
  {
    std::size_t size = 1;
    while (size < 2 * faces.size())
    {
      size *= 2;
    }
    this->Slots.assign(size, 0);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      std::size_t slot = this->slotOf(faces[i]);
      while (this->Slots[slot] != 0)
      {
        slot = this->next(slot);
      }
      this->Slots[slot] = i + 1;
    }
  }

  /** The place of a face after a place; 0 if there is none. */
  std::size_t placeAfter(std::size_t place, const StripFace& face) const
  {
    for (std::size_t slot = this->slotOf(face); this->Slots[slot] != 0; slot = this->next(slot))
    {
      const std::size_t i = this->Slots[slot] - 1;
      const StripFace& known = this->Faces[i];
      if (i > place && known.hasCorner(face.left) && known.hasCorner(face.right) &&
        known.hasCorner(face.apex))
      {
        return i;
      }
    }
    return 0;
  }

private:
  std::size_t slotOf(const StripFace& face) const
  {
    // The same for any order of the corners.
    const std::size_t sum = std::size_t{ face.left } + face.right + face.apex;
    const std::size_t mixed = (sum * 0x9E3779B97F4A7C15U) >> 32U;
    return mixed & (this->Slots.size() - 1);
  }
  std::size_t next(std::size_t slot) const { return (slot + 1) & (this->Slots.size() - 1); }

  std::span<const StripFace> Faces;
  /** Places, counted from 1. */
  std::vector<std::size_t> Slots;
};

/** The corner beyond an edge of a face; nothing if there is no other crossable face at the edge, or
 * more than one. */
std::optional<Index> cornerBeyond(const WeightedMesh& surface, Index a, Index b, Index corner)
{
  if (surface.mesh().ring(b).size() < surface.mesh().ring(a).size())
  {
    std::swap(a, b);
  }
  const std::span<const RingEntry> ring = surface.ring(a);
  surface.countSteps(ring.size());
  std::optional<Index> beyond;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
  {
    const Index first = ring[i].neighbour();
    const Index second = ring[i + 1].neighbour();
    if (first != b && second != b)
    {
      continue;
    }
    const Index other = first == b ? second : first;
    if (other == corner || !surface.isCrossable(a, i))
    {
      continue;
    }
    if (beyond)
    {
      return std::nullopt;
    }
    beyond = other;
  }
  return beyond;
}

/** Where a point of the plane comes to if an edge is moved, and it goes along. */
PlanePoint movedAlong(const Portal& from, const Portal& to, const PlanePoint& point)
{
  const PlanePoint a = from.right - from.left;
  const PlanePoint b = to.right - to.left;
  const PlanePoint away = point - from.left;
  const PlanePoint turn{ b.x * a.x + b.y * a.y, b.y * a.x - b.x * a.y };
  const double size = a.x * a.x + a.y * a.y;
  return { to.left.x + (turn.x * away.x - turn.y * away.y) / size,
    to.left.y + (turn.y * away.x + turn.x * away.y) / size };
}

class ChordWalk
{
public:
  ChordWalk(const WeightedMesh& surface, const StripChord& chord)
    : Surface(surface)
    , Faces(chord.faces)
    , From(chord.from)
    , To(chord.to)
    , OldTo(chord.to)
    , End(chord.end)
    , Walked(chord.faces.begin(), chord.faces.begin() + 2)
  {
  }

  std::optional<Strip> strip()
  {
    // A line that leads to the end crosses about as many faces as the old strip has.
    const std::size_t most = 2 * this->Faces.size() + 16;
    const Portal& entry = this->Walked.back().entry;
    if (!(this->isLeft(entry.left) && this->isRight(entry.right)))
    {
      return std::nullopt;
    }
    while (!liesIn(this->End, this->Walked.back().corners()))
    {
      if (this->Walked.size() > most)
      {
        return std::nullopt;
      }
      const PlanePoint apex = flatApex(this->Surface.mesh(), this->Walked.back());
      if (!(this->goesOnInStrip(apex) || this->crossesEdge(apex)))
      {
        return std::nullopt;
      }
    }
    this->Surface.countSteps(this->Walked.size());
    return std::move(this->Walked);
  }

private:
  bool isLeft(const PlanePoint& place) const
  {
    return orientation(this->From, this->To, place) > 0.0;
  }
  bool isRight(const PlanePoint& place) const
  {
    return orientation(this->From, this->To, place) < 0.0;
  }

  /** Enters the next face of the old strip, if the walk is in that strip and does not leave it.
   * @param apex  the last face's, laid flat */
  bool goesOnInStrip(const PlanePoint& apex)
  {
    if (this->Place == 0 || this->Place + 1 == this->Faces.size())
    {
      return false;
    }
    const StripFace& last = this->Walked.back();
    const StripFace& next = this->Faces[this->Place + 1];
    if (last.isEnteredBy(next.left, next.right))
    {
      return false;
    }
    const Index side = next.left == last.apex ? next.right : next.left;
    if (side == last.right ? this->isRight(apex) : this->isLeft(apex))
    {
      return false;
    }
    this->Walked.push_back(faceBeyond(last, apex, side, next.apex));
    ++this->Place;
    return true;
  }

  /** Enters any face beyond the edge by which the line leaves the last one. @return whether there
   * is one. @param apex  the last face's, laid flat */
  bool crossesEdge(const PlanePoint& apex)
  {
    const StripFace& last = this->Walked.back();
    const bool byLeft = this->isRight(apex);
    const Index side = byLeft ? last.left : last.right;
    const auto corner =
      cornerBeyond(this->Surface, side, last.apex, byLeft ? last.right : last.left);
    if (!corner)
    {
      return false;
    }
    this->Walked.push_back(faceBeyond(last, apex, side, *corner));
    if (!this->Table)
    {
      this->Table.emplace(this->Faces);
    }
    this->LastPlace = std::max(this->LastPlace, this->Place);
    this->Place = this->Table->placeAfter(this->LastPlace, this->Walked.back());
    return this->Place == 0 || this->turnsToEnd();
  }

  /** Turns the line so that it leads to the end as seen from the old strip. @return whether the old
   * strip is seen from the same side */
  bool turnsToEnd()
  {
    const TriangleMesh& mesh = this->Surface.mesh();
    const StripFace& old = this->Faces[this->Place];
    const StripFace& now = this->Walked.back();
    const PlanePoint oldApex = flatApex(mesh, old);
    const PlanePoint nowApex = flatApex(mesh, now);
    const auto placeNow = [&](Index vertex) {
      return vertex == now.left ? now.entry.left : vertex == now.right ? now.entry.right : nowApex;
    };
    const Portal here{ placeNow(old.left), placeNow(old.right) };
    if ((orientation(old.entry.left, old.entry.right, oldApex) > 0.0) !=
      (orientation(here.left, here.right, placeNow(old.apex)) > 0.0))
    {
      return false;
    }
    this->To = movedAlong(old.entry, here, this->OldTo);
    return true;
  }

  const WeightedMesh& Surface;
  std::span<const StripFace> Faces;
  PlanePoint From;
  /** Where the line leads, in the plane of the walk. */
  PlanePoint To;
  /** The chord's end in the plane of the old strip. */
  PlanePoint OldTo;
  PathPoint End;
  Strip Walked;
  /** The place of the last face in the old strip; 0 beside that strip. */
  std::size_t Place = 1;
  /** The last one in the old strip. */
  std::size_t LastPlace = 1;
  std::optional<FaceTable> Table;
};

}

std::optional<Strip> stripAlongChord(const WeightedMesh& surface, const StripChord& chord)
{
  return ChordWalk(surface, chord).strip();
}

}
