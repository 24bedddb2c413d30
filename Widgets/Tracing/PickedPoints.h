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

/** The point of a surface at which a node of a contour is. */
struct PickedPoint
{
  /** Null if it is not known. */
  vtkPolyData* surface = nullptr;
  vtkIdType id = -1;
};

/**
 * Finds the points that were picked, and keeps the surfaces that they are on.
 *
 * The placer treats all places within 0.022 units of length as one, and keeps a record of the last
 * only. On a small surface, another node soon takes over a node's record, or the record is gone. So
 * this class remembers what each record said.
 */
class PickedPoints
{
public:
  /**
   * @param polys the surfaces that nodes can be on; all if it is empty
   * @return the point that the placer has recorded for a node of a contour, or had recorded when a
   * node was last there
   * @throws std::invalid_argument if a surface has no faces
   */
  PickedPoint at(vtkContourRepresentation* contour, int node, vtkPolyDataCollection* polys);

  /**
   * Returns the picked surface of an input, which is kept.
   * @throws as at()
   */
  PickedSurface& surfaceOf(vtkPolyData* input);

  /** Must be called after an exception, which leaves solvers undefined. */
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
