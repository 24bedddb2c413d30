// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/VertexFan.h"

#include <algorithm>

namespace geodesic
{

VertexFan::VertexFan(const WeightedMesh& weighted, Index vertex)
  : Surface(weighted)
  , Vertex(vertex)
  , Ring(weighted.ring(vertex))
  , IsClosed(Ring.front().neighbour() == Ring.back().neighbour())
  , Centre(weighted.mesh().position(vertex))
{
}

std::optional<double> VertexFan::appendShorterSide(
  const PathPoint& from, const PathPoint& to, std::vector<Triangle>& faces) const
{
  const std::optional<Place> source = this->placeOf(from);
  const std::optional<Place> target = this->placeOf(to);
  if (!source || !target)
  {
    return std::nullopt;
  }
  // Where both points lie in one face, that face is the shorter side.
  if (source->isInFace && target->isInFace && source->entry == target->entry)
  {
    AngleSum angle;
    angle.add(source->direction, target->direction);
    faces.push_back(this->face(source->entry));
    return angle.value();
  }
  const std::optional<Side> ahead = this->sideAhead(*source, *target);
  const std::optional<Side> back = this->sideAhead(*target, *source);
  const bool isAhead = ahead && (!back || ahead->angle.value() <= back->angle.value());
  if (!isAhead && !back)
  {
    return std::nullopt;
  }
  const Side& side = isAhead ? *ahead : *back;
  const std::size_t known = faces.size();
  for (std::size_t i = 0; i < side.faces; ++i)
  {
    faces.push_back(this->face((side.firstFace + i) % (this->Ring.size() - 1)));
  }
  if (!isAhead)
  {
    std::reverse(faces.begin() + static_cast<std::ptrdiff_t>(known), faces.end());
  }
  return side.angle.value();
}

std::optional<VertexFan::Place> VertexFan::placeOf(const PathPoint& point) const
{
  const auto isOther = [&](Index vertex) { return vertex != this->Vertex; };
  const Carriers carriers = point.carriers();
  const Index* const first = std::find_if(carriers.begin(), carriers.end(), isOther);
  if (first == carriers.end())
  {
    return std::nullopt;
  }
  const Index* const second = std::find_if(first + 1, carriers.end(), isOther);
  if (second == carriers.end())
  {
    const auto entry = std::find_if(this->Ring.begin(), this->Ring.end(),
      [&](const RingEntry& entry) { return entry.neighbour() == *first; });
    if (entry == this->Ring.end())
    {
      return std::nullopt;
    }
    const std::size_t number = entry - this->Ring.begin();
    return Place{ number, false, this->directionOf(number) };
  }
  for (std::size_t i = 0; i + 1 < this->Ring.size(); ++i)
  {
    const Index neighbour = this->Ring[i].neighbour();
    const Index next = this->Ring[i + 1].neighbour();
    if (((neighbour == *first && next == *second) || (neighbour == *second && next == *first)) &&
      this->hasFace(i))
    {
      return Place{ i, true, point.position(this->Surface.mesh()) - this->Centre };
    }
  }
  return std::nullopt;
}

std::optional<VertexFan::Side> VertexFan::sideAhead(const Place& from, const Place& to) const
{
  Side side{ from.entry };
  std::size_t entry = from.entry;
  Vector3 direction = from.direction;
  while (entry != to.entry || (from.isInFace && side.faces == 0))
  {
    if (!this->hasFace(entry))
    {
      return std::nullopt;
    }
    const Vector3 next = this->directionOf(entry + 1);
    if (!side.angle.add(direction, next))
    {
      return std::nullopt;
    }
    direction = next;
    ++side.faces;
    ++entry;
    entry = this->IsClosed && entry + 1 == this->Ring.size() ? 0 : entry;
  }
  if (to.isInFace)
  {
    if (!this->hasFace(entry) || !side.angle.add(direction, to.direction))
    {
      return std::nullopt;
    }
    ++side.faces;
  }
  return side;
}

bool VertexFan::hasFace(std::size_t entry) const
{
  return this->Surface.isCrossable(this->Vertex, entry);
}

Triangle VertexFan::face(std::size_t entry) const
{
  return { this->Vertex, this->Ring[entry].neighbour(), this->Ring[entry + 1].neighbour() };
}

Vector3 VertexFan::directionOf(std::size_t entry) const
{
  return this->Surface.mesh().position(this->Ring[entry].neighbour()) - this->Centre;
}

}
