// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/RegionOutput.h"

#include "base/Interruption.h"
#include "filter/VtkVersions.h"
#include "output/TupleRuns.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace geodesic::bridge
{

RegionOutput::RegionOutput(const InputBlocks& blocks, const InputSurface& surface,
  const RegionCut& cut, std::vector<bool> kept, bool keepsAll, std::string arrayName,
  std::vector<vtkIdType> newIds)
  : Blocks(blocks)
  , Surface(surface)
  , Regions(cut)
  , Kept(std::move(kept))
  , KeepsAll(keepsAll)
  , ArrayName(std::move(arrayName))
  , NewIds(std::move(newIds))
{
  this->findRegions();
  this->collectParts();
}

void RegionOutput::findRegions()
{
  std::size_t cells = 0;
  for (const InputBlock& block : this->Blocks)
  {
    cells += block.surface->GetNumberOfCells();
  }
  this->RegionOfCell.assign(cells, NoIndex);
  const TriangleMesh& mesh = *this->Surface.mesh();
  for (Index triangle = 0; triangle < mesh.numberOfTriangles(); ++triangle)
  {
    Interruption::checkAt(triangle);
    Index& region = this->RegionOfCell[this->Surface.cellOfTriangle(triangle)];
    const Index own = this->Regions.regionOf(triangle);
    region = own == NoIndex || (region != NoIndex && region != own) ? Cut : own;
  }
  // A line can end inside a polygon, along an edge between two of its triangles.
  for (const auto& [a, b] : this->Regions.closedEdges())
  {
    const Index cell = this->Surface.cellOfTriangle(a);
    if (cell == this->Surface.cellOfTriangle(b))
    {
      this->RegionOfCell[cell] = Cut;
    }
  }
}

void RegionOutput::collectParts()
{
  const TriangleMesh& mesh = *this->Surface.mesh();
  for (Index triangle = 0; triangle < mesh.numberOfTriangles(); ++triangle)
  {
    Interruption::checkAt(triangle);
    const Index region = this->Regions.regionOf(triangle);
    const Index cell = this->Surface.cellOfTriangle(triangle);
    if (region != NoIndex && this->isCut(cell))
    {
      this->Parts.push_back({ cell, region, mesh.triangle(triangle) });
    }
  }
  for (const RegionCut::Piece& piece : this->Regions.pieces())
  {
    this->Parts.push_back(
      { this->Surface.cellOfTriangle(piece.triangle), piece.region, piece.corners });
  }
  std::stable_sort(this->Parts.begin(), this->Parts.end());
}

/** The output of one block, while it is built. */
class RegionOutput::Block
{
public:
  Block(const RegionOutput& whole, std::size_t number)
    : Whole(whole)
    , Input(whole.Blocks[number].surface)
    , IsOuterSurface(whole.Blocks[number].outerSurface != nullptr)
    , FirstPoint(whole.Surface.numbering().firstPointOf(number))
    , FirstCell(whole.Surface.numbering().firstCellOf(number))
    , OutputPoint(this->Input->GetNumberOfPoints(), whole.KeepsAll ? 0 : -1)
  {
    this->addBareCells(this->Input->GetVerts());
    this->addBareCells(this->Input->GetLines());
    const vtkIdType firstStrip = this->Cell + this->Input->GetNumberOfPolys();
    this->addPolygons();
    this->addPartsOfStrips(firstStrip);
    this->addStrips(firstStrip);
    this->numberPoints();
  }

  void writeTo(vtkPolyData* output) const
  {
    vtkNew<vtkPoints> points;
    points->SetData(vtkDataArray::SafeDownCast(
      this->PointRuns.copied(this->Input->GetPoints()->GetData(), this->New.size())));
    const TriangleMesh& mesh = *this->Whole.Surface.mesh();
    for (std::size_t i = 0; i < this->New.size(); ++i)
    {
      const Vector3 position = this->Whole.Regions.pointAt(this->New[i].number).position(mesh);
      points->SetPoint(
        this->PointRuns.size() + static_cast<vtkIdType>(i), position.x, position.y, position.z);
    }
    Interruption::check();
    output->DeleteCells();
    output->DeleteLinks();
    output->SetPoints(points);
    output->SetVerts(this->Whole.KeepsAll ? this->Input->GetVerts() : nullptr);
    output->SetLines(this->Whole.KeepsAll ? this->Input->GetLines() : nullptr);
    output->SetPolys(this->cellsOf(this->Polygons));
    output->SetStrips(this->cellsOf(this->Strips));
    Interruption::check();
    this->writePointData(output->GetPointData());
    Interruption::check();
    this->writeCellData(output->GetCellData());
  }

private:
  /** Cells of the output: how many points each has, and the points. */
  struct Cells
  {
    std::vector<vtkIdType> offsets{ 0 };
    std::vector<vtkIdType> points;
  };
  /** A new point: its number in the cut, and the input's points that it lies between. */
  struct NewPoint
  {
    Index number;
    std::array<vtkIdType, 3> ends{ -1, -1, -1 };
    std::array<double, 3> weights{};
    int count = 0;
  };

  bool keeps(Index region) const
  {
    return region == NoIndex ? this->Whole.KeepsAll : this->Whole.Kept[region];
  }

  void addCell(vtkIdType cell, vtkIdType count, Index region)
  {
    this->CellRuns.add(cell, count);
    this->Regions.insert(
      this->Regions.end(), count, region == NoIndex ? -1 : static_cast<int>(region));
  }

  /** Vertices and lines, which are in the output if all regions are. */
  void addBareCells(vtkCellArray* cells)
  {
    if (this->Whole.KeepsAll)
    {
      this->addCell(this->Cell, cells->GetNumberOfCells(), NoIndex);
    }
    this->Cell += cells->GetNumberOfCells();
  }

  void use(vtkIdType point) { this->OutputPoint[point] = 0; }

  /** Adds the cells of an array that are kept and not cut. */
  void addWhole(vtkCellArray* cells, Cells& to, vtkIdType first, bool addsParts)
  {
    const vtkIdType count = cells->GetNumberOfCells();
    withOffsetsAndConnectivity(*cells,
      [&](const auto& offsets, const auto& connectivity)
      {
        to.offsets.reserve(count + 1);
        to.points.reserve(connectivity.size());
        for (vtkIdType i = 0; i < count; ++i)
        {
          Interruption::checkAt(i);
          const Index region = this->Whole.RegionOfCell[this->FirstCell + first + i];
          const auto begin = static_cast<vtkIdType>(offsets[i]);
          const auto end = static_cast<vtkIdType>(offsets[i + 1]);
          if (region == Cut)
          {
            if (addsParts)
            {
              this->addParts(
                first + i, { connectivity.begin() + begin, connectivity.begin() + end });
            }
            continue;
          }
          if (!this->keeps(region))
          {
            continue;
          }
          for (vtkIdType at = begin; at < end; ++at)
          {
            const auto point = static_cast<vtkIdType>(connectivity[at]);
            to.points.push_back(point);
            this->use(point);
          }
          to.offsets.push_back(static_cast<vtkIdType>(to.points.size()));
          this->addCell(first + i, 1, region);
        }
      });
  }

  void addPolygons()
  {
    this->addWhole(this->Input->GetPolys(), this->Polygons, this->Cell, true);
    this->Cell += this->Input->GetNumberOfPolys();
  }

  void addPartsOfStrips(vtkIdType first)
  {
    vtkNew<vtkIdList> points;
    for (vtkIdType i = 0; i < this->Input->GetNumberOfStrips(); ++i)
    {
      if (this->Whole.isCut(this->FirstCell + static_cast<Index>(first + i)))
      {
        this->Input->GetStrips()->GetCellAtId(i, points);
        this->addParts(first + i, { points->begin(), points->end() });
      }
    }
  }

  void addStrips(vtkIdType first)
  {
    this->addWhole(this->Input->GetStrips(), this->Strips, first, false);
  }

  void addParts(vtkIdType cell, const std::vector<vtkIdType>& points)
  {
    const Part wanted{ this->FirstCell + static_cast<Index>(cell), 0, {} };
    const auto [first, last] =
      std::equal_range(this->Whole.Parts.begin(), this->Whole.Parts.end(), wanted);
    std::for_each(first, last,
      [&](const Part& part)
      {
        if (!this->keeps(part.region))
        {
          return;
        }
        for (const Index corner : part.corners)
        {
          this->Polygons.points.push_back(this->pointOf(corner, points));
        }
        this->Polygons.offsets.push_back(static_cast<vtkIdType>(this->Polygons.points.size()));
        this->addCell(cell, 1, part.region);
      });
  }

  /** The point of a cell at a vertex of the mesh. */
  vtkIdType pointAt(Index vertex, const std::vector<vtkIdType>& points) const
  {
    return *std::find_if(points.begin(), points.end(),
      [&](vtkIdType point)
      {
        return this->Whole.Surface.mesh()->vertexOfPoint(
                 this->FirstPoint + static_cast<Index>(point)) == vertex;
      });
  }

  /** A point of a part: of the input, or a new one, numbered from the input's number of points. */
  vtkIdType pointOf(Index number, const std::vector<vtkIdType>& points)
  {
    if (number < this->Whole.Surface.mesh()->numberOfVertices())
    {
      const vtkIdType point = this->pointAt(number, points);
      this->use(point);
      return point;
    }
    const PathPoint place = this->Whole.Regions.pointAt(number);
    NewPoint added{ number };
    for (const Index vertex : place.carriers())
    {
      added.ends[added.count] = this->pointAt(vertex, points);
      added.weights[added.count++] = weightOf(place, vertex);
    }
    std::array<vtkIdType, 4> key{ number, added.ends[0], added.ends[1], added.ends[2] };
    std::sort(key.begin() + 1, key.end());
    const auto [known, isNew] =
      this->NewNumbers.emplace(key, static_cast<vtkIdType>(this->New.size()));
    if (isNew)
    {
      this->New.push_back(added);
    }
    return this->Input->GetNumberOfPoints() + known->second;
  }

  void numberPoints()
  {
    const auto count = static_cast<vtkIdType>(this->OutputPoint.size());
    if (this->Whole.KeepsAll)
    {
      this->PointRuns.add(0, count);
      return;
    }
    for (vtkIdType point = 0; point < count; ++point)
    {
      Interruption::checkAt(point);
      if (this->OutputPoint[point] >= 0)
      {
        this->OutputPoint[point] = this->PointRuns.size();
        this->PointRuns.add(point, 1);
      }
    }
    for (Cells* cells : { &this->Polygons, &this->Strips })
    {
      for (vtkIdType& point : cells->points)
      {
        point = point < count ? this->OutputPoint[point] : point - count + this->PointRuns.size();
      }
    }
  }

  static vtkSmartPointer<vtkCellArray> cellsOf(const Cells& cells)
  {
    const auto arrayOf = [](const std::vector<vtkIdType>& values)
    {
      auto array = vtkSmartPointer<vtkIdTypeArray>::New();
      array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
      std::copy(values.begin(), values.end(), array->GetPointer(0));
      return array;
    };
    auto array = vtkSmartPointer<vtkCellArray>::New();
    array->SetData(arrayOf(cells.offsets), arrayOf(cells.points));
    return array;
  }

  void writePointData(vtkPointData* output) const
  {
    vtkPointData* input = this->Input->GetPointData();
    this->PointRuns.copyArrays(*input, *output, static_cast<vtkIdType>(this->New.size()));
    Interruption::check();
    vtkDataArray* globalIds =
      this->Whole.Blocks.haveGlobalPointIds() ? this->globalIdsOf(*input, *output) : nullptr;
    for (int i = 0; i < output->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* to = output->GetAbstractArray(i);
      if (to != globalIds)
      {
        this->fillNew(input->GetAbstractArray(i), to, isDirection(*input, i));
      }
    }
    const vtkIdType firstNew = this->PointRuns.size();
    for (std::size_t i = 0; globalIds && i < this->New.size(); ++i)
    {
      const vtkIdType id =
        this->Whole.NewIds[this->New[i].number - this->Whole.Surface.mesh()->numberOfVertices()];
      globalIds->SetVariantValue(firstNew + static_cast<vtkIdType>(i), vtkVariant(id));
    }
    this->writeOriginalIds(output, "vtkOriginalPointIds", this->PointRuns);
  }

  /** The output's array of global ids, that of the same place as the input's. */
  static vtkDataArray* globalIdsOf(vtkPointData& input, vtkPointData& output)
  {
    vtkDataArray* ids =
      input.GetGlobalIds() ? input.GetGlobalIds() : input.GetArray("GlobalPointIds");
    for (int i = 0; i < input.GetNumberOfArrays(); ++i)
    {
      if (input.GetAbstractArray(i) == ids)
      {
        return output.GetArray(i);
      }
    }
    return nullptr;
  }

  static bool isDirection(vtkPointData& input, int array)
  {
    const int attribute = input.IsArrayAnAttribute(array);
    return attribute == vtkDataSetAttributes::NORMALS ||
      attribute == vtkDataSetAttributes::TANGENTS;
  }

  void fillNew(vtkAbstractArray* from, vtkAbstractArray* to, bool isDirection) const
  {
    auto* numbers = vtkDataArray::SafeDownCast(to);
    const bool isReal =
      numbers && (to->GetDataType() == VTK_FLOAT || to->GetDataType() == VTK_DOUBLE);
    vtkNew<vtkIdList> ends;
    for (std::size_t i = 0; i < this->New.size(); ++i)
    {
      const NewPoint& point = this->New[i];
      const vtkIdType place = this->PointRuns.size() + static_cast<vtkIdType>(i);
      if (!isReal)
      {
        const auto nearest = std::max_element(point.weights.begin(), point.weights.end());
        to->SetTuple(place, point.ends[nearest - point.weights.begin()], from);
        continue;
      }
      ends->SetNumberOfIds(point.count);
      std::copy_n(point.ends.begin(), point.count, ends->begin());
      auto weights = point.weights;
      to->InterpolateTuple(place, ends, from, weights.data());
      if (isDirection)
      {
        std::vector<double> tuple(numbers->GetNumberOfComponents());
        numbers->GetTuple(place, tuple.data());
        const double length =
          std::sqrt(std::inner_product(tuple.begin(), tuple.end(), tuple.begin(), 0.0));
        for (double& component : tuple)
        {
          component /= length > 0.0 ? length : 1.0;
        }
        numbers->SetTuple(place, tuple.data());
      }
    }
  }

  /** Ids in the input; those of a grid's outer surface are in the array already. */
  void writeOriginalIds(vtkDataSetAttributes* output, const char* name, const TupleRuns& runs) const
  {
    if (this->IsOuterSurface && output->GetArray(name))
    {
      auto* ids = output->GetArray(name);
      for (vtkIdType i = runs.size(); i < ids->GetNumberOfTuples(); ++i)
      {
        ids->SetComponent(i, 0, -1.0);
      }
      return;
    }
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(name);
    ids->SetNumberOfValues(
      runs.size() + (&runs == &this->PointRuns ? static_cast<vtkIdType>(this->New.size()) : 0));
    runs.writeSources(ids->GetPointer(0));
    std::fill(ids->GetPointer(0) + runs.size(), ids->GetPointer(0) + ids->GetNumberOfValues(), -1);
    output->AddArray(ids);
  }

  void writeCellData(vtkCellData* output) const
  {
    this->CellRuns.copyArrays(*this->Input->GetCellData(), *output, 0);
    // The parts of a cell would all have its id.
    output->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
    this->writeOriginalIds(output, "vtkOriginalCellIds", this->CellRuns);
    if (!this->Whole.ArrayName.empty())
    {
      vtkNew<vtkIntArray> regions;
      regions->SetName(this->Whole.ArrayName.c_str());
      regions->SetNumberOfValues(static_cast<vtkIdType>(this->Regions.size()));
      std::copy(this->Regions.begin(), this->Regions.end(), regions->GetPointer(0));
      output->AddArray(regions);
      output->SetActiveScalars(regions->GetName());
    }
  }

  const RegionOutput& Whole;
  vtkPolyData* Input;
  bool IsOuterSurface;
  Index FirstPoint;
  Index FirstCell;
  /** The number of each point in the output; -1 for one that it does not have. */
  std::vector<vtkIdType> OutputPoint;
  vtkIdType Cell = 0;
  Cells Polygons;
  Cells Strips;
  TupleRuns CellRuns;
  TupleRuns PointRuns;
  std::vector<int> Regions;
  std::vector<NewPoint> New;
  std::map<std::array<vtkIdType, 4>, vtkIdType> NewNumbers;
};

void RegionOutput::complete(std::size_t block, vtkPolyData* output) const
{
  if (this->Blocks[block].surface->GetPoints())
  {
    Block(*this, block).writeTo(output);
  }
}

}
