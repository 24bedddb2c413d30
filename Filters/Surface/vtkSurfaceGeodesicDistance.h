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
 * array of distances in the mesh's unit of length, which becomes the active scalars. A grid or an
 * image is replaced by its outer surface, with the arrays vtkOriginalPointIds and
 * vtkOriginalCellIds. The input is never modified.
 *
 * Errors, which leave the output empty: no seed, a seed on a barrier, a line of seeds or of
 * barriers between parts of the surface that are not connected, a list of coordinates whose length
 * is not a multiple of 3, an id that does not exist, an array that does not exist or has several
 * components, a cost that is not positive, a negative MaximumDistance in use, and what
 * vtkSurfaceGeodesicFilter names.
 *
 * On several ranks the pieces of the input are one surface. The rules that tell which points of
 * different blocks are the same apply to points of different pieces as well. Point ids are then
 * global ids.
 */
#ifndef vtkSurfaceGeodesicDistance_h
#define vtkSurfaceGeodesicDistance_h

#include "vtkIdList.h" // For members
#include "vtkNew.h"    // For members
#include "vtkSurfaceGeodesicFilter.h"

#include <memory> // For members
#include <string> // For members
#include <vector> // For members

class vtkInformationIntegerKey;
class vtkInformationStringKey;
class vtkPolyData;

namespace geodesic
{
class DistanceField;
struct Seed;
struct SolveOptions;
struct SurfacePoint;
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

  ///@{
  /**
   * On the array of distances, if they were measured under costs: the name of the cost array, and
   * its CostMode. vtkSurfaceGeodesicIsolines reads them.
   */
  static vtkInformationStringKey* COST_ARRAY_NAME();
  static vtkInformationIntegerKey* COST_ARRAY_MODE();
  ///@}

  enum DestinationModes
  {
    ANY_DESTINATION,
    ALL_DESTINATIONS
  };

  /** Additional input ports, all optional. */
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
   * The seed positions, x y z of each in turn, in the input's coordinates. At least one seed is
   * required. The server manager passes a list by AddSeedCoordinate(), one coordinate at a time; a
   * length that is not a multiple of 3 is an error. Default: none.
   */
  void ClearSeedPositions();
  void AddSeedPosition(double x, double y, double z);
  void AddSeedCoordinate(double coordinate);
  int GetNumberOfSeedCoordinates();
  /** A coordinate; 0 and an error where there is no such index. */
  double GetSeedCoordinate(int index);
  ///@}

  ///@{
  /**
   * Point ids of the input that are seeds; global ids if there are several blocks. Default: none.
   */
  void ClearSeedPointIds();
  void AddSeedPointId(vtkIdType id);
  ///@}

  ///@{
  /**
   * A data set whose points are seeds, projected to the surface. Each of its lines and polylines is
   * one seed, a curve; shortest paths join its consecutive points where they share no face.
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
   * Positions (projected to the surface) and point ids that must be reached. No point farther than
   * the last destination needed gets a distance. Default: none.
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
   * Whether a point array NearestSeed is made. It has the number of the nearest seed, the smallest
   * one of equally near seeds, and -1 at points without a distance. Seeds are numbered from 0 in
   * this order: positions, point ids, the source's points, the source's lines, the array's values
   * by increasing value, the selection. Default: off.
   */
  vtkSetMacro(ComputeNearestSeed, bool);
  vtkGetMacro(ComputeNearestSeed, bool);
  vtkBooleanMacro(ComputeNearestSeed, bool);
  ///@}

  ///@{
  /**
   * Whether distances have a sign: that of the side of the seeds, which must be lines of the seed
   * source. Inside of closed lines it is minus. To the left of open ones, which must lead from
   * border to border, it is plus; the left is that of somebody who walks along the line on the side
   * that the normals point to, where the corners of each face are in counterclockwise order. The
   * inside of a closed line is the side with less of the surface's border or, if both have as much,
   * with the smaller area. Lines with a common end are one. The sign changes at each line, so it is
   * plus again inside of two. Costs and barriers have no part in it. Default: off.
   *
   * Errors: a seed that is no line, a line without two sides, see geodesic::regionSigns(), and an
   * UnreachedValue that can be a distance.
   */
  vtkSetMacro(Signed, bool);
  vtkGetMacro(Signed, bool);
  vtkBooleanMacro(Signed, bool);
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

  ///@{
  /**
   * Whether on several ranks the surface is cut into patches that are dealt out to the ranks in
   * turn, so that all have work while the front is in one rank's piece. From a seed where pieces
   * meet that is slower, as there are some ten times as many rounds. It takes about as much memory
   * again, and time once for a surface. Not with lines of seeds and barriers. Default: off.
   */
  vtkSetMacro(SpreadWork, bool);
  vtkGetMacro(SpreadWork, bool);
  vtkBooleanMacro(SpreadWork, bool);
  ///@}

