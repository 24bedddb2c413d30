// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPolyDataGeodesicDistance
 * @brief Base of the filters that compute geodesic distances from seeds on a vtkPolyData.
 *
 * Part of the interface of the article "Geodesic Computations on Surfaces" (K. Krishnan, The VTK
 * Journal, 2013). Code that forward declares this class includes this header instead: the class
 * lives in an inline namespace (see vtkGeodesicsABI.h), and a declaration outside of it would be
 * ambiguous.
 *
 * The output is the input passed through, together with one point array of distances, which becomes
 * the active scalars if the input has none. The input is never modified, even where it already has
 * an array of that name. Distances are in the mesh's unit of length.
 *
 * @sa vtkFastMarchingGeodesicDistance
 */
#ifndef vtkPolyDataGeodesicDistance_h
#define vtkPolyDataGeodesicDistance_h

#include "vtkFiltersGeodesicsModule.h" // For the export macro
#include "vtkGeodesicsABI.h"           // For the namespace
#include "vtkIdList.h"                 // For vtkSmartPointer<vtkIdList>
#include "vtkIdListWatch.h"            // For members
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For members

#include <string> // For members

GEODESICS_ABI_BEGIN

class VTKFILTERSGEODESICS_EXPORT vtkPolyDataGeodesicDistance : public vtkPolyDataAlgorithm
{
public:
  vtkGeodesicsTypeMacro(vtkPolyDataGeodesicDistance, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The point ids of the input that have distance 0. At least one is required, and an id outside
   * the input is an error that names it. Default: null.
   */
  virtual void SetSeeds(vtkIdList* seeds);
  vtkGetSmartPointerMacro(Seeds, vtkIdList);
  ///@}

  ///@{
  /**
   * The name of the output's point array of distances. Null or empty: no array is made, which
   * suits callers that only want the path or the queries. Default: null.
   */
  virtual void SetFieldDataName(const char* name);
  virtual const char* GetFieldDataName();
  ///@}

  /**
   * Includes the options that are objects, so that an id list edited in place runs the filter
   * again. A data array counts by its own modification time, so call its Modified() after editing
   * it.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkPolyDataGeodesicDistance() = default;
  ~vtkPolyDataGeodesicDistance() override = default;

  vtkSmartPointer<vtkIdList> Seeds;
  std::string FieldDataName;
  vtkIdListWatch SeedsWatch;

private:
  vtkPolyDataGeodesicDistance(const vtkPolyDataGeodesicDistance&) = delete;
  void operator=(const vtkPolyDataGeodesicDistance&) = delete;
};

GEODESICS_ABI_END

#endif
