// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The functions of vtkSurfaceGeodesicDistance that set its seeds and destinations.
#include "vtkSurfaceGeodesicDistance.h"

#include "vtkIdTypeArray.h"

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::ClearSeedPositions()
{
  this->SeedCoordinates.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AddSeedPosition(double x, double y, double z)
{
  this->SeedCoordinates.insert(this->SeedCoordinates.end(), { x, y, z });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AddSeedCoordinate(double coordinate)
{
  this->SeedCoordinates.push_back(coordinate);
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicDistance::GetNumberOfSeedCoordinates()
{
  return static_cast<int>(this->SeedCoordinates.size());
}

//------------------------------------------------------------------------------
double vtkSurfaceGeodesicDistance::GetSeedCoordinate(int index)
{
  if (index < 0 || index >= this->GetNumberOfSeedCoordinates())
  {
    vtkErrorMacro(<< "There is no seed coordinate " << index << "; there are "
                  << this->GetNumberOfSeedCoordinates() << ", numbered from 0.");
    return 0.0;
  }
  return this->SeedCoordinates[index];
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::ClearSeedPointIds()
{
  this->SeedPointIds->Reset();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AddSeedPointId(vtkIdType id)
{
  this->SeedPointIds->InsertNextId(id);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::SetSeedSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(SEED_SOURCE_PORT, source);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::SetSeedSelectionConnection(vtkAlgorithmOutput* selection)
{
  this->SetInputConnection(SEED_SELECTION_PORT, selection);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::ClearDestinationPositions()
{
  this->DestinationCoordinates.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AddDestinationCoordinate(double coordinate)
{
  this->DestinationCoordinates.push_back(coordinate);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::ClearDestinationPointIds()
{
  this->DestinationPointIds->Reset();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AddDestinationPointId(vtkIdType id)
{
  this->DestinationPointIds->InsertNextId(id);
  this->Modified();
}
