// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_PixelTriangles_h
#define seeds_PixelTriangles_h

#include <array>
#include <vector>

class vtkPolyData;

namespace seeds
{

/** The part of a surface at a pixel: a value there is the sum of the points' values by weights. */
struct PixelTriangle
{
  /** Point ids; the first is -1 where the surface is not. */
  std::array<int, 3> points{ -1, -1, -1 };
  std::array<float, 3> weights{};

  bool isEmpty() const { return this->points[0] < 0; }
};

/**
 * Finds the nearest triangle of a surface at the centre of each pixel of a picture. Polygons of
 * more than three corners count as fans.
 * @param toClip  4 x 4, by rows: from the surface's space to clip coordinates with depths 0 to 1
 * @return width x height, by rows from the lowest; empty if a point is not in front of the camera,
 *         or there are more points than an int can count
 */
std::vector<PixelTriangle> findPixelTriangles(
  vtkPolyData* surface, const std::array<double, 16>& toClip, int width, int height);

}

#endif
