// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/PathOutput.h"

#include "base/Interruption.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>

namespace geodesic::bridge
{
namespace
{

/** The two nearest of the vertices that carry a point; at a vertex twice the same. */
std::array<Index, 2> nearestCarriers(const PathPoint& point)
{
  const Carriers carriers = point.carriers();
  std::array<Index, 2> nearest{ carriers[0], carriers[carriers.size() > 1 ? 1 : 0] };
  for (int i = 1; i < carriers.size(); ++i)
  {
    const double weight = weightOf(point, carriers[i]);
    if (weight > weightOf(point, nearest[0]))
    {
      nearest = { carriers[i], nearest[0] };
    }
    else if (weight > weightOf(point, nearest[1]))
    {
      nearest[1] = carriers[i];
    }
  }
  return nearest;
}

SurfaceNormals normalsOf(const PathAttributes& attributes)
{
  return { attributes.mesh(), [&attributes](Index vertex) { return attributes.normalOf(vertex); } };
}

}

PathOutput::PathOutput(double heightOffset, bool namesBlocks)
  : HeightOffset(heightOffset)
  , NamesBlocks(namesBlocks)
{
  this->Positions->SetNumberOfComponents(3);
  this->ArcLengths->SetName("ArcLength");
  this->OriginalPointIds->SetName("OriginalPointIds");
  this->EdgePointIds->SetName("EdgePointIds");
  this->EdgePointIds->SetNumberOfComponents(2);
  this->OriginalBlocks->SetName("OriginalBlocks");
  this->EdgeBlocks->SetName("EdgeBlocks");
  this->EdgeBlocks->SetNumberOfComponents(2);
  this->Normals->SetName("Normals");
  this->Normals->SetNumberOfComponents(3);
  this->Segments->SetName("Segment");
  this->Lengths->SetName("Length");
}

PathOutput::~PathOutput() = default;

void PathOutput::limitLength(double maximumLength, bool cutsEdges)
{
  this->Limit = { maximumLength, cutsEdges };
}

void PathOutput::add(const PathAttributes& attributes, const SurfacePath& path, vtkIdType segment)
{
  constexpr std::size_t anyNumber = std::numeric_limits<std::size_t>::max();
  const SurfacePath& added = this->Limit
    ? this->Beginnings.emplace_back(beginningOf(
        attributes.mesh(), path, this->Limit->maximumLength, anyNumber, this->Limit->cutsEdges))
    : path;
  this->Lines.push_back({ attributes, added, this->Size });
  this->Size += this->Lines.back().size();
  this->Segments->InsertNextValue(segment);
}

void PathOutput::allocate()
{
  const auto size = static_cast<vtkIdType>(this->Size);
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ this->Positions,
         this->ArcLengths, this->OriginalPointIds, this->EdgePointIds, this->Normals })
  {
    array->SetNumberOfTuples(size);
  }
  if (this->NamesBlocks)
  {
    this->OriginalBlocks->SetNumberOfTuples(size);
    this->EdgeBlocks->SetNumberOfTuples(size);
  }
  this->Lengths->SetNumberOfTuples(static_cast<vtkIdType>(this->Lines.size()));
}

double PathOutput::write(const Line& line, SurfaceNormals& normals)
{
  const PathAttributes& attributes = line.attributes;
  double length = 0.0;
  Vector3 before;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const auto at = static_cast<vtkIdType>(line.start + i);
    const PathPoint& point = line.path[std::min(i, line.path.size() - 1)];
    const Vector3 position = point.position(attributes.mesh());
    length += i > 0 ? norm(position - before) : 0.0;
    before = position;
    const Vector3 normal = normals.at(point);
    const Vector3 raised = position + this->HeightOffset * normal;
    this->Positions->SetTypedTuple(at, std::array{ raised.x, raised.y, raised.z }.data());
    this->Normals->SetTypedTuple(at, std::array{ normal.x, normal.y, normal.z }.data());
    this->ArcLengths->SetValue(at, length);
    const auto [first, second] = nearestCarriers(point);
    const std::array ids{ attributes.idOf(first), attributes.idOf(second) };
    this->OriginalPointIds->SetValue(at, ids[0]);
    this->EdgePointIds->SetTypedTuple(at, ids.data());
    if (this->NamesBlocks)
    {
      const std::array blocks{ attributes.blockOf(first), attributes.blockOf(second) };
      this->OriginalBlocks->SetValue(at, blocks[0]);
      this->EdgeBlocks->SetTypedTuple(at, blocks.data());
    }
  }
  return length;
}

