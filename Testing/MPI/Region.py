# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Regions on several ranks are those on one rank, and the pieces that were cut still fit together.

usage: mpiexec -n N pvbatch --sym Region.py OUR_PLUGIN FOLDER
The run with one rank leaves the areas in FOLDER that the others are compared with.
"""

import os
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.append(os.path.dirname(__file__))
import harness
import pieces

PLUGIN, FOLDER = sys.argv[1:]
os.makedirs(FOLDER, exist_ok=True)
harness.load(PLUGIN)

NECK = [-0.0807, 0.0717, 0.0138, -0.0633, 0.0807, 0.0433, -0.0413, 0.1057, 0.0399, -0.0307, 0.1260, 0.0136,
        -0.0492, 0.1156, -0.0155, -0.0728, 0.0901, -0.0156]


def loop(centre, radius, corners, axis=2):
    """A closed polygon round a point, in the plane across an axis."""
    angles = 2 * np.pi * np.arange(corners) / corners + 0.1
    points = np.zeros((corners, 3))
    points[:, (axis + 1) % 3] = radius * np.cos(angles)
    points[:, (axis + 2) % 3] = radius * np.sin(angles)
    return simple.PolyLineSource(Points=list((points + centre).ravel()), Closed=1)


def together(*lines):
    return simple.AppendGeometry(Input=list(lines))


# On the torus, whose pieces are slabs along x: a loop over cuts, two that cross, one round the tube, and both that
# together part it in two. On the sphere rings and a line along the cuts' own direction. Open lines from border to border.
CASES = {
    "bunny": ("bunny", simple.PolyLineSource(Points=NECK, Closed=1), dict(InsidePositions=[-0.0755, 0.1245, 0.052])),
    "loop": ("torus", loop([0, 1.1, 0.4], 0.2, 7), {}),
    "crossing": ("torus", together(loop([0, 1.1, 0.4], 0.2, 7), loop([0.15, 1.0, 0.4], 0.2, 9)), {}),
    "tube": ("torus", loop([0.013, 1, 0], 0.4, 7, axis=0), {}),
    "tubes": ("torus", together(loop([0.013, 1, 0], 0.4, 7, axis=0), loop([0.017, -1, 0], 0.4, 7, axis=0)), {}),
    "nested": ("sphere", together(loop([0, 0, 0.9], 0.4, 5), loop([0, 0, 0.7], 0.7, 6), loop([0, 0, 0], 1, 8)),
               dict(InsidePositions=[0, 0, -1, 0, 0, 1])),
    "open": ("thin", together(simple.PolyLineSource(Points=[0.41, -1, 0, 0.43, 1, 0]),
                              simple.PolyLineSource(Points=[-1, 0.0052, 0, 2, 0.0113, 0])), {}),
    "parts": ("parts", simple.PolyLineSource(Points=[0.3, -9, 0, 0.35, 9, 0]), {}),
    "edges": ("parts", simple.PolyLineSource(Points=[3, 0, 0, 3, 7, 0]), {}),
    "none": ("parts", None, {}),
}
# Lines that part nothing: round the tube once.
USELESS = {"tube"}
NOT_CUT_AT_THE_BORDER = ("bunny", "torus", "sphere")


def corners_and_regions(data):
    """This rank's triangles as coordinates, with their regions and whether they are the surface's own."""
    cells = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = vtk_to_numpy(data.GetPoints().GetData()) if data.GetPoints() else np.zeros((0, 3))
    regions = vtk_to_numpy(data.GetCellData().GetArray("GeodesicRegion")) if len(cells) else np.zeros(0, int)
    return points[cells].astype(float), regions


def of_all(values, name):
    """The rows of all ranks, on all ranks."""
    file = os.path.join(FOLDER, f"{name}.{harness.RANKS}")
    np.save(f"{file}.{pieces.controller().GetLocalProcessId()}.npy", values)
    pieces.controller().Barrier()
    rows = np.concatenate([np.load(f"{file}.{rank}.npy") for rank in range(harness.RANKS)])
    pieces.controller().Barrier()
    return rows


def areas_of(triangles):
    return 0.5 * np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1)


def uses_of_edges(corners):
    """How many triangles each edge has; the edges of all triangles, side by side."""
    ends = np.sort(np.vstack([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), axis=1)
    return ends, np.unique(ends, axis=0, return_counts=True)[1]


def check_pieces(name, surface, areas, perimeters, triangles, regions):
    """What the output of all ranks has to be, whatever one rank says."""
    measured = np.bincount(regions, areas_of(triangles), minlength=len(areas))
    assert np.allclose(measured, areas, rtol=1e-6), (name, measured, areas)
    # The same point has the same coordinates on all ranks, to the last bit.
    _, numbers = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    corners = numbers.reshape(-1, 3)
    ends, counts = uses_of_edges(corners)
    if surface in NOT_CUT_AT_THE_BORDER:
        _, before = uses_of_edges(pieces.SURFACES[surface]()[1])
        assert (counts == 1).sum() == (before == 1).sum() and counts.max() == 2, (name, np.bincount(counts))
    lengths = np.linalg.norm(np.vstack([triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 1],
                                        triangles[:, 0] - triangles[:, 2]]), axis=1)
    keys = ends[:, 0] * (corners.max() + 1) + ends[:, 1]
    beside = np.unique(np.column_stack([keys, np.tile(regions, 3)]), axis=0)
    edges, first, uses = np.unique(keys, return_index=True, return_counts=True)
    regions_beside = np.unique(beside[:, 0], return_counts=True)[1]
    is_border = (uses == 1) | (regions_beside > 1)
    length = dict(zip(edges[is_border], lengths[first[is_border]]))
    border = np.zeros(len(areas))
    for key, region in beside:
        border[region] += length.get(key, 0.0)
    assert np.allclose(border, perimeters, rtol=1e-6), (name, border, perimeters)


for name, (surface, lines, options) in CASES.items():
    more = {"nested": ["slabs with ghosts", "last"], "loop": ["random"], "crossing": ["slabs with ids"],
            "tubes": ["random"], "none": ["first"]}.get(name, [])
    for cut in ["whole"] if harness.RANKS == 1 else ["slabs", *more]:
        source = harness.surface(surface, cut.split()[0], "with" in cut)
        if cut.endswith("ghosts"):
            source = harness.ghosted(source)
        proxy = simple.GeodesicRegion(Input=source, **options)
        if lines is not None:
            proxy.Lines = lines
        messages = harness.messages_of(proxy.UpdatePipeline)
        expected = name in USELESS and harness.IS_FIRST
        assert ("separates nothing" in messages) == expected and "ERR" not in messages, (name, messages)
        areas = np.atleast_1d(harness.informed(proxy, "RegionAreas"))
        perimeters = np.atleast_1d(harness.informed(proxy, "RegionPerimeters"))
        data = proxy.GetClientSideObject().GetOutputDataObject(0)
        triangles, regions = corners_and_regions(data)
        is_shown = regions >= 0
        label = f"region {name}"
        check_pieces((name, cut), surface, areas, perimeters,
                     of_all(triangles[is_shown], label), of_all(regions[is_shown], label))
        if cut.endswith("ids"):
            # Equal ids mean equal places, and all are there.
            ids = of_all(vtk_to_numpy(data.GetPointData().GetGlobalIds()), label)
            places = of_all(vtk_to_numpy(data.GetPoints().GetData()), label)
            pairs = np.unique(np.column_stack([ids, places]), axis=0)
            assert len(np.unique(ids)) == len(pairs) == len(np.unique(places, axis=0)), (name, cut)
        file = os.path.join(FOLDER, f"{name}.regions.npy")
        if harness.RANKS == 1:
            np.save(file, np.array([areas, perimeters]))
        elif harness.IS_FIRST:
            reference = np.load(file)
            assert reference.shape == (2, len(areas)), (name, cut, reference, areas)
            error = np.abs(reference - [areas, perimeters]).max() / np.abs(reference).max()
            print(f"{name:8s} {cut:20s} {len(areas):3d} regions {error:7.1e}", flush=True)
            assert error <= 1e-9, (name, cut, reference, areas, perimeters)
        simple.Delete(proxy)

# Extracted: the head alone, wherever its faces are.
head = simple.GeodesicRegion(Input=harness.surface("bunny", "slabs"), Lines=CASES["bunny"][1], Extract="Inside",
                             InsidePositions=[-0.0755, 0.1245, 0.052])
assert harness.messages_of(head.UpdatePipeline) == ""
triangles, regions = corners_and_regions(head.GetClientSideObject().GetOutputDataObject(0))
assert (regions == 0).all()
total = of_all(areas_of(triangles), "head").sum()
assert np.isclose(total, np.atleast_1d(harness.informed(head, "RegionAreas"))[0], rtol=1e-6)

# A point on a cut between ranks that is on a line, too.
between = simple.GeodesicRegion(Input=harness.surface("parts", "slabs"), Lines=CASES["edges"][1], InsidePositions=[3, 4, 0])
messages = harness.messages_of(between.UpdatePipeline)
assert "Point 0 of InsidePositions lies on a line, between 2 regions" in messages, messages
