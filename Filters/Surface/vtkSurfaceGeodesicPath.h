// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceGeodesicPath
 * @brief Shortest paths over a surface between positions in space.
 *
 * The filter behind ParaView's proxy GeodesicPath. Each position is projected to the nearest point
 * of the surface, on a face, an edge or a vertex. Paths begin and end at exactly these points.
 *
 * The output is one polyline for each segment between consecutive waypoints, or from each start to
 * its nearest waypoint. Point arrays: ArcLength (from the first waypoint on, through all segments;
 * in TO_NEAREST_SEED from each start on), OriginalPointIds (the nearest mesh point that carries the
 * path's point), EdgePointIds (both ends of the edge that it is on, nearest first; at a mesh point
 * twice its id; in a face the two nearest corners), Normals (of length 1: the input's, or made from
 * its faces). If there are several blocks, ids are global ids; without global ids, OriginalBlocks
 * and EdgeBlocks have the blocks' flat indices in the composite input. If there are several ranks,
 * all paths are on the first one, and ids are global ids, or -1 without global ids. Cell arrays:
 * Segment (its number, or the start's, from 0) and Length; in TO_NEAREST_SEED also NearestSeed (the
 * waypoint's number). Field array: TotalLength. Lengths are those on the surface, in the mesh's
 * unit of length, without cost and height offset.
 *
 * A segment of length 0 joins equal waypoints. If no path joins two waypoints, an error names them,
 * and the output has all other segments. Other requests that can't be served empty the output:
 * fewer than two waypoints (one in TO_NEAREST_SEED, and one start), positions and source both set,
 * a waypoint on a barrier, and what vtkSurfaceGeodesicFilter names.
 */
#ifndef vtkSurfaceGeodesicPath_h
#define vtkSurfaceGeodesicPath_h

#include "vtkSurfaceGeodesicFilter.h"

#include "vtkNew.h" // For members

#include <string> // For arguments

class vtkDoubleArray;
class vtkPolyData;

namespace geodesic
{
namespace distributed
{
struct GlobalPoint;
struct PathRequest;
}
}

class VTKFILTERSSURFACEGEODESICS_EXPORT vtkSurfaceGeodesicPath : public vtkSurfaceGeodesicFilter
{
public:
  static vtkSurfaceGeodesicPath* New();
  vtkTypeMacro(vtkSurfaceGeodesicPath, vtkSurfaceGeodesicFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PathModes
  {
    THROUGH_WAYPOINTS,
    TO_NEAREST_SEED
  };

  enum StraightenModes
  {
    STRAIGHTEN_AUTO,
    STRAIGHTEN_OFF
  };

  /** Additional input ports, all optional. */
  enum WaypointPorts
  {
    WAYPOINT_SOURCE_PORT = 1,
    START_SOURCE_PORT = 3,
    NUMBER_OF_PORTS
  };

  ///@{
  /**
   * The waypoints in their order, x y z of each in turn, in the input's coordinates. Default: none.
   */
  void ClearWaypointPositions();
  void AddWaypointCoordinate(double coordinate);
  ///@}

  ///@{
  /**
   * A data set whose points are the waypoints, in their order. It replaces the positions; setting
   * both is an error. Optional.
   */
  void SetWaypointSourceConnection(vtkAlgorithmOutput* source);
  ///@}

  ///@{
  /**
   * Whether the last waypoint is joined to the first. Default: off.
   */
  vtkSetMacro(Closed, bool);
  vtkGetMacro(Closed, bool);
  vtkBooleanMacro(Closed, bool);
  ///@}

  ///@{
  /**
   * THROUGH_WAYPOINTS: from each waypoint to the next. TO_NEAREST_SEED: from each start to the
   * geodesically nearest waypoint, all from one field. Default: THROUGH_WAYPOINTS.
   */
  vtkSetClampMacro(PathMode, int, THROUGH_WAYPOINTS, TO_NEAREST_SEED);
  vtkGetMacro(PathMode, int);
  ///@}

  ///@{
  /**
   * The starts of TO_NEAREST_SEED, x y z of each in turn, in the input's coordinates. Default:
   * none.
   */
  void ClearStartPositions();
  void AddStartCoordinate(double coordinate);
  ///@}

  ///@{
  /**
   * A data set whose points are the starts. It replaces the positions; setting both is an error.
   * Optional.
   */
  void SetStartSourceConnection(vtkAlgorithmOutput* source);
  ///@}

  ///@{
  /**
   * 0: the path runs through mesh points, along edges. 1: across faces, each of its points on an
   * edge. Default: 1.
   */
  vtkSetClampMacro(InterpolationOrder, int, 0, 1);
  vtkGetMacro(InterpolationOrder, int);
  ///@}

  ///@{
  /**
   * STRAIGHTEN_AUTO: a path of order 1 at constant cost is made locally shortest; other paths stay
   * as traced. STRAIGHTEN_OFF: all paths stay as traced. Default: STRAIGHTEN_AUTO.
   */
  vtkSetClampMacro(Straighten, int, STRAIGHTEN_AUTO, STRAIGHTEN_OFF);
  vtkGetMacro(Straighten, int);
  ///@}

  ///@{
  /**
   * Whether MaximumPathLength is in use. Default: off.
   */
  vtkSetMacro(UseMaximumPathLength, bool);
  vtkGetMacro(UseMaximumPathLength, bool);
  vtkBooleanMacro(UseMaximumPathLength, bool);
  ///@}

  ///@{
  /**
   * The largest length of a polyline, in the mesh's unit of length, not negative. A longer path is
   * cut off at this length; at order 0, at the last mesh point before. Default: 1.
   */
  vtkSetMacro(MaximumPathLength, double);
  vtkGetMacro(MaximumPathLength, double);
  ///@}

  ///@{
  /**
   * Raises the output along the normals by this length, so that the surface does not hide it. In
   * the mesh's unit of length. Default: 0.
   */
  vtkSetMacro(HeightOffset, double);
  vtkGetMacro(HeightOffset, double);
  ///@}

  ///@{
  /**
   * Whether the waypoints are being dragged, so that the next run comes soon. A segment between
   * waypoints is then traced from one of its ends only. Else FastMarching and VirtualSources, whose
   * paths are not proven to be the shortest, trace it from both, and the shorter path is taken; so
   * the runs during a drag are twice as fast. Default: off.
   */
  vtkSetMacro(Dragged, bool);
  vtkGetMacro(Dragged, bool);
  vtkBooleanMacro(Dragged, bool);
  ///@}

  ///@{
  /**
   * Whether a method that needs the surface in one piece (Exact, VirtualSources, Bounded) may bring
   * all of it to the first of several ranks, which then searches alone. It is kept there as long as
   * the surface, costs, barriers and the method stay the same. Without it such a request is an
   * error. Of no effect on one rank and with other methods. Default: off.
   */
  vtkSetMacro(GatherForExact, bool);
  vtkGetMacro(GatherForExact, bool);
  vtkBooleanMacro(GatherForExact, bool);
  ///@}

  /**
   * The length of all paths of the last run, in the mesh's unit of length; 0 before the first.
   */
  vtkGetMacro(TotalLength, double);
  /**
   * How many segments of the last run are proven to be the shortest of all paths between their
   * ends, not only locally: with InterpolationOrder 1 and the method Exact all of them, but where
   * rounding led one astray. With Bounded those proven to be longer by Tolerance at most, so again
   * all. With other methods 0.
   */
  vtkGetMacro(ProvenShortest, int);

  ///@{
  /**
   * The length of each segment of the last run, in the order of the segments and the mesh's unit of
   * length, -1 where no path joins its ends; and the point in the middle of each, 0 where there is
   * none. Empty before the first run, after an error, with TO_NEAREST_SEED, and on all ranks but
   * the first.
   */
  vtkDoubleArray* GetSegmentLengths();
  vtkDoubleArray* GetSegmentMiddles();
  ///@}

  /**
   * How many segments the last run searched for; it kept the others of the run before.
   */
  vtkGetMacro(NumberOfSearches, vtkIdType);

  /**
   * The largest number of surface points that any rank held in the last run: those of its piece
   * and, on the first of several ranks, those it gathered along a path.
   */
  vtkGetMacro(MostPointsOnARank, vtkIdType);

protected:
  vtkSurfaceGeodesicPath();
  ~vtkSurfaceGeodesicPath() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(geodesic::distributed::RankGroup& ranks, const geodesic::bridge::InputBlocks& blocks,
    vtkInformationVector** inputVector, vtkDataObject* output) override;
  void DescribeRequest(std::vector<double>& numbers) override;
  void Forget() override;

  std::vector<double> WaypointCoordinates;
  bool Closed = false;
  int PathMode = THROUGH_WAYPOINTS;
  std::vector<double> StartCoordinates;
  int InterpolationOrder = 1;
  int Straighten = STRAIGHTEN_AUTO;
  bool UseMaximumPathLength = false;
  double MaximumPathLength = 1.0;
  double HeightOffset = 0.0;
  bool Dragged = false;
  bool GatherForExact = false;
  double TotalLength = 0.0;
  int ProvenShortest = 0;
  vtkIdType NumberOfSearches = 0;
  vtkIdType MostPointsOnARank = 0;
  vtkNew<vtkDoubleArray> SegmentLengths;
  vtkNew<vtkDoubleArray> SegmentMiddles;

private:
  struct Internals;
  struct Run;
  struct Segment;
  using Points = std::vector<geodesic::distributed::GlobalPoint>;

  void CheckRequest() const;
  /** Returns the points of a source or of positions. Throws if both are set. Collective. */
  Points GatherPoints(const Run& run, int sourcePort, const std::vector<double>& coordinates,
    const char* positions, const char* source) const;
  /** Returns points on the mesh that is solved on. Throws if one is on a barrier. Collective. */
  Points OpenPoints(const Run& run, const Points& points, const std::string& role) const;
  std::vector<Segment> TraceThroughWaypoints(const Run& run, const Points& waypoints);
  std::vector<Segment> TraceToNearest(
    const Run& run, const Points& waypoints, const Points& starts);
  geodesic::distributed::PathRequest MakeRequest(const Run& run);
  /** Whether the run was aborted on any rank. Collective. */
  bool IsAborted(const Run& run);
  /** Whether the method works on the whole surface, on the first of several ranks. */
  bool Gathers(const geodesic::distributed::RankGroup& ranks) const;

  /** Reports one error for all missing segments.
   * @param missing   what each would join; the first few are named
   * @param segments  the number of all, the missing ones included */
  void ReportMissing(const std::vector<std::string>& missing, std::size_t segments);
  void WriteOutput(const Run& run, vtkPolyData* output);

  std::unique_ptr<Internals> Internal;

  vtkSurfaceGeodesicPath(const vtkSurfaceGeodesicPath&) = delete;
  void operator=(const vtkSurfaceGeodesicPath&) = delete;
};

#endif
