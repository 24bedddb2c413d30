// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceLinesRepresentation
 * @brief shows lines in front of the surface on which they lie, by a vtkSurfaceLinesActor
 *
 * The lines are also drawn in full while the camera moves: the coarse data that ParaView then draws
 * of large surfaces would have no lines left.
 */
#ifndef vtkSurfaceLinesRepresentation_h
#define vtkSurfaceLinesRepresentation_h

#include "vtkGeometryRepresentation.h"
#include "vtkWidgetsLinesModule.h" // For the export macro

class vtkSurfaceLinesActor;

class VTKWIDGETSLINES_EXPORT vtkSurfaceLinesRepresentation : public vtkGeometryRepresentation
{
public:
  static vtkSurfaceLinesRepresentation* New();
  vtkTypeMacro(vtkSurfaceLinesRepresentation, vtkGeometryRepresentation);

  /**
   * Whether the lines are lit like tubes. Default: off, which gives them one plain colour.
   */
  void SetRenderLinesAsTubes(bool isOn) override;

protected:
  vtkSurfaceLinesRepresentation();
  ~vtkSurfaceLinesRepresentation() override = default;

private:
  /** The superclass's Actor. */
  vtkSurfaceLinesActor* Lines = nullptr;

  vtkSurfaceLinesRepresentation(const vtkSurfaceLinesRepresentation&) = delete;
  void operator=(const vtkSurfaceLinesRepresentation&) = delete;
};

#endif
