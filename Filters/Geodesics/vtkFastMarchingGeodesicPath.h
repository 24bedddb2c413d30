// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFastMarchingGeodesicPath
 * @brief The shortest path over a surface from a point to the nearest of several seeds.
 *
 * A front marches from the seeds until it has reached the begin point, and the path is traced back
 * down the distances. The output is one polyline from the begin point to the seed, with points in
 * double precision. If the begin point is a seed, the polyline has that one point twice, and its
 * length is 0.
 *
 * GetGeodesic() holds the options of the front, and all of them apply to the path: it is the
 * cheapest path through PropagationWeights, it avoids ExclusionPointIds, and a begin point beyond
 * DistanceStopCriterion, or farther than DestinationVertexStopCriterion lets the front go, has no
 * path. The filter GetGeodesic() itself is not run, so its output and its queries stay as they are.
 * While the path is computed, GetGeodesic() invokes IterationEvent, and this filter reports
 * progress; AbortExecute of either filter stops the computation and leaves the output empty.
 *
 * It is an error if there is no path from the begin point to a seed, or if an option cannot be
 * honoured. The message names the value and the limit, and the output is empty.
 *
 * Coincident points are not merged, so a path does not cross between two parts that merely touch.
 *
 * K. Krishnan: Geodesic Computations on Surfaces. The VTK Journal (2013), whose interface this is.
 *
 * @sa vtkFastMarchingGeodesicDistance
 */
#ifndef vtkFastMarchingGeodesicPath_h
#define vtkFastMarchingGeodesicPath_h

#include "vtkFastMarchingGeodesicDistance.h" // For vtkNew<vtkFastMarchingGeodesicDistance>
#include "vtkFiltersGeodesicsModule.h"       // For the export macro
#include "vtkGeodesicPath.h"
#include "vtkGeodesicsABI.h" // For the namespace
#include "vtkNew.h"          // For members

#include <memory>   // For members
#include <optional> // For a path that there may be
#include <vector>   // For the points of a path

namespace geodesic
{
class TriangleMesh;
struct PathPoint;
}

GEODESICS_ABI_BEGIN

class VTKFILTERSGEODESICS_EXPORT vtkFastMarchingGeodesicPath : public vtkGeodesicPath
{
public:
  static vtkFastMarchingGeodesicPath* New();
  vtkGeodesicsTypeMacro(vtkFastMarchingGeodesicPath, vtkGeodesicPath);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The filter whose options apply to the path. It needs no input.
   */
  vtkFastMarchingGeodesicDistance* GetGeodesic() { return this->Geodesic; }

  ///@{
  /**
   * The point id of the input where the path starts. Default: -1, which is an error.
   */
  vtkSetMacro(BeginPointId, vtkIdType);
  vtkGetMacro(BeginPointId, vtkIdType);
  ///@}

  ///@{
  /**
   * The point ids of the input where the path may end. It ends at the one that is nearest along the
   * surface. At least one is required. They are the seeds of GetGeodesic(). Default: null.
   */
  virtual void SetSeeds(vtkIdList* seeds);
  virtual vtkIdList* GetSeeds();
  ///@}

  ///@{
  /**
   * 0: the path runs through points of the input, along edges; without PropagationWeights no other
   * such path to the same seed is shorter. 1: it runs across faces, and each of its points lies on
   * an edge. Default: 1.
   */
  vtkSetClampMacro(InterpolationOrder, int, 0, 1);
  vtkGetMacro(InterpolationOrder, int);
  ///@}

  ///@{
  /**
   * The largest length of the path, in the mesh's unit of length; at least 0. A longer path ends at
   * its last point within this length. Default: VTK_DOUBLE_MAX, unlimited.
   */
  vtkSetMacro(MaximumPathLength, double);
  vtkGetMacro(MaximumPathLength, double);
  ///@}

  ///@{
  /**
   * The largest number of points of the path; at least 1. A path with more points ends after this
   * number. Default: VTK_ID_MAX, unlimited.
   */
  vtkSetMacro(MaximumPathPoints, vtkIdType);
  vtkGetMacro(MaximumPathPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Makes the path locally shortest: straight where the faces that it crosses are laid flat, and no
   * longer than any path along edges to the same seed. An error together with InterpolationOrder 0
   * or with PropagationWeights. Default: off.
   */
  vtkSetMacro(Straighten, bool);
  vtkGetMacro(Straighten, bool);
  vtkBooleanMacro(Straighten, bool);
  ///@}

  /**
   * The length of the polyline, in the mesh's unit of length; 0 before the first run, and if there
   * is no path.
   */
  vtkGetMacro(GeodesicLength, double);

  /**
   * For each point of the path, the nearest point of the input on its edge. Equal ids in a row are
   * listed once. With InterpolationOrder 0 these are the path's points.
   */
  vtkIdList* GetZerothOrderPathPointIds() { return this->ZerothOrderPathPointIds; }

  /**
   * With InterpolationOrder 1, two ids for each point of the path: the ends of the edge that it
   * lies on, the nearer one first. At a point of the input the first id is that point, and the
   * second the other end of any of its edges. Empty with InterpolationOrder 0.
   */
  vtkIdList* GetFirstOrderPathPointIds() { return this->FirstOrderPathPointIds; }

  /**
   * Includes the options of GetGeodesic() with the seeds, so that a list edited in place runs the
   * filter again.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkFastMarchingGeodesicPath();
  ~vtkFastMarchingGeodesicPath() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkNew<vtkFastMarchingGeodesicDistance> Geodesic;
  vtkIdType BeginPointId = -1;
  int InterpolationOrder = 1;
  double MaximumPathLength = VTK_DOUBLE_MAX;
  vtkIdType MaximumPathPoints;
  bool Straighten = false;
  double GeodesicLength = 0.0;
  vtkNew<vtkIdList> ZerothOrderPathPointIds;
  vtkNew<vtkIdList> FirstOrderPathPointIds;

private:
  struct Internals;

  void CheckLimits() const;
  /** Returns the path from the begin point to a seed; none if the run was aborted. */
  std::optional<std::vector<geodesic::PathPoint>> FindPath(vtkPolyData* input);
  void Deliver(const geodesic::TriangleMesh& mesh, const std::vector<geodesic::PathPoint>& path,
    vtkPolyData* output);

  std::unique_ptr<Internals> Internal;

  vtkFastMarchingGeodesicPath(const vtkFastMarchingGeodesicPath&) = delete;
  void operator=(const vtkFastMarchingGeodesicPath&) = delete;
};

GEODESICS_ABI_END

#endif