  ///@{
  /**
   * Whether a method that needs the surface in one piece (Exact, VirtualSources, Bounded) may bring
   * it to the first of several ranks, which then solves alone: the triangles within MaximumDistance
   * of the box round the seeds, or all. Without it such a request is an error. Of no effect on one
   * rank and with other methods; FAST_MARCHING brings a surface of many thin triangles there by
   * itself. Default: off.
   */
  vtkSetMacro(GatherForExact, bool);
  vtkGetMacro(GatherForExact, bool);
  vtkBooleanMacro(GatherForExact, bool);
  ///@}

  /**
   * The number of points with a final distance in the last run; 0 before the first. A point that
   * several ranks have counts once.
   */
  vtkGetMacro(NumberOfVisitedPoints, vtkIdType);

  /**
   * How many triangles of the surface are thin: their height over the longest side is less than a
   * tenth of it. 0 before the first run, and with methods other than FAST_MARCHING, which measure
   * as well there as elsewhere.
   */
  vtkGetMacro(ThinTriangles, vtkIdType);
  /**
   * What to know about the last run's distances, in full sentences: that a hundredth or more of the
   * triangles are thin, and whether the front went over intrinsic triangles instead, or that the
   * front settled only roughly, which is a warning too; and what to do about it. Empty if there is
   * nothing.
   */
  const char* GetNoticeText();

  ///@{
  /**
   * The work of the last run over all ranks: how often the ranks marched and exchanged values (once
   * on one rank), the vertices taken from queues, those of them that followed each other (in each
   * round those of the rank that took most), the bytes sent between ranks, and the largest number
   * of points on any rank. All are 0 before the first run.
   */
  vtkGetMacro(NumberOfRounds, vtkIdType);
  vtkGetMacro(NumberOfUpdates, vtkIdType);
  vtkGetMacro(LongestChainOfUpdates, vtkIdType);
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
  bool Signed = false;
  bool UseMaximumDistance = false;
  double MaximumDistance = 1.0;
  std::string DistanceArrayName = "GeodesicDistance";
  int UnreachedAs = UNREACHED_AS_NAN;
  double UnreachedValue = -1.0;
  bool SpreadWork = false;
  bool GatherForExact = false;
  double MaximumDistanceReached = 0.0;
  vtkIdType NumberOfVisitedPoints = 0;
  vtkIdType ThinTriangles = 0;
  std::string NoticeText;
  vtkIdType NumberOfRounds = 0;
  vtkIdType NumberOfUpdates = 0;
  vtkIdType LongestChainOfUpdates = 0;
  vtkIdType BytesExchanged = 0;
  vtkIdType MostPointsOnARank = 0;

private:
  struct Internals;
  /** The input of a run: the ranks, the input's blocks, and the data on all ports. */
  struct Run
  {
    geodesic::distributed::RankGroup& ranks;
    const geodesic::bridge::InputBlocks& blocks;
    vtkInformationVector** inputVector;
  };
  void Solve(const Run& run);
  std::vector<geodesic::Seed> GatherSeeds(const Run& run, std::size_t numberOfLines);
  std::vector<geodesic::distributed::GlobalPoint> GatherDestinations(const Run& run);
  /** Throws if UnreachedValue can be a distance. */
  void CheckUnreachedValue() const;
  /** Whether the method needs the surface on the first rank, and may bring it there. */
  bool Gathers(const geodesic::distributed::RankGroup& ranks) const;
  /** Solves on triangles that are dealt to other ranks. Collective, on several ranks. */
  void SolveDealt(const Run& run, std::vector<geodesic::Seed> seeds,
    const geodesic::SolveOptions& options,
    const std::vector<std::vector<geodesic::SurfacePoint>>& destinations);
  /** @param solved,numberOfPoints the field that was solved, and this rank's points for it */
  void ReportWork(const Run& run, geodesic::distributed::DistributedSolver& partition,
    const geodesic::DistanceField& solved, vtkIdType numberOfPoints);
  /** Warns where the front settled only roughly on any rank, and adds that to NoticeText. */
  void NoteSettling(geodesic::distributed::RankGroup& ranks, const geodesic::DistanceField& solved);
  void AttachArrays(std::size_t block, vtkPolyData* output) const;

  std::unique_ptr<Internals> Internal;

  vtkSurfaceGeodesicDistance(const vtkSurfaceGeodesicDistance&) = delete;
  void operator=(const vtkSurfaceGeodesicDistance&) = delete;
};

#endif
