// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PixelTriangles.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seeds
{
namespace
{

/** A point as drawn: x and y in pixels from the lower left corner, the depth, and 1 / w. */
struct DrawnPoint
{
  double x;
  double y;
  double depth;
  double inverseW;
};

/** Empty if a point is not in front of the camera. */
std::vector<DrawnPoint> draw(
  vtkPolyData* surface, const std::array<double, 16>& toClip, int width, int height)
{
  std::vector<DrawnPoint> drawn(surface->GetNumberOfPoints());
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    double point[3];
    surface->GetPoint(static_cast<vtkIdType>(i), point);
    std::array<double, 4> clip;
    for (int row = 0; row < 4; ++row)
    {
      const double* m = toClip.data() + 4 * row;
      clip[row] = m[0] * point[0] + m[1] * point[1] + m[2] * point[2] + m[3];
    }
    if (!(clip[3] > 0.0))
    {
      return {};
    }
    const double inverse = 1.0 / clip[3];
    drawn[i] = { 0.5 * (clip[0] * inverse + 1.0) * width, 0.5 * (clip[1] * inverse + 1.0) * height,
      clip[2] * inverse, inverse };
  }
  return drawn;
}

/** The pixels, counted from 0, whose centres lie between two coordinates; clipped to a size. */
std::array<int, 2> pixelsBetween(double low, double high, int size)
{
  const double last = size - 1.0;
  return { static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, last + 1.0)),
    static_cast<int>(std::clamp(std::floor(high - 0.5), -1.0, last)) };
}

/** Draws triangles into a grid of pixels, the nearest in front. */
class Rasteriser
{
public:
  Rasteriser(const std::vector<DrawnPoint>& points, int width, int height)
    : Points(points)
    , Width(width)
    , Height(height)
    , Pixels(static_cast<std::size_t>(width) * height)
    , Depths(this->Pixels.size(), std::numeric_limits<float>::infinity())
  {
  }

  void add(const std::array<int, 3>& ids)
  {
    const DrawnPoint& a = this->Points[ids[0]];
    const DrawnPoint& b = this->Points[ids[1]];
    const DrawnPoint& c = this->Points[ids[2]];
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (!(std::abs(area) > 0.0))
    {
      return;
    }
    const double inverse = 1.0 / area;
    const auto columns =
      pixelsBetween(std::min({ a.x, b.x, c.x }), std::max({ a.x, b.x, c.x }), this->Width);
    const auto rows =
      pixelsBetween(std::min({ a.y, b.y, c.y }), std::max({ a.y, b.y, c.y }), this->Height);
    for (int row = rows[0]; row <= rows[1]; ++row)
    {
      for (int column = columns[0]; column <= columns[1]; ++column)
      {
        const double x = column + 0.5;
        const double y = row + 0.5;
        const double atA = ((b.x - x) * (c.y - y) - (c.x - x) * (b.y - y)) * inverse;
        const double atB = ((c.x - x) * (a.y - y) - (a.x - x) * (c.y - y)) * inverse;
        const double atC = 1.0 - atA - atB;
        if (std::min({ atA, atB, atC }) >= -Rounding)
        {
          this->put(static_cast<std::size_t>(row) * this->Width + column, ids,
            atA * a.depth + atB * b.depth + atC * c.depth,
            { atA * a.inverseW, atB * b.inverseW, atC * c.inverseW });
        }
      }
    }
  }

  std::vector<PixelTriangle> take() { return std::move(this->Pixels); }

private:
  /** A centre on an edge must not fall between the two triangles. */
  static constexpr double Rounding = 1e-9;

  void put(std::size_t pixel, const std::array<int, 3>& ids, double depth,
    const std::array<double, 3>& shares)
  {
    if (depth < 0.0 || depth > 1.0 || depth >= this->Depths[pixel])
    {
      return;
    }
    this->Depths[pixel] = static_cast<float>(depth);
    const double inverse = 1.0 / (shares[0] + shares[1] + shares[2]);
    this->Pixels[pixel] = { ids,
      { static_cast<float>(shares[0] * inverse), static_cast<float>(shares[1] * inverse),
        static_cast<float>(shares[2] * inverse) } };
  }

  const std::vector<DrawnPoint>& Points;
  int Width;
  int Height;
  std::vector<PixelTriangle> Pixels;
  std::vector<float> Depths;
};

}

std::vector<PixelTriangle> findPixelTriangles(
  vtkPolyData* surface, const std::array<double, 16>& toClip, int width, int height)
{
  if (surface->GetNumberOfPoints() > std::numeric_limits<int>::max())
  {
    return {};
  }
  const std::vector<DrawnPoint> points = draw(surface, toClip, width, height);
  if (points.empty())
  {
    return {};
  }
  Rasteriser rasteriser(points, width, height);
  vtkCellArray* polygons = surface->GetPolys();
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (polygons->InitTraversal(); polygons->GetNextCell(count, ids);)
  {
    for (vtkIdType i = 2; i < count; ++i)
    {
      rasteriser.add(
        { static_cast<int>(ids[0]), static_cast<int>(ids[i - 1]), static_cast<int>(ids[i]) });
    }
  }
  return rasteriser.take();
}

}
