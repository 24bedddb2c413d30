// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolygonalSurfaceContourLineInterpolator2.h"

#include "vtkContourRepresentation.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "PickedPoints.h"
#include "filter/ErrorMessage.h"
#include "output/SurfaceNormals.h"

#include <algorithm>

using geodesic::PathOrder;
using geodesic::PathPoint;
using geodesic::Vector3;
using geodesic::bridge::PickedPoint;
using geodesic::bridge::PickedSurface;

namespace
{

/** Returns the id of the vertex that is nearest to a point of a path. */
vtkIdType nearestIdOf(const geodesic::TriangleMesh& mesh, const PathPoint& point)
{
  const geodesic::Carriers carriers = point.carriers();
  const auto weighsLess = [&](geodesic::Index a, geodesic::Index b)
  { return weightOf(point, a) < weightOf(point, b); };
  return mesh.pointOfVertex(*std::max_element(carriers.begin(), carriers.end(), weighsLess));
}

}

vtkStandardNewMacro(vtkPolygonalSurfaceContourLineInterpolator2);

//------------------------------------------------------------------------------
vtkPolygonalSurfaceContourLineInterpolator2::vtkPolygonalSurfaceContourLineInterpolator2()
  : Picked(std::make_unique<geodesic::bridge::PickedPoints>())
{
}

//------------------------------------------------------------------------------
vtkPolygonalSurfaceContourLineInterpolator2::~vtkPolygonalSurfaceContourLineInterpolator2() =
  default;

//------------------------------------------------------------------------------
int vtkPolygonalSurfaceContourLineInterpolator2::InterpolateLine(
  vtkRenderer* vtkNotUsed(renderer), vtkContourRepresentation* rep, int idx1, int idx2)
{
  if (!rep)
  {
    vtkErrorMacro(
      << "InterpolateLine has no contour representation to draw the line in; give one.");
    return 0;
  }
  vtkContourRepresentationNode* beginNode = rep->GetNthNode(idx1);
  vtkContourRepresentationNode* endNode = rep->GetNthNode(idx2);
  if (!beginNode || !endNode)
  {
    return 0;
  }
  try
  {
    const PickedPoint begin = this->Picked->at(rep, idx1, this->Polys);
    const PickedPoint end = this->Picked->at(rep, idx2, this->Polys);
    beginNode->PointId = begin.id;
    endNode->PointId = end.id;
    if (!begin.surface || begin.surface != end.surface)
    {
      return 0;
    }
    PickedSurface& surface = this->Picked->surfaceOf(begin.surface);
    const geodesic::SolverTraits& method = geodesic::solverOfInterpolator(this->GeodesicMethod);
    const auto path = surface.path(begin.id, end.id, method,
      method.crossesFaces && this->InterpolationOrder == 1 ? PathOrder::Edges
                                                           : PathOrder::Vertices);
    if (!path)
    {
      return 0;
    }
    geodesic::bridge::SurfaceNormals normals(
      surface.mesh(), begin.surface->GetPointData()->GetNormals());
    for (const PathPoint& point : *path)
    {
      Vector3 p = point.position(surface.mesh());
      if (this->DistanceOffset != 0.0)
      {
        p = p + this->DistanceOffset * normals.at(point);
      }
      double position[3] = { p.x, p.y, p.z };
      rep->AddIntermediatePointWorldPosition(idx1, position, nearestIdOf(surface.mesh(), point));
    }
    return 1;
  }
  catch (const std::exception& error)
  {
    this->Picked->forgetSurfaces();
    vtkErrorMacro(<< geodesic::bridge::messageOf(error));
    return 0;
  }
}

//------------------------------------------------------------------------------
int vtkPolygonalSurfaceContourLineInterpolator2::UpdateNode(vtkRenderer* vtkNotUsed(renderer),
  vtkContourRepresentation* rep, double* vtkNotUsed(node), int idx)
{
  if (rep)
  {
    // VTK does not call this for the first node, so it is noted together with the second.
    for (int known = idx == 1 ? 0 : idx; known <= idx; ++known)
    {
      this->NoteNode(rep, known);
    }
  }
  return 0;
}

//------------------------------------------------------------------------------
void vtkPolygonalSurfaceContourLineInterpolator2::NoteNode(vtkContourRepresentation* rep, int idx)
{
  try
  {
    this->Picked->at(rep, idx, this->Polys);
  }
  catch (const std::exception& error)
  {
    this->Picked->forgetSurfaces();
    vtkErrorMacro(<< geodesic::bridge::messageOf(error));
  }
}

//------------------------------------------------------------------------------
void vtkPolygonalSurfaceContourLineInterpolator2::GetSpan(
  int nodeIndex, vtkIntArray* nodeIndices, vtkContourRepresentation* rep)
{
  if (!rep || !nodeIndices)
  {
    vtkErrorMacro(<< "GetSpan needs a contour representation, and an array to fill; give both.");
    return;
  }
  // The representation calls this when it has just placed or moved a node, whose record the placer
  // still has.
  this->NoteNode(rep, nodeIndex);
  nodeIndices->Initialize();
  nodeIndices->SetNumberOfComponents(2);
  const int count = rep->GetNumberOfNodes();
  const auto add = [&](int first, int second)
  {
    if (rep->GetClosedLoop() && count > 0)
    {
      first = (first + count) % count;
      second = (second + count) % count;
    }
    if (first != second && rep->GetNthNode(first) && rep->GetNthNode(second))
    {
      const int line[2] = { first, second };
      nodeIndices->InsertNextTypedTuple(line);
    }
  };
  add(nodeIndex - 1, nodeIndex);
  add(nodeIndex, nodeIndex + 1);
}

//------------------------------------------------------------------------------
void vtkPolygonalSurfaceContourLineInterpolator2::GetContourPointIds(
  vtkContourRepresentation* rep, vtkIdList* ids)
{
  if (!rep || !ids)
  {
    vtkErrorMacro(
      << "GetContourPointIds needs a contour representation, and a list to fill; give both.");
    return;
  }
  ids->Reset();
  try
  {
    for (int i = 0; i < rep->GetNumberOfNodes(); ++i)
    {
      // A node's PointId is not set until a line begins or ends there.
      ids->InsertNextId(this->Picked->at(rep, i, this->Polys).id);
      for (const vtkContourRepresentationPoint* point : rep->GetNthNode(i)->Points)
      {
        ids->InsertNextId(point->PointId);
      }
    }
  }
  catch (const std::exception& error)
  {
    this->Picked->forgetSurfaces();
    ids->Reset();
    vtkErrorMacro(<< geodesic::bridge::messageOf(error));
  }
}

//------------------------------------------------------------------------------
void vtkPolygonalSurfaceContourLineInterpolator2::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GeodesicMethod: " << geodesic::solverOfInterpolator(this->GeodesicMethod).name
     << "\n";
  os << indent << "InterpolationOrder: " << this->InterpolationOrder << "\n";
  os << indent << "DistanceOffset: " << this->DistanceOffset << "\n";
}
