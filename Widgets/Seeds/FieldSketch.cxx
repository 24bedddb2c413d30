// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FieldSketch.h"

#include "ColorTable.h"
#include "SeedOverlay.h"
#include "ViewGeometry.h"

#include "pqRenderView.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace seeds
{
namespace
{

/** Half of white, so that light of more than one is not cut off. */
constexpr int GreyLevel = 128;

vtkSmartPointer<vtkScalarsToColors> plainMap(int grey)
{
  const double level = grey / 255.0;
  auto map = vtkSmartPointer<vtkLookupTable>::New();
  map->SetNumberOfTableValues(2);
  map->SetTableValue(0, level, level, level);
  map->SetTableValue(1, level, level, level);
  map->SetNanColor(level, level, level, 1.0);
  return map;
}

/** Whether a view draws each pixel in proportion to the colour of what it shows. */
bool isLinear(pqRenderView* view)
{
  for (const char* name : { "EnableRayTracing", "UseToneMapping" })
  {
    vtkSMProxy* proxy = view->getProxy();
    if (proxy->GetProperty(name) && vtkSMPropertyHelper(proxy, name).GetAsInt() != 0)
    {
      return false;
    }
  }
  return true;
}

vtkRenderWindow* windowOf(pqRenderView* view)
{
  return vtkRenderWindow::SafeDownCast(view->getRenderViewProxy()->GetRenderer()->GetVTKWindow());
}

std::array<double, 16> toClip(pqRenderView* view, vtkActor* actor)
{
  vtkRenderer* renderer = view->getRenderViewProxy()->GetRenderer();
  vtkNew<vtkMatrix4x4> matrix;
  vtkMatrix4x4::Multiply4x4(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
                              renderer->GetTiledAspectRatio(), 0.0, 1.0),
    actor->GetMatrix(), matrix);
  std::array<double, 16> elements;
  std::copy_n(matrix->GetData(), elements.size(), elements.begin());
  return elements;
}

/** Gives an empty pixel what one beside it has: pixels at an outline belong to the surface in part.
 */
PixelTriangle nearestTriangle(
  const std::vector<PixelTriangle>& triangles, int x, int y, int width, int height)
{
  constexpr int reach = 2;
  for (int radius = 0; radius <= reach; ++radius)
  {
    for (int row = std::max(y - radius, 0); row <= std::min(y + radius, height - 1); ++row)
    {
      for (int column = std::max(x - radius, 0); column <= std::min(x + radius, width - 1);
           ++column)
      {
        const PixelTriangle& triangle = triangles[static_cast<std::size_t>(row) * width + column];
        if (!triangle.isEmpty())
        {
          return triangle;
        }
      }
    }
  }
  return {};
}

std::vector<float> valuesOf(vtkDataArray* array)
{
  const vtkIdType count = array->GetNumberOfTuples();
  if (auto* numbers = vtkFloatArray::SafeDownCast(array))
  {
    return { numbers->GetPointer(0), numbers->GetPointer(0) + count };
  }
  if (auto* numbers = vtkDoubleArray::SafeDownCast(array))
  {
    return { numbers->GetPointer(0), numbers->GetPointer(0) + count };
  }
  std::vector<float> values;
  for (vtkIdType i = 0; i < count; ++i)
  {
    values.push_back(static_cast<float>(array->GetComponent(i, 0)));
  }
  return values;
}

}

FieldSketch::FieldSketch(vtkSMProxy* filter)
  : Filter(filter)
{
}

FieldSketch::~FieldSketch()
{
  this->end();
}

QByteArray FieldSketch::arrayNameOf(vtkActor* actor, vtkPolyData* surface) const
{
  vtkMapper* mapper = actor->GetMapper();
  vtkProperty* property = actor->GetProperty();
  const bool isOneSurface = surface->GetNumberOfPolys() > 0 && surface->GetNumberOfVerts() == 0 &&
    surface->GetNumberOfLines() == 0 && surface->GetNumberOfStrips() == 0;
  const bool isWhole = property->GetRepresentation() == VTK_SURFACE &&
    property->GetOpacity() == 1.0 && !property->GetBackfaceCulling() &&
    !property->GetFrontfaceCulling() && !actor->GetTexture() &&
    mapper->GetNumberOfClippingPlanes() == 0;
  const bool isMapped = mapper->GetScalarVisibility() &&
    mapper->GetInterpolateScalarsBeforeMapping() &&
    mapper->GetScalarMode() == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA &&
    mapper->GetLookupTable()->IsOpaque() && !mapper->GetLookupTable()->GetIndexedLookup();
  const char* name = mapper->GetArrayName();
  vtkDataArray* array = name ? surface->GetPointData()->GetArray(name) : nullptr;
  return isOneSurface && isWhole && isMapped && array && array->GetNumberOfComponents() == 1
    ? QByteArray(name)
    : QByteArray();
}

