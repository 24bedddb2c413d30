// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/PolyDataTriangles.h"

#include "base/Interruption.h"
#include "filter/VtkVersions.h"
#include "mesh/TriangleMesh.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>

namespace geodesic::bridge
{
namespace
{

struct CopyCoordinates
{
  template <class Array>
  void operator()(Array* array, Vector3* points) const
  {
    for (const auto tuple : vtk::DataArrayTupleRange<3>(array))
    {
      *points++ = { static_cast<double>(tuple[0]), static_cast<double>(tuple[1]),
        static_cast<double>(tuple[2]) };
    }
  }
};

/** Cuts polygons and strips into triangles. */
class Triangulator
{
public:
  Triangulator(std::span<const Vector3> points, std::vector<Triangle>& triangles)
    : Points(points)
    , Triangles(triangles)
  {
  }

  void addPolygon(std::span<const Index> corners)
  {
    if (corners.size() == 3)
    {
      this->Triangles.push_back({ corners[0], corners[1], corners[2] });
      return;
    }
    this->Corners.clear();
    std::unique_copy(corners.begin(), corners.end(), std::back_inserter(this->Corners));
    while (this->Corners.size() > 1 && this->Corners.front() == this->Corners.back())
    {
      this->Corners.pop_back();
    }
    if (this->Corners.size() == 4)
    {
      this->addQuadrilateral();
    }
    else if (this->Corners.size() <= 4 || !this->addByVTK())
    {
      this->addFan();
    }
  }

  void addStrip(std::span<const Index> corners)
  {
    for (std::size_t i = 2; i < corners.size(); ++i)
    {
      this->Triangles.push_back({ corners[i - 2], corners[i - 1], corners[i] });
    }
  }

private:
  /**
   * Positive if the diagonal from corner i to i + 2 has the other two corners on different sides,
   * so that it lies inside the quadrilateral.
   */
  double innerness(int i) const
  {
    const Vector3 diagonal = this->at(i + 2) - this->at(i);
    const Vector3 left = cross(this->at(i + 1) - this->at(i), diagonal);
    const Vector3 right = cross(diagonal, this->at(i + 3) - this->at(i));
    return dot(left, right);
  }

  /**
   * Whether the diagonal from corner 0 is the shorter one. If both are equally long, the one that
   * ends at the corner with the smallest coordinates is taken. So the choice does not depend on
   * which corner comes first, which can differ between the pieces of a grid on several ranks.
   */
  bool isFirstDiagonalBetter() const
  {
    const double first = norm(this->at(2) - this->at(0));
    const double second = norm(this->at(3) - this->at(1));
    if (first != second)
    {
      return first < second;
    }
    const auto leastOf = [this](int a, int b)
    {
      const auto coordinates = [this](int i)
      {
        const Vector3& p = this->at(i);
        return std::tuple(p.x, p.y, p.z);
      };
      return std::min(coordinates(a), coordinates(b));
    };
    return leastOf(0, 2) < leastOf(1, 3);
  }

  const Vector3& at(int i) const { return this->Points[this->Corners[i % 4]]; }

  void addQuadrilateral()
  {
    const bool isFirstInside = this->innerness(0) > 0.0;
    const bool isSecondInside = this->innerness(1) > 0.0;
    const bool takesFirst =
      isFirstInside == isSecondInside ? this->isFirstDiagonalBetter() : isFirstInside;
    const auto& c = this->Corners;
    if (takesFirst)
    {
      this->Triangles.insert(this->Triangles.end(), { { c[0], c[1], c[2] }, { c[0], c[2], c[3] } });
    }
    else
    {
      this->Triangles.insert(this->Triangles.end(), { { c[0], c[1], c[3] }, { c[1], c[2], c[3] } });
    }
  }

  bool addByVTK()
  {
    const vtkIdType size = static_cast<vtkIdType>(this->Corners.size());
    this->Polygon->PointIds->SetNumberOfIds(size);
    this->Polygon->Points->SetNumberOfPoints(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const Vector3& p = this->Points[this->Corners[i]];
      if (!isFinite(p))
      {
        return false;
      }
      this->Polygon->PointIds->SetId(i, i);
      this->Polygon->Points->SetPoint(i, p.x, p.y, p.z);
    }
    if (!triangulate(*this->Polygon, this->Cut))
    {
      return false;
    }
    for (vtkIdType i = 0; i + 2 < this->Cut->GetNumberOfIds(); i += 3)
    {
      this->Triangles.push_back({ this->Corners[this->Cut->GetId(i)],
        this->Corners[this->Cut->GetId(i + 1)], this->Corners[this->Cut->GetId(i + 2)] });
    }
    return true;
  }

  void addFan()
  {
    for (std::size_t i = 2; i < this->Corners.size(); ++i)
    {
      this->Triangles.push_back({ this->Corners[0], this->Corners[i - 1], this->Corners[i] });
    }
  }

