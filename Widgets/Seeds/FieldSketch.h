// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_FieldSketch_h
#define seeds_FieldSketch_h

#include "PixelTriangles.h"
#include "Sketch.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <QByteArray>
#include <QImage>
#include <QPointer>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

class vtkMapper;

namespace seeds
{

/**
 * Draws a field on a surface over a view, where only the field changes.
 *
 * The light on a pixel does not depend on the surface's colour, so the picture is base + light x
 * colour. Two pictures of the scene, with a black and with a grey surface, give both at each pixel;
 * what is in front of the surface has no share of it there. Then a new field costs one look-up in
 * the colour map for each pixel.
 *
 * It can do so where the filter runs in this process, and one opaque surface is shown in this view
 * alone, coloured by an array of points through a map of continuous values.
 */
class FieldSketch : public Sketch
{
public:
  explicit FieldSketch(vtkSMProxy* filter);
  ~FieldSketch() override;

  bool begin(pqRenderView* view, SeedOverlay* overlay, double tolerance) override;
  bool update() override;
  void end() override;

private:
  /** A pixel of the picture in which the surface is seen. */
  struct Pixel
  {
    /** Where its colour begins in the picture, in bytes. */
    std::size_t offset;
    PixelTriangle triangle;
    /** In parts of GreyLevel: red, green, blue. */
    std::array<std::uint8_t, 3> light;
    std::array<std::uint8_t, 3> base;
  };
  /** What must stay as it is for the pictures to be right. */
  struct Conditions
  {
    void* mesh;
    vtkMTimeType meshTime;
    vtkMTimeType camera;
    vtkMTimeType colors;
    std::array<int, 2> size;

    bool operator==(const Conditions&) const = default;
  };

  /** The name of the array that colours a surface; empty if a sketch can't show it. */
  QByteArray arrayNameOf(vtkActor* actor, vtkPolyData* surface) const;
  Conditions conditions() const;
  /** The scene with the surface in one grey, as RGB by rows from the lowest. */
  std::vector<std::uint8_t> pictureWith(int grey) const;
  void collectPixels(const std::vector<PixelTriangle>& triangles,
    const std::vector<std::uint8_t>& lit, const std::vector<std::uint8_t>& base);

  vtkSmartPointer<vtkSMProxy> Filter;
  QPointer<pqRenderView> View;
  QPointer<SeedOverlay> Overlay;
  vtkSmartPointer<vtkMapper> Mapper;
  QByteArray ArrayName;
  std::optional<Conditions> Begun;
  QImage Picture;
  std::vector<Pixel> Pixels;
};

}

#endif
