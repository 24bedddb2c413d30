# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView's bundled plugin GeodesicMeasurement gets wrong about distances and paths, each named by what
should be right, and right here.

usage: PeerFailures.py OUR_PLUGIN
"""

import sys

import numpy as np
from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import testing

testing.load(sys.argv[1])

CENTER = [0.01, 0.02, 0]


def plane(**options):
    return simple.Plane(**{"XResolution": 20, "YResolution": 20, **options})


def straight(surface, seed=CENTER):
    return np.linalg.norm(testing.points_of(surface).astype(float) - seed, axis=1)


def with_cost(value):
    return simple.Calculator(Input=plane(), ResultArrayName="cost", Function=str(value))


def surface_of(points, polygons=(), strips=()):
    """A source of cells, each a tuple of point ids."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    for point in points:
        data.GetPoints().InsertNextPoint(point)
    for set_cells, cells in ((data.SetPolys, polygons), (data.SetStrips, strips)):
        array = vtkCellArray()
        for cell in cells:
            array.InsertNextCell(len(cell), [int(i) for i in cell])
        set_cells(array)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def triangles_of_plane():
    flat = simple.Triangulate(Input=plane())
    return testing.points_of(flat), testing.cells_of(flat).tolist()


def expect(distance, truth, relative=1e-6):
    np.testing.assert_allclose(
        testing.array_of(distance), truth, rtol=relative, atol=relative * np.nanmax(truth))


def costs_count_on_the_first_run():  # 1
    surface = with_cost(3)
    expect(simple.GeodesicDistance(
        Input=surface, SeedPositions=CENTER, CostArray=["POINTS", "cost"]), 3 * straight(surface))


def costs_can_be_taken_back():  # 2
    surface = with_cost(3)
    distance = simple.GeodesicDistance(
        Input=surface, SeedPositions=CENTER, CostArray=["POINTS", "cost"])
    expect(distance, 3 * straight(surface))
    distance.CostArray = ["POINTS", "None"]
    expect(distance, straight(surface))


