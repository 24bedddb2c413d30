// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceFieldHelper
 * @brief the part of vtkSurfaceFieldMapper that fills the graphics card's buffers
 *
 * Where only the values have changed that colour the points, only these are sent.
 */
#ifndef vtkSurfaceFieldHelper_h
#define vtkSurfaceFieldHelper_h

#include "vtkCompositeMapperHelper2.h"

#include <cstdint>
#include <vector>

class vtkSurfaceFieldHelper : public vtkCompositeMapperHelper2
{
public:
  static vtkSurfaceFieldHelper* New();
  vtkTypeMacro(vtkSurfaceFieldHelper, vtkCompositeMapperHelper2);

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkSurfaceFieldHelper() = default;
  ~vtkSurfaceFieldHelper() override = default;

  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;

private:
  /** All but the colours on which the buffers depend; empty if that can't be told. */
  std::vector<std::uintptr_t> DescribeBuffers(vtkRenderer* renderer, vtkActor* actor);
  /** Computes the places of the points' values in the colour map; false if they have none. */
  bool MapToCoordinates();

  /** What the buffers were made for; empty if the colours can't be sent alone. */
  std::vector<std::uintptr_t> Description;

  vtkSurfaceFieldHelper(const vtkSurfaceFieldHelper&) = delete;
  void operator=(const vtkSurfaceFieldHelper&) = delete;
};

#endif
