// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFile.h"

#include "vtkNew.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <vtksys/SystemTools.hxx>

#include <stdexcept>

namespace geodesic::examples
{

void requireFile(const std::string& file)
{
  if (!vtksys::SystemTools::FileExists(file, true))
  {
    throw std::runtime_error("The file " + file + " does not exist.");
  }
}

vtkSmartPointer<vtkPolyData> readSurface(const std::string& file)
{
  requireFile(file);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkSmartPointer<vtkPolyData> surface = reader->GetOutput();
  if (surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
  {
    throw std::runtime_error("The file " + file + " holds no surface. Give a .vtp with triangles.");
  }
  return surface;
}

void writeSurface(vtkPolyData* surface, const std::string& file)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName(file.c_str());
  // Debian 12's ParaView cannot read appended data.
  writer->SetDataModeToBinary();
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw std::runtime_error("The file " + file + " cannot be written.");
  }
}

}
