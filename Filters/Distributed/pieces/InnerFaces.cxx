// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pieces/InnerFaces.h"

#include "input/ArrayValues.h"
#include "pieces/PointKeys.h"
#include "ranks/KeyMatches.h"
#include "ranks/RankCache.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <vector>

namespace geodesic::distributed
{
namespace
{

using Surfaces = std::vector<std::shared_ptr<vtkPolyData>>;

/** The outer surfaces of the blocks that are grids. */
Surfaces surfacesOf(const bridge::InputBlocks& blocks)
{
  Surfaces surfaces;
  for (const bridge::InputBlock& block : blocks)
  {
    if (block.outerSurface)
    {
      surfaces.push_back(block.outerSurface);
    }
  }
  return surfaces;
}

/** Whether a block consists of several grids on this rank. */
bool hasCutBlock(const bridge::InputBlocks& blocks)
{
  std::set<unsigned int> numbers;
  return std::any_of(blocks.begin(), blocks.end(),
    [&](const bridge::InputBlock& block)
    { return block.outerSurface && !numbers.insert(block.block).second; });
}

/** A face, and its number in the exchange of keys. */
struct Face
{
  std::size_t cell;
  bool isOfGhost;

  static Face of(Index number) { return { number / 2, number % 2 != 0 }; }
  Index number() const { return static_cast<Index>(2 * this->cell + (this->isOfGhost ? 1 : 0)); }
};

/** Returns a key that is equal for faces with the same points in any order. */
Key keyOf(const std::vector<Key>& points, unsigned int block)
{
  Key key{ 0, 0, points.size(), block };
  for (Key point : points)
  {
    key[0] += hashOf(point);
    point[3] = ~point[3];
    key[1] += hashOf(point);
  }
  return key;
}

/** Tells which cells of a data set are three-dimensional. */
class VolumeCells
{
public:
  explicit VolumeCells(vtkDataSet* data)
    : Data(data)
  {
  }