def all_kinds_of_cells_are_served():  # 4
    quads = plane(XResolution=5, YResolution=5)
    expect(simple.GeodesicDistance(Input=quads, SeedPositions=CENTER), straight(quads))
    ladder = [(i // 2, i % 2, 0) for i in range(10)]
    strip = surface_of(ladder, strips=[range(10)])
    expect(simple.GeodesicDistance(Input=strip, SeedPositions=CENTER), straight(strip))


def an_empty_input_is_an_error():  # 4
    empty = simple.GeodesicDistance(Input=surface_of([]), SeedPositions=CENTER)
    testing.expect_error(empty, "no surface")


def an_unused_point_has_no_distance():  # 4
    points, cells = triangles_of_plane()
    surface = surface_of([*points, (7, 7, 7)], cells)
    truth = straight(surface)
    truth[-1] = np.nan
    expect(simple.GeodesicDistance(Input=surface, SeedPositions=CENTER), truth)


def the_name_is_settable_from_python():  # 6
    surface = plane()
    distance = simple.GeodesicDistance(Input=surface, SeedPositions=CENTER, DistanceArrayName="mine")
    np.testing.assert_allclose(testing.array_of(distance, "mine"), straight(surface), atol=1e-6)


def an_array_of_the_same_name_stays_as_it_is_upstream():  # 7
    surface = simple.Calculator(
        Input=plane(), ResultArrayName="GeodesicDistance", Function="coordsX + 100")
    before = testing.array_of(surface).copy()
    expect(simple.GeodesicDistance(Input=surface, SeedPositions=CENTER), straight(surface))
    np.testing.assert_array_equal(testing.array_of(surface), before)


def what_is_not_reached_is_no_large_number():  # 9
    far = plane(Origin=[2, 0, 0], Point1=[3, 0, 0], Point2=[2, 1, 0])
    surface = simple.AppendGeometry(Input=[plane(), far])
    distance = simple.GeodesicDistance(Input=surface, SeedPositions=CENTER)
    is_far = testing.points_of(surface)[:, 0] > 1
    expect(distance, np.where(is_far, np.nan, straight(surface)))
    # And a distance may be larger than 1e9.
    large = plane(Origin=[0, 0, 0], Point1=[1e12, 0, 0], Point2=[0, 1e12, 0])
    expect(simple.GeodesicDistance(Input=large, SeedPositions=[0, 0, 0]), straight(large, [0, 0, 0]))


def all_sheets_of_an_edge_are_reached():  # 10
    # Three half planes that meet in the edge x = z = 0: from one to another as if they were flat.
    angles = [0, 2, 4]
    points = [(0, y / 10, 0) for y in range(11)]
    cells, row = [], list(range(11))
    flat = [(0, p[1]) for p in points]
    for sheet, angle in enumerate(angles):
        last = row
        for step in range(1, 11):
            new = list(range(len(points), len(points) + 11))
            points += [(step / 10 * np.cos(angle), y / 10, step / 10 * np.sin(angle)) for y in range(11)]
            flat += [(step / 10 * (-1 if sheet == 0 else 1), y / 10) for y in range(11)]
            cells += [(last[i], new[i], new[i + 1]) for i in range(10)]
            cells += [(last[i], new[i + 1], last[i + 1]) for i in range(10)]
            last = new
    distance = simple.GeodesicDistance(Input=surface_of(points, cells), SeedPositions=[0.5, 0.5, 0])
    expect(distance, np.linalg.norm(np.subtract(flat, (-0.5, 0.5)), axis=1))


def doubled_triangles_change_nothing():  # 10
    points, cells = triangles_of_plane()
    surface = surface_of(points, cells + cells[::2])
    expect(simple.GeodesicDistance(Input=surface, SeedPositions=CENTER), straight(surface))


def a_triangle_with_a_repeated_point_changes_nothing():  # 10
    points, cells = triangles_of_plane()
    surface = surface_of(points, [(4, 4, 9), *cells, (30, 31, 31)])
    expect(simple.GeodesicDistance(Input=surface, SeedPositions=CENTER), straight(surface))


def beside_a_curve_the_first_ring_is_exact():  # 15
    surface = plane(XResolution=32, YResolution=32)
    row = testing.polyline([(i / 32, 0, 0) for i in range(-16, 17)])
    field = testing.array_of(simple.GeodesicDistance(Input=surface, SeedSource=row))
    np.testing.assert_allclose(field, np.abs(testing.points_of(surface)[:, 1]), atol=1e-9)


def a_negative_cost_is_an_error():  # 16
    surface = simple.Calculator(Input=plane(), ResultArrayName="cost", Function="coordsX + 0.4")
    first = int(np.argmax(testing.points_of(surface)[:, 0] < -0.4))
    testing.expect_error(
        simple.GeodesicDistance(Input=surface, SeedPositions=CENTER, CostArray=["POINTS", "cost"]),
        f"at point {first};", "-0.1", "must be positive")


def the_unit_of_length_does_not_matter():  # 17
    for scale in (1e-9, 1e-4, 1e4, 1e9):
        surface = plane(Origin=[0, 0, 0], Point1=[scale, 0, 0], Point2=[0, scale, 0])
        seed = [0.3 * scale, 0.4 * scale, 0]
        expect(simple.GeodesicDistance(Input=surface, SeedPositions=seed), straight(surface, seed))


def the_first_of_two_stops_counts():  # 18
    surface = plane()
    truth = straight(surface)
    destination = int(np.argmin(np.abs(truth - 0.3)))
    distance = simple.GeodesicDistance(
        Input=surface, SeedPositions=CENTER, DestinationPointIds=[destination],
        UseMaximumDistance=1)
    for maximum in (0.2, 0.4):
        distance.MaximumDistance = maximum
        limit = min(maximum, truth[destination])
        expect(distance, np.where(truth <= limit + 1e-9, truth, np.nan))


def a_seed_outside_is_moved_to_the_surface():  # 19
    surface = plane()
    distance = simple.GeodesicDistance(Input=surface, SeedPositions=[30, 40, 50])
    expect(distance, straight(surface, [0.5, 0.5, 0]))


def a_seed_that_does_not_exist_is_an_error():  # 19
    for id in (-1, 441, (1 << 31) - 1):
        distance = simple.GeodesicDistance(Input=plane(), SeedPointIds=[id])
        testing.expect_error(distance, f"id {id} ", "441 points")


def path_length(**options):
    path = simple.GeodesicPath(**options)
    path.UpdatePipeline()
    return testing.informed(path, "TotalLength")


def no_route_is_an_error():  # 3
    parts = simple.AppendGeometry(Input=[plane(), plane(Origin=[2, 0, 0], Point1=[3, 0, 0], Point2=[2, 1, 0])])
    path = simple.GeodesicPath(Input=parts, WaypointPositions=[0, 0, 0, 2.5, 0.5, 0])
    testing.expect_error(path, "from waypoint 0 to waypoint 1")


def equal_endpoints_leave_the_next_segment():  # 5
    points = [0, 0, 0, 0, 0, 0, 0.3, 0.4, 0]
    assert np.isclose(path_length(Input=plane(), WaypointPositions=points), 0.5, rtol=1e-6)


def a_path_is_straight_at_any_scale():  # 8
    for scale in (1e-6, 0.1, 50, 1e6):
        ends = scale * np.array([-0.43, -0.31, 0, 0.37, 0.44, 0])
        surface = plane(Origin=[-scale / 2, -scale / 2, 0], Point1=[scale / 2, -scale / 2, 0],
                        Point2=[-scale / 2, scale / 2, 0])
        exact = scale * np.hypot(0.8, 0.75)
        found = path_length(Input=surface, WaypointPositions=ends.tolist())
        assert np.isclose(found, exact, rtol=1e-6, atol=0), (scale, found, exact)


def paths_cross_edges_of_three_faces_and_odd_cells():  # 10
    points, cells = triangles_of_plane()
    odd = surface_of(points, [(4, 4, 9), *cells, *cells[::2], (30, 31, 31)])
    exact = np.hypot(0.8, 0.75)
    ends = [-0.43, -0.31, 0, 0.37, 0.44, 0]
    assert np.isclose(path_length(Input=odd, WaypointPositions=ends), exact, rtol=1e-6)
    corner = [(-1, 0, 0), (1, 0, 0), (0, 0, 1), (0, 2, 0), (0, -2, 0)]
    sheets = surface_of(corner, [(3, 4, 0), (3, 4, 1), (3, 4, 2)])
    for first, second in ((0, 1), (1, 2), (2, 0)):
        ends = [0.5 * x for i in (first, second) for x in corner[i]]
        assert np.isclose(path_length(Input=sheets, WaypointPositions=ends), 1.0, rtol=1e-6)


for failure in [
        costs_count_on_the_first_run,
        costs_can_be_taken_back,
        all_kinds_of_cells_are_served,
        an_empty_input_is_an_error,
        an_unused_point_has_no_distance,
        the_name_is_settable_from_python,
        an_array_of_the_same_name_stays_as_it_is_upstream,
        what_is_not_reached_is_no_large_number,
        all_sheets_of_an_edge_are_reached,
        doubled_triangles_change_nothing,
        a_triangle_with_a_repeated_point_changes_nothing,
        beside_a_curve_the_first_ring_is_exact,
        a_negative_cost_is_an_error,
        the_unit_of_length_does_not_matter,
        the_first_of_two_stops_counts,
        a_seed_outside_is_moved_to_the_surface,
        a_seed_that_does_not_exist_is_an_error,
        no_route_is_an_error,
        equal_endpoints_leave_the_next_segment,
        a_path_is_straight_at_any_scale,
        paths_cross_edges_of_three_faces_and_odd_cells]:
    print(failure.__name__, flush=True)
    failure()
