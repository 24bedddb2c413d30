// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PointSource_h
#define geodesic_bridge_PointSource_h

#include <cstddef>
#include <vector>

class vtkDataObject;

namespace geodesic::bridge
{

/** The points and lines of a data set, or of all blocks of a composite one. */
struct PointSource
{
  explicit PointSource(vtkDataObject* data);

  /** x y z of each point in turn. */
  std::vector<double> coordinates;
  /** The point numbers of each line and polyline. Lines without points are left out. */
  std::vector<std::vector<std::size_t>> lines;
};

}

#endif
