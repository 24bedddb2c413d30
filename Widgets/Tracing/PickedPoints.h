// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PickedPoints_h
#define geodesic_bridge_PickedPoints_h

#include "PickedSurface.h"

#include "vtkWeakPointer.h"

#include <array>
#include <map>
#include <memory>
#include <vector>

class vtkContourRepresentation;
class vtkPolyData;
class vtkPolyDataCollection;

namespace geodesic::bridge
{

/** A point of a surface that a node of a contour stands for. */
struct PickedPoint
{
  /** Null where it is not known. */
  vtkPolyData* surface = nullptr;
  vtkIdType id = -1;
};

/**
 * Finds the points that were picked, and keeps the surfaces that they are on.
 *
 * The placer takes all places within 0.022 units of length for one and keeps a record of the last.
 * On a small surface a node's record is soon another's, or gone; so what it said is remembered.
 */
class PickedPoints
{
public:
  /**
   * @param polys the surfaces that count; empty: all
   * @return what the placer knows about a node of a contour, or knew when the node was last there
   * @throws std::invalid_argument for a surface without faces
   */
  PickedPoint at(vtkContourRepresentation* contour, int node, vtkPolyDataCollection* polys);

  /** @throws as at */
  PickedSurface& surfaceOf(vtkPolyData* input);

  /** To be called after an exception, which leaves solvers undefined. */
  void forgetSurfaces() { this->Known.clear(); }

private:
  using Position = std::array<double, 3>;
  struct Memory
  {
    vtkWeakPointer<vtkPolyData> surface;
    vtkIdType id;
  };

  void remember(const Position& position, const PickedPoint& point);
  PickedPoint nearestTo(const Vector3& position, const std::vector<vtkPolyData*>& surfaces);

  struct KnownSurface
  {
    vtkWeakPointer<vtkPolyData> input;
    std::unique_ptr<PickedSurface> surface;
  };
  std::vector<KnownSurface> Known;
  std::map<Position, Memory> Memories;
};

}

#endif
