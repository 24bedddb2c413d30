// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceFieldMapper.h"

#include "SameMesh.h"
#include "vtkSurfaceFieldHelper.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

vtkStandardNewMacro(vtkSurfaceFieldMapper);

namespace
{

/** The only surface of some blocks; null if they are others. */
vtkPolyData* onlySurface(vtkDataObject* data)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data);
  return blocks && blocks->GetNumberOfBlocks() == 1 ? vtkPolyData::SafeDownCast(blocks->GetBlock(0))
                                                    : nullptr;
}

}

vtkSurfaceFieldMapper::vtkSurfaceFieldMapper() = default;

vtkSurfaceFieldMapper::~vtkSurfaceFieldMapper() = default;

void vtkSurfaceFieldMapper::SetInputDataObject(int port, vtkDataObject* data)
{
  if (data && data == this->Given && data->GetMTime() == this->GivenTime)
  {
    return;
  }
  this->Given = data;
  this->GivenTime = data ? data->GetMTime() : 0;
  if (this->TakeArrays(data))
  {
    return;
  }
  this->Drawn = nullptr;
  if (onlySurface(data))
  {
    this->Drawn = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    this->Drawn->ShallowCopy(data);
  }
  this->Superclass::SetInputDataObject(port, this->Drawn ? this->Drawn : data);
}

bool vtkSurfaceFieldMapper::TakeArrays(vtkDataObject* data)
{
  vtkPolyData* given = onlySurface(data);
  vtkPolyData* drawn = onlySurface(this->Drawn);
  if (!given || !drawn || !haveSameMesh(given, drawn))
  {
    return false;
  }
  drawn->GetPointData()->ShallowCopy(given->GetPointData());
  drawn->GetCellData()->ShallowCopy(given->GetCellData());
  drawn->GetFieldData()->ShallowCopy(given->GetFieldData());
  this->Drawn->Modified();
  return true;
}

vtkCompositeMapperHelper2* vtkSurfaceFieldMapper::CreateHelper()
{
  return vtkSurfaceFieldHelper::New();
}
