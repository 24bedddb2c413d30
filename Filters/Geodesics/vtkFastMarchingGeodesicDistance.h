// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFastMarchingGeodesicDistance
 * @brief Geodesic distance from seed points on a surface, by fast marching.
 *
 * Solves the eikonal equation |grad d| = F with d = 0 at the seeds, on the triangles, polygons and
 * strips of the input, in double precision. F is the propagation weight, a cost per unit of length,
 * 1 if none is given.
 *
 * Coincident points are not merged, so a front does not cross between two parts that merely touch.
 *
 * The march stops early at DistanceStopCriterion or DestinationVertexStopCriterion, whichever comes
 * first. ExclusionPointIds confine it. Progress events and AbortExecute work as in any filter.
 *
 * An option that cannot be honoured is an error that names the value and the limit; the output is
 * then empty.
 *
 * R. Kimmel, J. Sethian: Computing geodesic paths on manifolds. PNAS 95 (1998).
 * K. Krishnan: Geodesic Computations on Surfaces. The VTK Journal (2013), whose interface this is.
 */
#ifndef vtkFastMarchingGeodesicDistance_h
#define vtkFastMarchingGeodesicDistance_h

#include "vtkDataArray.h" // For vtkSmartPointer<vtkDataArray>
#include "vtkPolyDataGeodesicDistance.h"

#include <memory> // For members

namespace geodesic
{
class DistanceField;
class TriangleMesh;
}

GEODESICS_ABI_BEGIN

class VTKFILTERSGEODESICS_EXPORT vtkFastMarchingGeodesicDistance
  : public vtkPolyDataGeodesicDistance
{
public:
  static vtkFastMarchingGeodesicDistance* New();
  vtkGeodesicsTypeMacro(vtkFastMarchingGeodesicDistance, vtkPolyDataGeodesicDistance);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    IterationEvent = 10590
  };

  enum DestinationStopModes
  {
    ANY_DESTINATION,
    ALL_DESTINATIONS
  };

  /**
   * The largest final distance of the last run, in the mesh's unit of length; 0 before the first.
   */
  vtkGetMacro(MaximumDistance, double);

  /**
   * The number of points with a final distance in the last run; 0 before the first.
   */
  vtkGetMacro(NumberOfVisitedPoints, vtkIdType);

  ///@{
  /**
   * The value in the array at points without a distance. Default: -1.
   */
  vtkSetMacro(NotVisitedValue, double);
  vtkGetMacro(NotVisitedValue, double);
  ///@}

  ///@{
  /**
   * No point farther than this gets a distance, and every nearer point gets its final one. In the
   * mesh's unit of length; negative: no limit. Default: -1.
   */
  vtkSetMacro(DistanceStopCriterion, double);
  vtkGetMacro(DistanceStopCriterion, double);
  ///@}

  ///@{
  /**
   * Point ids of the input. The march stops once their distances are final. Null or empty: no such
   * stop. Default: null.
   */
  virtual void SetDestinationVertexStopCriterion(vtkIdList* pointIds);
  vtkGetSmartPointerMacro(DestinationVertexStopCriterion, vtkIdList);
  ///@}

  ///@{
  /**
   * Whether any one or all of the destinations must be final for the march to stop. Default:
   * ANY_DESTINATION.
   */
  vtkSetClampMacro(DestinationStopMode, int, ANY_DESTINATION, ALL_DESTINATIONS);
  vtkGetMacro(DestinationStopMode, int);
  void SetDestinationStopModeToAny() { this->SetDestinationStopMode(ANY_DESTINATION); }
  void SetDestinationStopModeToAll() { this->SetDestinationStopMode(ALL_DESTINATIONS); }
  ///@}

  ///@{
  /**
   * Point ids of the input that the front never enters: a closed loop of them confines it. A seed
   * among them is an error. Null or empty: none. Default: null.
   */
  virtual void SetExclusionPointIds(vtkIdList* pointIds);
  vtkGetSmartPointerMacro(ExclusionPointIds, vtkIdList);
  ///@}

  ///@{
  /**
   * The cost of a unit of length at each point, the F above: an array of any numeric type, of one
   * component and one tuple a point. A weight of 2 everywhere doubles every distance. A wrong size,
   * zero, a negative value, NaN or infinity is an error that names the first bad point. Null: 1
   * everywhere. Default: null.
   */
  virtual void SetPropagationWeights(vtkDataArray* weights);
  vtkGetSmartPointerMacro(PropagationWeights, vtkDataArray);
  ///@}

  ///@{
  /**
   * IterationEvent is invoked each time this many points were taken from the queue; at least 1.
   * Default: 100.
   */
  vtkSetClampMacro(IterationEventResolution, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(IterationEventResolution, vtkIdType);
  ///@}

  ///@{
  /**
   * The name of an output point array with, for each point, the index of its nearest seed in Seeds,
   * and -1 at points without a distance. Null or empty: no such array. Default: null.
   */
  virtual void SetNearestSeedArrayName(const char* name);
  virtual const char* GetNearestSeedArrayName();
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkFastMarchingGeodesicDistance();
  ~vtkFastMarchingGeodesicDistance() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double MaximumDistance = 0.0;
  vtkIdType NumberOfVisitedPoints = 0;
  double NotVisitedValue = -1.0;
  double DistanceStopCriterion = -1.0;
  vtkSmartPointer<vtkIdList> DestinationVertexStopCriterion;
  int DestinationStopMode = ANY_DESTINATION;
  vtkSmartPointer<vtkIdList> ExclusionPointIds;
  vtkIdListWatch DestinationsWatch;
  vtkIdListWatch ExclusionWatch;
  vtkSmartPointer<vtkDataArray> PropagationWeights;
  vtkIdType IterationEventResolution = 100;
  std::string NearestSeedArrayName;

private:
  struct Internals;
  void AttachArrays(const geodesic::TriangleMesh& mesh, const geodesic::DistanceField& field,
    vtkPolyData* output) const;

  std::unique_ptr<Internals> Internal;

  vtkFastMarchingGeodesicDistance(const vtkFastMarchingGeodesicDistance&) = delete;
  void operator=(const vtkFastMarchingGeodesicDistance&) = delete;
};

GEODESICS_ABI_END

#endif
