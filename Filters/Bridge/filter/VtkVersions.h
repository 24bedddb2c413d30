// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VtkVersions.h
 * @brief What differs from one version of VTK to another, each with the version that needs it.
 *
 * ParaView 5.11 has VTK 9.2, 5.13 has 9.3, and 6.1 has 9.6. What differs in ParaView's client is in
 * Widgets/Seeds/ParaViewVersions.h, and what differs for CMake in Plugin/CMake/Versions.cmake.
 */
#ifndef geodesic_bridge_VtkVersions_h
#define geodesic_bridge_VtkVersions_h

#include "vtkCellArray.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArrayRange.h"
#include "vtkDataObjectTree.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"
#if __has_include("vtkCellTypeUtilities.h")
#include "vtkCellTypeUtilities.h"
#else
#include "vtkCellTypes.h"
#endif

class vtkIdList;

namespace geodesic::bridge
{

// --- Abort: VTK 9.1 has AbortExecute only, which the executive resets before each run. Later
// versions mark an incomplete output by a flag of its own, and abort a filter as well when a filter
// upstream was aborted. ---

/** Returns whether a running filter must stop. If so, its output counts as aborted. */
template <class Filter>
bool checkAbort(Filter& filter)
{
  if constexpr (requires { filter.CheckAbort(); })
  {
    return filter.CheckAbort();
  }
  else
  {
    return filter.GetAbortExecute() != 0;
  }
}

/** Marks the output of a filter as incomplete. */
template <class Filter>
void setAborted(Filter& filter)
{
  if constexpr (requires { filter.SetAbortOutput(true); })
  {
    filter.SetAbortOutput(true);
  }
  else
  {
    filter.SetAbortExecute(1);
  }
}

/** Returns whether the output of a filter is marked as incomplete. */
template <class Filter>
bool isAborted(Filter& filter)
{
  if constexpr (requires { filter.GetAbortOutput(); })
  {
    return filter.GetAbortOutput();
  }
  else
  {
    return filter.GetAbortExecute() != 0;
  }
}

// --- Cells: VTK 9.6 stores cells in more ways and has Dispatch for all of them. Its Visit, the
// only way before, does nothing for cells of one size and for arrays of any other kind. ---

/**
 * Calls @p work with the offsets and the connectivity of the cells, as ranges of integers, whatever
 * they are stored as.
 */
template <class CellArray, class Work>
void withOffsetsAndConnectivity(CellArray& cells, Work&& work)
{
  if constexpr (requires { typename CellArray::DispatchUtilities; })
  {
    cells.Dispatch(
      [&](auto* offsets, auto* connectivity)
      {
        work(vtk::DataArrayValueRange<1, vtkIdType>(offsets),
          vtk::DataArrayValueRange<1, vtkIdType>(connectivity));
      });
  }
  else
  {
    cells.Visit(
      [&](auto& state)
      {
        work(vtk::DataArrayValueRange<1>(state.GetOffsets()),
          vtk::DataArrayValueRange<1>(state.GetConnectivity()));
      });
  }
}

/** Cuts a polygon into triangles, as ids in the polygon. False if it can't. VTK 9.3 renamed it. */
template <class Polygon>
bool triangulate(Polygon& polygon, vtkIdList* corners)
{
  if constexpr (requires { polygon.TriangulateLocalIds(0, corners); })
  {
    return polygon.TriangulateLocalIds(0, corners) != 0;
  }
  else
  {
    return polygon.Triangulate(corners) != 0;
  }
}

/** Whether cells of a type have straight edges and flat faces. VTK 9.6 has it in another class. */
inline bool isLinear(int cellType)
{
#if __has_include("vtkCellTypeUtilities.h")
  using CellTypes = vtkCellTypeUtilities;
#else
  using CellTypes = vtkCellTypes;
#endif
  return CellTypes::IsLinear(static_cast<unsigned char>(cellType)) != 0;
}

/** The array of the types of a grid's cells. VTK 9.6 may store it as any array. */
template <class Grid>
vtkObject* cellTypesOf(Grid& grid)
{
  if constexpr (requires { grid.GetCellTypes(); })
  {
    return grid.GetCellTypes();
  }
  else
  {
    return grid.GetCellTypesArray();
  }
}

/** The faces of a grid's polyhedra, null if it has none. VTK 9.4 stores them as cells. */
template <class Grid>
vtkObject* polyhedronFacesOf(Grid& grid)
{
  if constexpr (requires { grid.GetPolyhedronFaces(); })
  {
    return grid.GetPolyhedronFaces();
  }
  else
  {
    return grid.GetFaces();
  }
}

// --- Blocks ---

/**
 * Whether an input has levels that overlap each other (AMR). In VTK 9.6 those are a tree of data
 * sets as other blocks are.
 */
inline bool hasOverlappingLevels(vtkDataObject* input)
{
  return vtkCompositeDataSet::SafeDownCast(input) &&
    (!vtkDataObjectTree::SafeDownCast(input) || input->IsA("vtkAMRDataObject"));
}

// What users of ParaView are told to do for global ids. From ParaView 5.13 on (VTK 9.3.20240617)
// the filter that makes them has another name, and counts from 0 in every block.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240617)
constexpr const char* MakeGlobalIds = "by Global Point And Cell Ids";
constexpr const char* MakeGlobalIdsOfBlocks =
  "by a Programmable Filter, because Global Point And Cell Ids counts from 0 in every block";
#else
constexpr const char* MakeGlobalIds = "by Generate Global Ids";
constexpr const char* MakeGlobalIdsOfBlocks = MakeGlobalIds;
#endif

}

#endif
