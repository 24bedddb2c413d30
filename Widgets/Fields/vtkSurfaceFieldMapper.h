// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceFieldMapper
 * @brief a mapper that notices where its input has only new arrays
 *
 * ParaView's views hand a mapper a new data object after each run of a filter. Where that is one
 * surface with the points and cells of the one before, this mapper goes on with the data object
 * that it had and gives that the new arrays. So bounds and shaders are kept, and
 * vtkSurfaceFieldHelper keeps the buffers.
 */
#ifndef vtkSurfaceFieldMapper_h
#define vtkSurfaceFieldMapper_h

#include "vtkCompositePolyDataMapper2.h"
#include "vtkSmartPointer.h"

class vtkMultiBlockDataSet;

class vtkSurfaceFieldMapper : public vtkCompositePolyDataMapper2
{
public:
  static vtkSurfaceFieldMapper* New();
  vtkTypeMacro(vtkSurfaceFieldMapper, vtkCompositePolyDataMapper2);

  using vtkAlgorithm::SetInputDataObject;
  void SetInputDataObject(int port, vtkDataObject* data) override;

protected:
  vtkSurfaceFieldMapper();
  ~vtkSurfaceFieldMapper() override;

  vtkCompositeMapperHelper2* CreateHelper() override;

private:
  /** Lets the data object that is drawn have the arrays of another; false if it can't. */
  bool TakeArrays(vtkDataObject* data);

  /** What was given last. */
  vtkSmartPointer<vtkDataObject> Given;
  vtkMTimeType GivenTime = 0;
  /** What is drawn in its place; null if that is what was given. */
  vtkSmartPointer<vtkMultiBlockDataSet> Drawn;

  vtkSurfaceFieldMapper(const vtkSurfaceFieldMapper&) = delete;
  void operator=(const vtkSurfaceFieldMapper&) = delete;
};

#endif
