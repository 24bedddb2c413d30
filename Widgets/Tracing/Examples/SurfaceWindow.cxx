// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceWindow.h"

#include "SurfaceFile.h"

#include "vtkCamera.h"
#include "vtkCellPicker.h"
#include "vtkInteractorEventRecorder.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkWindowToImageFilter.h"

#include <stdexcept>

namespace geodesic::examples
{

SurfaceWindow::SurfaceWindow(
  const std::string& title, vtkPolyData* surface, const RunOptions& options)
  : Options(options)
{
  // The placer needs normals of cells for a height offset. Without splitting, the points stay the
  // same.
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->ComputeCellNormalsOn();
  normals->Update();
  this->Shown = normals->GetOutput();
  this->Locator->SetDataSet(this->Shown);
  this->Locator->BuildLocator();

  this->Mapper->SetInputData(this->Shown);
  this->Mapper->ScalarVisibilityOff();
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetProperty()->SetColor(0.75, 0.72, 0.66);
  this->Actor->GetProperty()->SetSpecular(0.15);
  this->Actor->GetProperty()->SetSpecularPower(20.0);
  this->Renderer->AddActor(this->Actor);
  this->Renderer->SetBackground(1.0, 1.0, 1.0);
  this->Renderer->ResetCamera();
  this->Renderer->GetActiveCamera()->Zoom(1.2);

  this->Window->SetSize(640, 480);
  this->Window->SetMultiSamples(8);
  this->Window->SetWindowName(title.c_str());
  this->Window->SetOffScreenRendering(options.isUnattended());
  this->Window->AddRenderer(this->Renderer);
  this->Interactor->SetRenderWindow(this->Window);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  style->SetDefaultRenderer(this->Renderer);
  this->Interactor->SetInteractorStyle(style);
  this->Interactor->Initialize();
}

std::optional<vtkIdType> SurfaceWindow::pointAt(int x, int y)
{
  vtkNew<vtkCellPicker> picker;
  picker->AddPickList(this->Actor);
  picker->PickFromListOn();
  picker->AddLocator(this->Locator);
  if (!picker->Pick(x, y, 0.0, this->Renderer))
  {
    return std::nullopt;
  }
  return picker->GetPointId();
}

void SurfaceWindow::run()
{
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(this->Interactor);
  this->Window->Render();
  if (!this->Options.events.empty())
  {
    requireFile(this->Options.events);
    recorder->SetFileName(this->Options.events.c_str());
    recorder->Play();
  }
  if (this->Options.isUnattended())
  {
    return;
  }
  if (!this->Options.record.empty())
  {
    recorder->SetFileName(this->Options.record.c_str());
    recorder->On();
    recorder->Record();
  }
  this->Interactor->Start();
}

void SurfaceWindow::writeScreenshot()
{
  if (this->Options.screenshot.empty())
  {
    return;
  }
  this->Window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(this->Window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(this->Options.screenshot.c_str());
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw std::runtime_error("The picture " + this->Options.screenshot + " cannot be written.");
  }
}

}
