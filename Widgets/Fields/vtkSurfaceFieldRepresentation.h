// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceFieldRepresentation
 * @brief shows a surface, and shows it again in less time where only its arrays have changed
 *
 * A filter that computes a field on a surface hands over the surface's own points and cells in
 * each run. Where they are those of the run before, this representation extracts no geometry again,
 * and its mapper gives the graphics card the colours alone. In all other respects, and on several
 * ranks in all, it is its superclass.
 */
#ifndef vtkSurfaceFieldRepresentation_h
#define vtkSurfaceFieldRepresentation_h

#include "vtkGeometryRepresentation.h"
#include "vtkSmartPointer.h"
#include "vtkWidgetsFieldsModule.h" // For the export macro

class vtkPolyData;

class VTKWIDGETSFIELDS_EXPORT vtkSurfaceFieldRepresentation : public vtkGeometryRepresentation
{
public:
  static vtkSurfaceFieldRepresentation* New();
  vtkTypeMacro(vtkSurfaceFieldRepresentation, vtkGeometryRepresentation);

protected:
  vtkSurfaceFieldRepresentation();
  ~vtkSurfaceFieldRepresentation() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  /** Whether the geometry of the run before is that of an input, but for the values of arrays. */
  bool IsKept(vtkPolyData* input);
  /** Gives the geometry of the run before the arrays of an input. */
  void TakeArrays(vtkPolyData* input);
  /** What is drawn of a single surface; null if that is something else. */
  vtkPolyData* GetGeometry();
  /** When something was set that the geometry depends on. */
  vtkMTimeType GetSettingsTime();

  /** The input of the run that made the geometry; null if that was no polygonal data. */
  vtkSmartPointer<vtkPolyData> Extracted;
  /** When that run was. */
  vtkMTimeType ExtractionTime = 0;

  vtkSurfaceFieldRepresentation(const vtkSurfaceFieldRepresentation&) = delete;
  void operator=(const vtkSurfaceFieldRepresentation&) = delete;
};

#endif
