// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceLinesActor
 * @brief an actor whose lines are seen in full width on the surface in which they lie
 *
 * A line of several pixels that lies in faces sinks into them, because each of its pixels is
 * compared with the depth of the surface at that pixel. This actor is drawn a little nearer to the
 * camera: by as many pixels as LeadPerPixel times the line width, plus Lead. It moves along the
 * rays to the eye, so that nothing moves in the picture. What lies farther in front than that still
 * hides the lines.
 *
 * Where the surface rises by s pixels towards the camera in a pixel beside the line, a lead of d
 * pixels lets d / s pixels of that half of the line be seen. With the values here a line of 4
 * pixels is at least 3 pixels wide up to s = 14, which is 86 degrees away from facing the camera.
 * The price is that a line behind a part thinner than the lead, as seen along the ray, shines
 * through it.
 *
 * The data keep their place: GetMatrix, bounds and picking do not know of the lead.
 */
#ifndef vtkSurfaceLinesActor_h
#define vtkSurfaceLinesActor_h

#include "vtkPVLODActor.h"
#include "vtkWidgetsLinesModule.h" // For the export macro

class VTKWIDGETSLINES_EXPORT vtkSurfaceLinesActor : public vtkPVLODActor
{
public:
  static vtkSurfaceLinesActor* New();
  vtkTypeMacro(vtkSurfaceLinesActor, vtkPVLODActor);

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

  /**
   * Whether light makes the lines darker and brighter. Default: false. From ParaView 5.13 on a
   * representation sets the same of its property in every update, so it is set again before
   * drawing.
   */
  void SetLit(bool isLit) { this->IsLit = isLit; }

  ///@{
  /** While it renders, this is where it is drawn; else where the data are. */
  using vtkPVLODActor::GetMatrix;
  void GetMatrix(vtkMatrix4x4* result) override;
  ///@}

protected:
  vtkSurfaceLinesActor() = default;
  ~vtkSurfaceLinesActor() override = default;

private:
  static constexpr double LeadPerPixel = 3.0;
  static constexpr double Lead = 2.0;

  vtkRenderer* Renderer = nullptr;
  bool IsLit = false;

  vtkSurfaceLinesActor(const vtkSurfaceLinesActor&) = delete;
  void operator=(const vtkSurfaceLinesActor&) = delete;
};

#endif
