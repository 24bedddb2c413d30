// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceGeodesicDistance
 * @brief Geodesic distance on a surface from seed positions in space.
 *
 * The filter behind ParaView's proxy GeodesicDistance. Each seed position is projected to the
 * nearest point of the surface, on a face, an edge or a vertex, and the distance from the nearest
 * seed is computed for every point of the input's triangles, polygons and strips.
 *
 * The output is the input passed through, together with a point array of distances in the mesh's
 * unit of length, which becomes the active scalars. The input is never modified.
 *
 * Errors, which leave the output empty: no seed, a list of seed coordinates whose length is no
 * multiple of 3, a negative MaximumDistance in use, composite input, more than one rank.
 */
#ifndef vtkSurfaceGeodesicDistance_h
#define vtkSurfaceGeodesicDistance_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkFiltersSurfaceGeodesicsModule.h" // For the export macro

#include <memory> // For members
#include <string> // For members
#include <vector> // For members

class vtkPolyData;

class VTKFILTERSSURFACEGEODESICS_EXPORT vtkSurfaceGeodesicDistance : public vtkDataObjectAlgorithm
{
public:
  static vtkSurfaceGeodesicDistance* New();
  vtkTypeMacro(vtkSurfaceGeodesicDistance, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    FAST_MARCHING,
    DIJKSTRA
  };

  enum UnreachedMarks
  {
    UNREACHED_AS_NAN,
    UNREACHED_AS_VALUE
  };

  ///@{
  /**
   * The seed positions, x y z of one after the other, in the input's coordinates. At least one is
   * required. The coordinates can be given one by one, which is how the server manager hands over a
   * list: only so is a length that is no multiple of 3 noticed, and then it is an error. Default:
   * none.
   */
  void ClearSeedPositions();
  void AddSeedPosition(double x, double y, double z);
  void AddSeedCoordinate(double coordinate);
  int GetNumberOfSeedCoordinates();
  double GetSeedCoordinate(int index);
  ///@}

  ///@{
  /**
   * FAST_MARCHING: across the faces. DIJKSTRA: along the edges only, so never too short. Default:
   * FAST_MARCHING.
   */
  vtkSetClampMacro(Method, int, FAST_MARCHING, DIJKSTRA);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * Whether MaximumDistance is in use. Default: off.
   */
  vtkSetMacro(UseMaximumDistance, bool);
  vtkGetMacro(UseMaximumDistance, bool);
  vtkBooleanMacro(UseMaximumDistance, bool);
  ///@}

  ///@{
  /**
   * No point farther than this gets a distance, and every nearer point gets its final one. In the
   * mesh's unit of length, not negative. Default: 1.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * The name of the output's point array of distances. Null or empty: no array is made. Default:
   * GeodesicDistance.
   */
  void SetDistanceArrayName(const char* name);
  const char* GetDistanceArrayName();
  ///@}

  ///@{
  /**
   * What the array holds at points without a distance: NaN or UnreachedValue. Default:
   * UNREACHED_AS_NAN.
   */
  vtkSetClampMacro(UnreachedAs, int, UNREACHED_AS_NAN, UNREACHED_AS_VALUE);
  vtkGetMacro(UnreachedAs, int);
  ///@}

  ///@{
  /**
   * The value at points without a distance, with UNREACHED_AS_VALUE. Default: -1.
   */
  vtkSetMacro(UnreachedValue, double);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  ///@{
  /**
   * On: points of equal coordinates are one point to the front, so that STL files, CAD seams and
   * pieces behave alike; each keeps its tuple. Off: a slit stays a slit. Default: on.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

  /**
   * The largest final distance of the last run, in the mesh's unit of length; 0 before the first.
   */
  vtkGetMacro(MaximumDistanceReached, double);

  /**
   * The number of points with a final distance in the last run; 0 before the first.
   */
  vtkGetMacro(NumberOfVisitedPoints, vtkIdType);

protected:
  vtkSurfaceGeodesicDistance();
  ~vtkSurfaceGeodesicDistance() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::vector<double> SeedCoordinates;
  int Method = FAST_MARCHING;
  bool UseMaximumDistance = false;
  double MaximumDistance = 1.0;
  std::string DistanceArrayName = "GeodesicDistance";
  int UnreachedAs = UNREACHED_AS_NAN;
  double UnreachedValue = -1.0;
  bool MergeCoincidentPoints = true;
  double MaximumDistanceReached = 0.0;
  vtkIdType NumberOfVisitedPoints = 0;

private:
  struct Internals;
  vtkPolyData* GetSurface(vtkInformationVector* inputVector);
  void Solve(vtkPolyData* input);
  void AttachArray(vtkPolyData* output);

  std::unique_ptr<Internals> Internal;

  vtkSurfaceGeodesicDistance(const vtkSurfaceGeodesicDistance&) = delete;
  void operator=(const vtkSurfaceGeodesicDistance&) = delete;
};

#endif