FieldSketch::Conditions FieldSketch::conditions() const
{
  vtkPolyData* surface = outputOf(this->Filter);
  const int* size = windowOf(this->View)->GetSize();
  return { surface->GetPoints(), surface->GetMeshMTime(), cameraTimeOf(this->View),
    this->Mapper->GetLookupTable()->GetMTime(), { size[0], size[1] } };
}

bool FieldSketch::begin(pqRenderView* view, SeedOverlay* overlay, double)
{
  vtkPolyData* surface = outputOf(this->Filter);
  vtkActor* actor = surface && ViewGeometry(view).isDrawnHere() && isLinear(view)
    ? soleActorIn(view, this->Filter)
    : nullptr;
  this->ArrayName = actor ? this->arrayNameOf(actor, surface) : QByteArray();
  if (this->ArrayName.isEmpty())
  {
    return false;
  }
  this->View = view;
  this->Mapper = actor->GetMapper();
  const auto lit = this->pictureWith(GreyLevel);
  const auto base = this->pictureWith(0);
  const int* size = windowOf(view)->GetSize();
  const auto triangles = findPixelTriangles(surface, toClip(view, actor), size[0], size[1]);
  if (triangles.empty() || lit.size() != base.size() || lit.size() != 3 * triangles.size())
  {
    return false;
  }
  this->Picture = QImage(size[0], size[1], QImage::Format_RGB32);
  this->Picture.setDevicePixelRatio(ViewGeometry(view).pixelsPerPoint());
  this->collectPixels(triangles, lit, base);
  this->Overlay = overlay;
  this->Begun = this->conditions();
  return true;
}

std::vector<std::uint8_t> FieldSketch::pictureWith(int grey) const
{
  vtkSmartPointer<vtkScalarsToColors> colors = this->Mapper->GetLookupTable();
  this->Mapper->SetLookupTable(plainMap(grey));
  this->View->forceRender();
  this->Mapper->SetLookupTable(colors);
  vtkRenderWindow* window = windowOf(this->View);
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}

void FieldSketch::collectPixels(const std::vector<PixelTriangle>& triangles,
  const std::vector<std::uint8_t>& lit, const std::vector<std::uint8_t>& base)
{
  this->Pixels.clear();
  const int width = this->Picture.width();
  const int height = this->Picture.height();
  for (int y = 0; y < height; ++y)
  {
    auto* line = reinterpret_cast<QRgb*>(this->Picture.scanLine(height - 1 - y));
    const std::size_t lineBegin =
      static_cast<std::size_t>(height - 1 - y) * this->Picture.bytesPerLine();
    for (int x = 0; x < width; ++x)
    {
      const std::size_t at = 3 * (static_cast<std::size_t>(y) * width + x);
      line[x] = qRgb(base[at], base[at + 1], base[at + 2]);
      Pixel pixel{ lineBegin + sizeof(QRgb) * x, {}, {}, {} };
      for (int color = 0; color < 3; ++color)
      {
        pixel.base[color] = base[at + color];
        pixel.light[color] =
          static_cast<std::uint8_t>(std::max(int{ lit[at + color] } - base[at + color], 0));
      }
      if (pixel.light != std::array<std::uint8_t, 3>{})
      {
        pixel.triangle = nearestTriangle(triangles, x, y, width, height);
        if (!pixel.triangle.isEmpty())
        {
          this->Pixels.push_back(pixel);
        }
      }
    }
  }
}

bool FieldSketch::update()
{
  if (!this->View || !this->Overlay)
  {
    return false;
  }
  vtkSMSourceProxy::SafeDownCast(this->Filter)->UpdatePipeline();
  vtkPolyData* surface = outputOf(this->Filter);
  vtkDataArray* array =
    surface ? surface->GetPointData()->GetArray(this->ArrayName.constData()) : nullptr;
  if (!array || this->conditions() != *this->Begun)
  {
    return false;
  }
  const std::vector<float> values = valuesOf(array);
  const ColorTable table(this->Mapper->GetLookupTable());
  uchar* bytes = this->Picture.bits();
  for (const Pixel& pixel : this->Pixels)
  {
    const auto& [points, weights] = pixel.triangle;
    const float value = weights[0] * values[points[0]] + weights[1] * values[points[1]] +
      weights[2] * values[points[2]];
    const ColorTable::Color& color = table.at(value);
    std::array<int, 3> rgb;
    for (int i = 0; i < 3; ++i)
    {
      rgb[i] =
        std::min(pixel.base[i] + (pixel.light[i] * color[i] + GreyLevel / 2) / GreyLevel, 255);
    }
    *reinterpret_cast<QRgb*>(bytes + pixel.offset) = qRgb(rgb[0], rgb[1], rgb[2]);
  }
  this->Overlay->setPicture(this->Picture);
  return true;
}

void FieldSketch::end()
{
  if (!this->Begun)
  {
    return;
  }
  this->Begun.reset();
  this->Pixels = {};
  this->Picture = {};
  this->Mapper = nullptr;
  if (this->Overlay)
  {
    this->Overlay->setPicture({});
  }
}

}
