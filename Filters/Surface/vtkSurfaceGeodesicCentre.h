// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceGeodesicCentre
 * @brief The centre and the diameter of each part of a surface, among its points.
 *
 * The filter behind ParaView's proxy GeodesicCentre. The centre of a part is the point whose
 * largest distance to the part's other points is least; that distance is the radius. The diameter
 * is the largest distance of two points. Both are found by bounds from a few fields, not by all
 * pairs.
 *
 * The output is a vtkPolyData with three vertex cells for each part, whose points are the centre
 * and the two points that are farthest apart. Point arrays: Part, from 0; Role, 0 for the centre, 1
 * and 2 for the other two; OriginalPointIds, and OriginalBlocks where ids are not unique; and, the
 * same at all three points, Radius, LeastRadius, Diameter, MostDiameter and NumberOfFields. The
 * true radius lies between LeastRadius and Radius, and the true diameter between Diameter and
 * MostDiameter, as far as the distances of Method are right.
 *
 * Requests that can't be served empty the output: a RelativeError below 0, no field, a surface on
 * several ranks, and what vtkSurfaceGeodesicFilter names. Costs and barriers are not offered.
 */
#ifndef vtkSurfaceGeodesicCentre_h
#define vtkSurfaceGeodesicCentre_h

#include "vtkSurfaceGeodesicFilter.h"

#include <memory> // For members

class VTKFILTERSSURFACEGEODESICS_EXPORT vtkSurfaceGeodesicCentre : public vtkSurfaceGeodesicFilter
{
public:
  static vtkSurfaceGeodesicCentre* New();
  vtkTypeMacro(vtkSurfaceGeodesicCentre, vtkSurfaceGeodesicFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * A part is done when the bounds of its radius and of its diameter differ by this part of
   * themselves at most. At least 0. Default: 0.01.
   */
  vtkSetMacro(RelativeError, double);
  vtkGetMacro(RelativeError, double);
  ///@}

  ///@{
  /**
   * The most fields for a part. Where they do not suffice, as on a sphere, whose points are all
   * alike, the bounds stay farther apart. At least 1. Default: 100.
   */
  vtkSetMacro(MaximumNumberOfFields, vtkIdType);
  vtkGetMacro(MaximumNumberOfFields, vtkIdType);
  ///@}

  ///@{
  /**
   * Of the last run: how many parts the surface has, and the largest difference of the bounds of a
   * part's radius or diameter, in parts of the larger bound.
   */
  vtkGetMacro(NumberOfParts, vtkIdType);
  vtkGetMacro(LargestError, double);
  ///@}

protected:
  vtkSurfaceGeodesicCentre();
  ~vtkSurfaceGeodesicCentre() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(geodesic::distributed::RankGroup& ranks, const geodesic::bridge::InputBlocks& blocks,
    vtkInformationVector** inputVector, vtkDataObject* output) override;
  void DescribeRequest(std::vector<double>& numbers) override;
  void Forget() override;

  double RelativeError = 0.01;
  vtkIdType MaximumNumberOfFields = 100;
  vtkIdType NumberOfParts = 0;
  double LargestError = 0.0;

private:
  struct Internals;

  /** Searches the surface, of which all is on this rank. */
  void Search(const geodesic::bridge::InputBlocks& blocks, vtkDataObject* output);

  std::unique_ptr<Internals> Internal;

  vtkSurfaceGeodesicCentre(const vtkSurfaceGeodesicCentre&) = delete;
  void operator=(const vtkSurfaceGeodesicCentre&) = delete;
};

#endif
