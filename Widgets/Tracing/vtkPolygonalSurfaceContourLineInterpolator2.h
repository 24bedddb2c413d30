// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPolygonalSurfaceContourLineInterpolator2
 * @brief Geodesic lines between the nodes of a contour that is drawn on surfaces.
 *
 * A drop-in for VTK's vtkPolygonalSurfaceContourLineInterpolator, for a contour representation
 * whose placer is a vtkPolygonalSurfacePointPlacer: it joins every two consecutive nodes by the
 * shortest path over the surface, found by Dijkstra's algorithm along edges or by fast marching.
 * The placer's record of a picked node gives the surface and the point; nothing is picked again.
 * The line runs between the points of the surface (the corners of the picked faces) that are
 * nearest to the two nodes.
 *
 * There may be several surfaces. GetPolys() lists those that lines may be drawn on. If it is empty,
 * lines may be drawn on all surfaces that the placer picks on. There is no line, and no error,
 * between nodes on different surfaces or on parts that are not connected, or if the placer knows
 * nothing about a node.
 *
 * The structure of a surface is built for its first line and kept while its points and cells stay
 * the same. A line then costs one march, which stops at the line's end. If a node moves, only the
 * two lines beside it are traced again.
 *
 * Changed options apply to the lines that are traced afterwards. To trace all lines of a contour
 * again, call Modified() of its placer; the next rendering does it.
 *
 * K. Krishnan: Geodesic Computations on Surfaces. The VTK Journal (2013), whose interface this is.
 *
 * @sa vtkFastMarchingGeodesicPath vtkContourWidget vtkPolygonalSurfacePointPlacer
 */
#ifndef vtkPolygonalSurfaceContourLineInterpolator2_h
#define vtkPolygonalSurfaceContourLineInterpolator2_h

#include "vtkGeodesicsABI.h" // For the namespace
#include "vtkPolyDataContourLineInterpolator.h"
#include "vtkWidgetsTracingModule.h" // For the export macro

#include <memory> // For members

class vtkIdList;

// The namespaces are nested because the wrapping tools of VTK 9.1 can't read geodesic::bridge.
namespace geodesic
{
namespace bridge
{
class PickedPoints;
}
}

GEODESICS_ABI_BEGIN

class VTKWIDGETSTRACING_EXPORT vtkPolygonalSurfaceContourLineInterpolator2
  : public vtkPolyDataContourLineInterpolator
{
public:
  static vtkPolygonalSurfaceContourLineInterpolator2* New();
  vtkGeodesicsTypeMacro(
    vtkPolygonalSurfaceContourLineInterpolator2, vtkPolyDataContourLineInterpolator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum GeodesicMethodType
  {
    DijkstraMethod = 0,
    FastMarchingMethod = 1
  };

  ///@{
  /**
   * How lines are found. Default: DijkstraMethod.
   */
  vtkSetClampMacro(GeodesicMethod, int, DijkstraMethod, FastMarchingMethod);
  vtkGetMacro(GeodesicMethod, int);
  void SetGeodesicMethodToDijkstra() { this->SetGeodesicMethod(DijkstraMethod); }
  void SetGeodesicMethodToFastMarching() { this->SetGeodesicMethod(FastMarchingMethod); }
  ///@}

  ///@{
  /**
   * 0: lines run through points of the surface, along edges. 1: they run across faces, and are made
   * locally shortest; each of their points lies on an edge. 1 needs FastMarchingMethod: Dijkstra's
   * lines always run along edges. Default: 0.
   */
  vtkSetClampMacro(InterpolationOrder, int, 0, 1);
  vtkGetMacro(InterpolationOrder, int);
  ///@}

  ///@{
  /**
   * Raises lines by this length, in the surface's unit, along its point normals, whose lengths do
   * not matter. If the surface has none, the normal of a point is the mean of the normals of its
   * faces, weighted by area. The placer has its own offset for the nodes. Default: 0.
   */
  vtkSetMacro(DistanceOffset, double);
  vtkGetMacro(DistanceOffset, double);
  ///@}

  /**
   * Adds the points of the line from node idx1 to node idx2, with its ends, as intermediate points
   * after idx1. Each has the id of the surface's nearest point on its edge. Sets PointId of both
   * nodes, to -1 if it is not known.
   * @return 1 if there is a line, otherwise 0. A surface without faces is reported as an error.
   */
  int InterpolateLine(
    vtkRenderer* renderer, vtkContourRepresentation* rep, int idx1, int idx2) override;

  /**
   * Returns 0, because no node is moved.
   */
  int UpdateNode(
    vtkRenderer* renderer, vtkContourRepresentation* rep, double* node, int idx) override;

  /**
   * The lines that depend on a node: the one that ends there and the one that begins there.
   */
  void GetSpan(int nodeIndex, vtkIntArray* nodeIndices, vtkContourRepresentation* rep) override;

  /**
   * Lists for each node the id of its point, -1 if it is not known, followed by the ids of the
   * intermediate points of the line that begins there.
   */
  void GetContourPointIds(vtkContourRepresentation* rep, vtkIdList* ids);

protected:
  vtkPolygonalSurfaceContourLineInterpolator2();
  ~vtkPolygonalSurfaceContourLineInterpolator2() override;

  int GeodesicMethod = DijkstraMethod;
  int InterpolationOrder = 0;
  double DistanceOffset = 0.0;

private:
  void NoteNode(vtkContourRepresentation* rep, int idx);

  std::unique_ptr<geodesic::bridge::PickedPoints> Picked;

  vtkPolygonalSurfaceContourLineInterpolator2(
    const vtkPolygonalSurfaceContourLineInterpolator2&) = delete;
  void operator=(const vtkPolygonalSurfaceContourLineInterpolator2&) = delete;
};

GEODESICS_ABI_END

#endif
