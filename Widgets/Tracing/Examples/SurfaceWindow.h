// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_examples_SurfaceWindow_h
#define geodesic_examples_SurfaceWindow_h

#include "Arguments.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <optional>
#include <string>

namespace geodesic::examples
{

/** A window that shows a surface, moved by the mouse or by recorded events. */
class SurfaceWindow
{
public:
  SurfaceWindow(const std::string& title, vtkPolyData* surface, const RunOptions& options);

  /**
   * The surface that is shown, with normals of its points and cells. Its points are those of the
   * given surface.
   */
  vtkPolyData* surface() const { return this->Shown; }
  vtkActor* actor() const { return this->Actor; }
  vtkPolyDataMapper* mapper() const { return this->Mapper; }
  vtkRenderer* renderer() const { return this->Renderer; }
  vtkRenderWindowInteractor* interactor() const { return this->Interactor; }
  /** Makes picking on a large surface fast. */
  vtkStaticCellLocator* locator() const { return this->Locator; }

  /**
   * The point of the surface that is nearest to the place seen at a pixel; none if the pixel is
   * beside the surface.
   */
  std::optional<vtkIdType> pointAt(int x, int y);

  /**
   * Plays the events, or lets the user work until the window is closed.
   * @throws std::runtime_error if a file cannot be read
   */
  void run();

  /** @throws std::runtime_error if the file cannot be written */
  void writeScreenshot();

private:
  RunOptions Options;
  vtkSmartPointer<vtkPolyData> Shown;
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
};

}

#endif