  bool contain(vtkIdType cell)
  {
    const int type = this->Data->GetCellType(cell);
    const auto [known, isNew] = this->IsVolume.emplace(type, false);
    if (isNew)
    {
      const auto sample = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
      known->second = sample && sample->GetCellDimension() == 3;
    }
    return known->second;
  }

private:
  vtkDataSet* Data;
  std::map<int, bool> IsVolume;
};

/** Appends the faces of a grid's volume cells. */
void appendFaces(const bridge::InputBlock& block, const PointKeys& keys, Index firstPoint,
  std::size_t firstCell, std::vector<KeyedNumber>& faces)
{
  vtkPolyData* surface = block.surface;
  std::vector<vtkIdType> cells;
  bridge::appendValues(surface->GetCellData()->GetArray("vtkOriginalCellIds"),
    surface->GetNumberOfCells(), "vtkOriginalCellIds", cells);
  vtkUnsignedCharArray* ghosts = surface->GetCellGhostArray();
  VolumeCells volumes(block.data);
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  std::vector<Key> corners;
  for (vtkIdType polygon = 0; polygon < surface->GetNumberOfPolys(); ++polygon)
  {
    const vtkIdType cell = before + polygon;
    if (!volumes.contain(cells[cell]))
    {
      continue;
    }
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    surface->GetPolys()->GetCellAtId(polygon, count, points);
    corners.clear();
    for (vtkIdType i = 0; i < count; ++i)
    {
      std::array<double, 3> p{};
      surface->GetPoint(points[i], p.data());
      corners.push_back(
        keys.of(firstPoint + static_cast<Index>(points[i]), { p[0], p[1], p[2] }, block.block));
    }
    const bool isOfGhost =
      ghosts && (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
    faces.push_back({ keyOf(corners, block.block),
      Face{ firstCell + static_cast<std::size_t>(cell), isOfGhost }.number() });
  }
}

/** Returns the cells of all blocks that are inner faces, sorted. Collective. */
std::vector<std::size_t> innerCells(RankGroup& ranks, const std::vector<KeyedNumber>& faces)
{
  std::map<Index, int> elsewhere;
  for (const KeyMatch& match : matchKeys(ranks, faces))
  {
    const bool isItself = match.rank == ranks.rank() && match.number == match.own;
    elsewhere[match.own] += isItself || Face::of(match.number).isOfGhost ? 0 : 1;
  }
  std::vector<std::size_t> inner;
  for (const KeyedNumber& keyed : faces)
  {
    const Face face = Face::of(keyed.number);
    const auto found = elsewhere.find(keyed.number);
    const int owners = (found == elsewhere.end() ? 0 : found->second) + (face.isOfGhost ? 0 : 1);
    if (owners != 1)
    {
      inner.push_back(face.cell);
    }
  }
  std::sort(inner.begin(), inner.end());
  return inner;
}

/**
 * Returns a copy of a surface in which the inner faces are hidden. The copy also holds the surface,
 * so that this is extracted only once.
 */
std::shared_ptr<vtkPolyData> withHidden(const std::shared_ptr<vtkPolyData>& surface,
  std::span<const std::size_t> inner, std::size_t firstCell)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  if (vtkUnsignedCharArray* present = surface->GetCellGhostArray())
  {
    ghosts->DeepCopy(present);
  }
  else
  {
    ghosts->SetNumberOfValues(surface->GetNumberOfCells());
    ghosts->FillValue(0);
  }
  for (const std::size_t number : inner)
  {
    const auto cell = static_cast<vtkIdType>(number - firstCell);
    ghosts->SetValue(cell, ghosts->GetValue(cell) | vtkDataSetAttributes::HIDDENCELL);
  }
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(surface.get());
  copy->GetCellData()->AddArray(ghosts);
  return { copy.Get(), [surface, copy](vtkPolyData*) {} };
}

/** Returns the outer surfaces with their inner faces hidden. Collective. */
Surfaces openedSurfaces(
  RankGroup& ranks, const bridge::InputBlocks& blocks, const bridge::PointIdentity& identity)
{
  std::vector<KeyedNumber> faces;
  ranks.together(
    [&]
    {
      const PointKeys keys(blocks, identity);
      Index firstPoint = 0;
      std::size_t firstCell = 0;
      for (const bridge::InputBlock& block : blocks)
      {
        if (block.outerSurface && block.hasFaces())
        {
          appendFaces(block, keys, firstPoint, firstCell, faces);
        }
        firstPoint += static_cast<Index>(block.surface->GetNumberOfPoints());
        firstCell += static_cast<std::size_t>(block.surface->GetNumberOfCells());
      }
    });
  const std::vector<std::size_t> inner = innerCells(ranks, faces);
  Surfaces opened;
  std::size_t firstCell = 0;
  auto first = inner.begin();
  for (const bridge::InputBlock& block : blocks)
  {
    const auto endCell = firstCell + static_cast<std::size_t>(block.surface->GetNumberOfCells());
    const auto last = std::lower_bound(first, inner.end(), endCell);
    if (block.outerSurface)
    {
      opened.push_back(first == last ? block.outerSurface
                                     : withHidden(block.outerSurface, { first, last }, firstCell));
    }
    first = last;
    firstCell = endCell;
  }
  return opened;
}

bool isAnyGone(const std::vector<std::weak_ptr<vtkPolyData>>& surfaces)
{
  return std::any_of(
    surfaces.begin(), surfaces.end(), [](const auto& surface) { return surface.expired(); });
}

/** The result of an earlier run. */
struct KnownFaces
{
  bool isExpired() const { return isAnyGone(this->surfaces) || isAnyGone(this->opened); }

  bridge::PointIdentity identity;
  std::vector<std::weak_ptr<vtkPolyData>> surfaces;
  std::vector<std::weak_ptr<vtkPolyData>> opened;
};

Surfaces locked(const std::vector<std::weak_ptr<vtkPolyData>>& surfaces)
{
  Surfaces result;
  for (const auto& surface : surfaces)
  {
    result.push_back(surface.lock());
  }
  return result;
}

}

void hideInnerFaces(
  RankGroup& ranks, bridge::InputBlocks& blocks, const bridge::PointIdentity& identity)
{
  static RankCache<KnownFaces> cache;
  const Surfaces surfaces = surfacesOf(blocks);
  const bool mayHaveSome = ranks.size() > 1 ? !surfaces.empty() : hasCutBlock(blocks);
  if (identity.by == bridge::PointIdentity::By::Nothing || !ranks.isAny(mayHaveSome))
  {
    return;
  }
  const auto found = cache.find(ranks,
    [&](const KnownFaces& known)
    { return known.identity == identity && locked(known.surfaces) == surfaces; });
  Surfaces opened = found ? locked(found->opened) : Surfaces();
  const bool isWhole = found && std::find(opened.begin(), opened.end(), nullptr) == opened.end();
  if (ranks.isAny(!isWhole))
  {
    opened = openedSurfaces(ranks, blocks, identity);
    cache.add(
      ranks, { identity, { surfaces.begin(), surfaces.end() }, { opened.begin(), opened.end() } });
  }
  blocks.setOuterSurfaces(opened);
}

}
