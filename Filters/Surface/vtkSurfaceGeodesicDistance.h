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
 * The output is the input passed through, in the same structure of blocks, together with a point
 * array of distances in the mesh's unit of length, which becomes the active scalars. In the place
 * of a grid or an image is its outer surface, with the arrays vtkOriginalPointIds and
 * vtkOriginalCellIds. The input is never modified.
 *
 * Errors, which leave the output empty: no seed, a seed on a barrier, a line of seeds or of
 * barriers between parts of the surface that do not hang together, a list of coordinates whose
 * length is no multiple of 3, an id that does not exist, an array that does not or has several
 * components, a cost that is not positive, a negative MaximumDistance in use, and what
 * vtkSurfaceGeodesicFilter names.
 *
 * On several ranks the pieces of the input are one surface. Which of their points are one is told
 * as for blocks. Point ids are global ids then.
 */
#ifndef vtkSurfaceGeodesicDistance_h
#define vtkSurfaceGeodesicDistance_h

#include "vtkIdList.h" // For members
#include "vtkNew.h"    // For members
#include "vtkSurfaceGeodesicFilter.h"

#include <memory> // For members
#include <string> // For members
#include <vector> // For members

class vtkPolyData;

namespace geodesic
{
struct Seed;
namespace distributed
{
class DistributedSolver;
struct GlobalPoint;
}
}

class VTKFILTERSSURFACEGEODESICS_EXPORT vtkSurfaceGeodesicDistance : public vtkSurfaceGeodesicFilter
{
public:
  static vtkSurfaceGeodesicDistance* New();
  vtkTypeMacro(vtkSurfaceGeodesicDistance, vtkSurfaceGeodesicFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DestinationModes
  {
    ANY_DESTINATION,
    ALL_DESTINATIONS
  };

  /** Further input ports, optional. */
  enum SeedPorts
  {
    SEED_SOURCE_PORT = 1,
    SEED_SELECTION_PORT = 3,
    NUMBER_OF_PORTS
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
   * Point ids of the input that are seeds; of several blocks their global ids. Default: none.
   */
  void ClearSeedPointIds();
  void AddSeedPointId(vtkIdType id);
  ///@}

  ///@{
  /**
   * A data set of points that are seeds, projected to the surface; each of its lines and polylines
   * is one seed, a curve, joined by shortest paths where consecutive points share no face.
   * Optional.
   */
  void SetSeedSourceConnection(vtkAlgorithmOutput* source);
  ///@}

  ///@{
  /**
   * The selection (vtkSelection) of points or cells of the input that together are one seed.
   * Optional.
   */
  void SetSeedSelectionConnection(vtkAlgorithmOutput* selection);
  ///@}

  ///@{
  /**
   * Positions (projected) and point ids to reach: nothing farther than the last one needed gets a
   * distance. Default: none.
   */
  void ClearDestinationPositions();
  void AddDestinationCoordinate(double coordinate);
  void ClearDestinationPointIds();
  void AddDestinationPointId(vtkIdType id);
  ///@}

  ///@{
  /**
   * Whether any one or all of the destinations must be reached. Default: ANY_DESTINATION.
   */
  vtkSetClampMacro(DestinationMode, int, ANY_DESTINATION, ALL_DESTINATIONS);
  vtkGetMacro(DestinationMode, int);
  ///@}

  ///@{
  /**
   * Whether a point array NearestSeed is made: the number of the nearest seed, the smaller one of
   * equally near ones, -1 at points without a distance. Seeds are numbered from 0: positions, point
   * ids, the source's points and then lines, the array's values upwards, the selection. Default:
   * off.
   */
  vtkSetMacro(ComputeNearestSeed, bool);
  vtkGetMacro(ComputeNearestSeed, bool);
  vtkBooleanMacro(ComputeNearestSeed, bool);
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

  /**
   * The largest final distance of the last run, in the mesh's unit of length; 0 before the first.
   */
  vtkGetMacro(MaximumDistanceReached, double);

  /**
   * The number of points with a final distance in the last run; 0 before the first. On several
   * ranks, points that are one count once.
   */
  vtkGetMacro(NumberOfVisitedPoints, vtkIdType);

  ///@{
  /**
   * What the last run took, over all ranks: how often they marched and exchanged values (once on
   * one rank), vertices taken from queues, bytes sent from rank to rank, and the points of the rank
   * that has most. All 0 before the first run.
   */
  vtkGetMacro(NumberOfRounds, vtkIdType);
  vtkGetMacro(NumberOfUpdates, vtkIdType);
  vtkGetMacro(BytesExchanged, vtkIdType);
  vtkGetMacro(MostPointsOnARank, vtkIdType);
  ///@}

protected:
  vtkSurfaceGeodesicDistance();
  ~vtkSurfaceGeodesicDistance() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void Compute(geodesic::distributed::RankGroup& ranks, const geodesic::bridge::InputBlocks& blocks,
    vtkInformationVector** inputVector, vtkDataObject* output) override;
  void DescribeRequest(std::vector<double>& numbers) override;
  void Forget() override;

  std::vector<double> SeedCoordinates;
  vtkNew<vtkIdList> SeedPointIds;
  std::vector<double> DestinationCoordinates;
  vtkNew<vtkIdList> DestinationPointIds;
  int DestinationMode = ANY_DESTINATION;
  bool ComputeNearestSeed = false;
  bool UseMaximumDistance = false;
  double MaximumDistance = 1.0;
  std::string DistanceArrayName = "GeodesicDistance";
  int UnreachedAs = UNREACHED_AS_NAN;
  double UnreachedValue = -1.0;
  double MaximumDistanceReached = 0.0;
  vtkIdType NumberOfVisitedPoints = 0;
  vtkIdType NumberOfRounds = 0;
  vtkIdType NumberOfUpdates = 0;
  vtkIdType BytesExchanged = 0;
  vtkIdType MostPointsOnARank = 0;

private:
  struct Internals;
  /** What a run works on: the ranks, the input's blocks, and what else is connected. */
  struct Run
  {
    geodesic::distributed::RankGroup& ranks;
    const geodesic::bridge::InputBlocks& blocks;
    vtkInformationVector** inputVector;
  };
  void Solve(const Run& run);
  std::vector<geodesic::Seed> GatherSeeds(const Run& run, std::size_t numberOfLines);
  std::vector<geodesic::Seed> GatherArraySeeds(const Run& run);
  std::vector<geodesic::Seed> GatherSelectedSeeds(const Run& run);
  std::vector<geodesic::distributed::GlobalPoint> GatherDestinations(const Run& run);
  void ReportWork(const Run& run, geodesic::distributed::DistributedSolver& partition);
  void AttachArrays(std::size_t block, vtkPolyData* output) const;

  std::unique_ptr<Internals> Internal;

  vtkSurfaceGeodesicDistance(const vtkSurfaceGeodesicDistance&) = delete;
  void operator=(const vtkSurfaceGeodesicDistance&) = delete;
};

#endif