  std::span<const Vector3> Points;
  std::vector<Triangle>& Triangles;
  std::vector<Index> Corners;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Cut;
};

/** VTK's vtkPolygon counts corners by an int. */
void checkSize(vtkIdType cell, vtkIdType corners)
{
  constexpr vtkIdType most = std::numeric_limits<int>::max();
  if (corners < 0 || corners > most)
  {
    throw std::length_error("Polygon or strip " + std::to_string(cell) + " of the input has " +
      std::to_string(corners) + " corners; it may have at most " + std::to_string(most) +
      ". Cut it into smaller ones.");
  }
}

/** Calls @p add with the corners of each cell, after checking that they exist. */
template <class Add>
void visitCells(vtkCellArray* cells, std::size_t numberOfPoints, Index firstPoint, const Add& add)
{
  const vtkIdType count = cells->GetNumberOfCells();
  const auto visit = [&](const auto& offsets, const auto& connectivity)
  {
    std::vector<Index> corners;
    for (vtkIdType cell = 0; cell < count; ++cell)
    {
      Interruption::checkAt(static_cast<std::size_t>(cell));
      const auto begin = static_cast<vtkIdType>(offsets[cell]);
      const auto size = static_cast<vtkIdType>(offsets[cell + 1]) - begin;
      checkSize(cell, size);
      corners.resize(static_cast<std::size_t>(size));
      for (vtkIdType i = 0; i < size; ++i)
      {
        const auto id = static_cast<vtkIdType>(connectivity[begin + i]);
        if (id < 0 || static_cast<std::size_t>(id) >= numberOfPoints)
        {
          throw std::invalid_argument("A cell of the input uses point " + std::to_string(id) +
            ", but the input has " + std::to_string(numberOfPoints) + " points. Clean the input.");
        }
        corners[static_cast<std::size_t>(i)] = firstPoint + static_cast<Index>(id);
      }
      add(std::span<const Index>(corners));
    }
  };
  withOffsetsAndConnectivity(*cells, visit);
}

}

bool areTrianglesOf(vtkPolyData* surface, const TriangleMesh& mesh, const ThreadTeam& team)
{
  vtkCellArray* cells = surface->GetPolys();
  const Index count = mesh.numberOfTriangles();
  if (cells->GetNumberOfCells() != count ||
    cells->GetNumberOfConnectivityIds() != 3 * vtkIdType{ count } ||
    surface->GetNumberOfStrips() > 0 || surface->GetCellGhostArray() ||
    surface->GetNumberOfPoints() != mesh.numberOfVertices() ||
    mesh.numberOfPoints() != mesh.numberOfVertices())
  {
    return false;
  }
  std::vector<std::uint8_t> areSame(team.numberOfRanges(count), 0);
  const auto compare = [&](const auto& offsets, const auto& connectivity)
  {
    const auto isCorner = [&](vtkIdType place, Index vertex)
    { return static_cast<vtkIdType>(connectivity[place]) == mesh.pointOfVertex(vertex); };
    const auto isSame = [&](Index t)
    {
      const Index source = mesh.sourceOfTriangle(t);
      const vtkIdType first = 3 * vtkIdType{ source };
      const auto [a, b, c] = mesh.triangle(t);
      return source < count && static_cast<vtkIdType>(offsets[t]) == 3 * vtkIdType{ t } &&
        isCorner(first, a) && isCorner(first + 1, b) && isCorner(first + 2, c);
    };
    team.run(count,
      [&](std::size_t range, std::size_t first, std::size_t last)
      {
        auto t = static_cast<Index>(first);
        while (t < last && isSame(t))
        {
          ++t;
        }
        areSame[range] = t == last ? 1 : 0;
      });
  };
  withOffsetsAndConnectivity(*cells, compare);
  return std::find(areSame.begin(), areSame.end(), 0) == areSame.end();
}

void appendPoints(vtkPolyData* surface, BulkVector<Vector3>& points)
{
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  const std::size_t first = points.size();
  if (first + count >= NoIndex)
  {
    throw std::length_error("The input has " + std::to_string(first + count) +
      " points; one process holds at most " + std::to_string(NoIndex - 1) +
      ". Spread it over more ranks.");
  }
  points.resize(first + count);
  if (count > 0)
  {
    vtkDataArray* array = surface->GetPoints()->GetData();
    CopyCoordinates copy;
    using Dispatcher = vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>;
    if (!Dispatcher::Execute(array, copy, points.data() + first))
    {
      copy(array, points.data() + first);
    }
  }
}

void appendTriangles(vtkPolyData* surface, std::span<const Vector3> points, Index firstPoint,
  Index firstCell, SurfaceTriangles& triangles)
{
  vtkUnsignedCharArray* ghosts = surface->GetCellGhostArray();
  const auto isHidden = [&](vtkIdType cell)
  { return ghosts && (ghosts->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL) != 0; };
  Triangulator triangulator(points, triangles.corners);
  // A vtkPolyData numbers its vertices first, then its lines, polygons and strips.
  vtkIdType cell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  const auto noteCell = [&]
  {
    // Nearly always one, for which resize() would take much longer.
    while (triangles.cells.size() < triangles.corners.size())
    {
      triangles.cells.push_back(firstCell + static_cast<Index>(cell));
    }
    ++cell;
  };
  const auto numberOfPoints = static_cast<std::size_t>(surface->GetNumberOfPoints());
  visitCells(surface->GetPolys(), numberOfPoints, firstPoint,
    [&](std::span<const Index> corners)
    {
      if (!isHidden(cell))
      {
        triangulator.addPolygon(corners);
        triangles.areCutByPositions = triangles.areCutByPositions || corners.size() > 3;
      }
      noteCell();
    });
  visitCells(surface->GetStrips(), numberOfPoints, firstPoint,
    [&](std::span<const Index> corners)
    {
      if (!isHidden(cell))
      {
        triangulator.addStrip(corners);
      }
      noteCell();
    });
}

}