PathOutput::NormalsOfMesh PathOutput::normalsOfMany() const
{
  // To find the triangles round one vertex takes as long as to go through so many of all.
  constexpr std::size_t many = 8;
  std::map<const PathAttributes*, std::size_t> sizes;
  for (const Line& line : this->Lines)
  {
    sizes[&line.attributes] += line.size();
  }
  NormalsOfMesh made;
  for (const auto& [attributes, size] : sizes)
  {
    if (many * size >= attributes->mesh().numberOfVertices())
    {
      made.emplace(attributes, normalsOf(*attributes)).first->second.makeAll();
    }
  }
  return made;
}

void PathOutput::addLengths(bool isChain)
{
  for (std::size_t i = 0; i < this->Lines.size(); ++i)
  {
    if (isChain)
    {
      double* const arcLengths =
        this->ArcLengths->GetPointer(static_cast<vtkIdType>(this->Lines[i].start));
      std::for_each(arcLengths, arcLengths + this->Lines[i].size(),
        [&](double& arcLength) { arcLength += this->TotalLength; });
    }
    this->TotalLength += this->Lengths->GetValue(static_cast<vtkIdType>(i));
  }
}

void PathOutput::writePoints(const ThreadTeam& team)
{
  NormalsOfMesh ofMany = this->normalsOfMany();
  team.run(this->Size,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      const PathAttributes* attributes = nullptr;
      std::optional<SurfaceNormals> own;
      for (auto line = std::ranges::lower_bound(this->Lines, first, {}, &Line::start);
           line != this->Lines.end() && line->start < last; ++line)
      {
        Interruption::check();
        const auto known = ofMany.find(&line->attributes);
        if (known == ofMany.end() && attributes != &line->attributes)
        {
          attributes = &line->attributes;
          own.emplace(normalsOf(*attributes));
        }
        this->Lengths->SetValue(line - this->Lines.begin(),
          this->write(*line, known == ofMany.end() ? *own : known->second));
      }
    });
}

bool PathOutput::writeTo(vtkPolyData* output, bool isChain, const ThreadTeam& team)
{
  output->Initialize();
  this->allocate();
  try
  {
    this->writePoints(team);
  }
  catch (const Interrupted&)
  {
    return false;
  }
  this->addLengths(isChain);
  vtkNew<vtkPoints> points;
  points->SetData(this->Positions);
  vtkNew<vtkCellArray> lines;
  lines->AllocateExact(
    static_cast<vtkIdType>(this->Lines.size()), static_cast<vtkIdType>(this->Size));
  for (const Line& line : this->Lines)
  {
    lines->InsertNextCell(static_cast<int>(line.size()));
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      lines->InsertCellPoint(static_cast<vtkIdType>(line.start + i));
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  vtkPointData* pointData = output->GetPointData();
  pointData->SetScalars(this->ArcLengths);
  pointData->AddArray(this->OriginalPointIds);
  pointData->AddArray(this->EdgePointIds);
  if (this->NamesBlocks)
  {
    pointData->AddArray(this->OriginalBlocks);
    pointData->AddArray(this->EdgeBlocks);
  }
  pointData->SetNormals(this->Normals);
  output->GetCellData()->AddArray(this->Segments);
  output->GetCellData()->AddArray(this->Lengths);
  vtkNew<vtkDoubleArray> total;
  total->SetName("TotalLength");
  total->InsertNextValue(this->TotalLength);
  output->GetFieldData()->AddArray(total);
  return true;
}

}
