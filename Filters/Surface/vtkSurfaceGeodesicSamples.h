// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceGeodesicSamples
 * @brief Points that are evenly spread over a surface: each is as far as can be from those before.
 *
 * The filter behind ParaView's proxy GeodesicSamples. The first samples are the nearest points of
 * the surface to FirstPositions; equal ones count once. Each further sample is the point of the
 * input that is farthest from all samples before, distances being those of the front over the
 * surface with its cost and barriers. Points that are farthest within 1e-9 are ordered by x, y and
 * z. A point that no sample reaches is farther than all others: each part of the surface gets a
 * sample before any gets a second one, and without first positions the sample 0 is the point with
 * the smallest x.
 *
 * Output port SAMPLES_PORT has a vtkPolyData with a vertex cell for each sample, in the order in
 * which they were taken, and the point arrays
 * - GeodesicDistance, the scalars: how far the sample was from the nearest of those before it when
 *   it was taken; -1 for the first positions, and for the first sample of a part.
 * - OriginalPointIds: the id of the input's point; -1 for first positions that are not at one.
 * - OriginalBlocks, if ids do not identify a point without its block.
 * - OriginalRanks, on several ranks.
 * On several ranks the first one has the samples.
 *
 * Output port REGIONS_PORT has the surface, in the structure of the input, with the point arrays
 * NearestSeed, the number of the nearest sample (-1 where none gets to), and GeodesicDistance from
 * it (-1 there).
 *
 * Requests that can't be served empty the outputs: a spacing below 0, neither a spacing nor a
 * number, more samples than points, more first positions than samples, a first position on a
 * barrier, and what vtkSurfaceGeodesicFilter names.
 */
#ifndef vtkSurfaceGeodesicSamples_h
#define vtkSurfaceGeodesicSamples_h

#include "vtkSurfaceGeodesicFilter.h"

#include <memory> // For members
#include <vector> // For members

namespace geodesic
{
struct Sampling;
}

class VTKFILTERSSURFACEGEODESICS_EXPORT vtkSurfaceGeodesicSamples : public vtkSurfaceGeodesicFilter
{
public:
  static vtkSurfaceGeodesicSamples* New();
  vtkTypeMacro(vtkSurfaceGeodesicSamples, vtkSurfaceGeodesicFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OutputPorts
  {
    SAMPLES_PORT,
    REGIONS_PORT
  };

  ///@{
  /**
   * How many samples to take, the first positions included; at most as many as there are points.
   * Has no use while Spacing is above 0. Default: 100.
   */
  vtkSetMacro(NumberOfSamples, vtkIdType);
  vtkGetMacro(NumberOfSamples, vtkIdType);
  ///@}

  ///@{
  /**
   * Above 0: samples are taken until no point of the surface is farther than this from one, however
   * many that takes. 0: NumberOfSamples decides. Default: 0.
   */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Samples that are there before any other, x y z of each in turn, in the input's coordinates.
   * Default: none.
   */
  void ClearFirstPositions();
  void AddFirstCoordinate(double coordinate);
  ///@}

  ///@{
  /**
   * Of the last run: how many samples there are, and the largest distance of a point from one,
   * without the parts that have no sample; how many points have none that reaches them. Points with
   * neither an open triangle nor a front are not counted.
   */
  vtkGetMacro(SamplesTaken, vtkIdType);
  vtkGetMacro(CoveringRadius, double);
  vtkGetMacro(NumberOfUnreachedPoints, vtkIdType);
  ///@}

protected:
  vtkSurfaceGeodesicSamples();
  ~vtkSurfaceGeodesicSamples() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void Compute(geodesic::distributed::RankGroup& ranks, const geodesic::bridge::InputBlocks& blocks,
    vtkInformationVector** inputVector, vtkDataObject* output) override;
  void DescribeRequest(std::vector<double>& numbers) override;
  void Forget() override;

  vtkIdType NumberOfSamples = 100;
  double Spacing = 0.0;
  std::vector<double> FirstCoordinates;
  vtkIdType SamplesTaken = 0;
  double CoveringRadius = 0.0;
  vtkIdType NumberOfUnreachedPoints = 0;

private:
  struct Internals;

  /** Throws where the properties ask for nothing, or for what there can't be. */
  void CheckProperties() const;
  void WriteSamples(geodesic::distributed::RankGroup& ranks,
    const geodesic::bridge::InputBlocks& blocks, const geodesic::Sampling& sampling,
    vtkDataObject* output) const;
  void WriteRegions(const geodesic::bridge::InputBlocks& blocks, const geodesic::Sampling& sampling,
    vtkDataObject* input, vtkDataObject* output) const;
  /** Sets what tells of the last run. Collective. */
  void Measure(geodesic::distributed::RankGroup& ranks, const geodesic::Sampling& sampling);

  std::unique_ptr<Internals> Internal;

  vtkSurfaceGeodesicSamples(const vtkSurfaceGeodesicSamples&) = delete;
  void operator=(const vtkSurfaceGeodesicSamples&) = delete;
};

#endif
