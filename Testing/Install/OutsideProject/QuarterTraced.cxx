// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolygonalSurfaceContourLineInterpolator2.h"

#include "vtkContourRepresentation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOrientedGlyphContourRepresentation.h"
#include "vtkPolyData.h"
#include "vtkPolyDataCollection.h"
#include "vtkPolygonalSurfacePointPlacer.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

/** From the pole to the equator it is a quarter of a great circle, pi R / 2; along chords 0.01 %
 * less. */
int main()
{
  const double radius = 3.0;
  const int resolution = 64;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution + 1);
  sphere->Update();
  vtkPolyData* surface = sphere->GetOutput();

  vtkNew<vtkPolygonalSurfacePointPlacer> placer;
  placer->GetPolys()->AddItem(surface);
  vtkNew<vtkPolygonalSurfaceContourLineInterpolator2> interpolator;
  interpolator->GetPolys()->AddItem(surface);
  interpolator->SetGeodesicMethodToFastMarching();
  interpolator->SetInterpolationOrder(1);
  vtkNew<vtkRenderer> renderer;
  renderer->GetActiveCamera(); // Makes one, which the contour needs.
  vtkNew<vtkOrientedGlyphContourRepresentation> contour;
  contour->SetRenderer(renderer);
  contour->SetPointPlacer(placer);
  contour->SetLineInterpolator(interpolator);

  // The two poles come first, then meridian by meridian the points between them.
  const vtkIdType northPole = 0;
  const vtkIdType onEquator = 2 + (resolution + 1 - 2) / 2;
  for (vtkIdType id : { northPole, onEquator })
  {
    double position[3];
    surface->GetPoint(id, position);
    placer->UpdateNodeWorldPosition(position, id);
    contour->AddNodeAtWorldPosition(position);
  }

  double length = 0.0;
  for (int i = 1; i < contour->GetNumberOfIntermediatePoints(0); ++i)
  {
    double from[3];
    double to[3];
    contour->GetIntermediatePointWorldPosition(0, i - 1, from);
    contour->GetIntermediatePointWorldPosition(0, i, to);
    length += std::sqrt(vtkMath::Distance2BetweenPoints(from, to));
  }
  const double expected = 0.5 * vtkMath::Pi() * radius;
  std::cout << "pole to equator: " << length << ", exactly " << expected << "\n";
  return std::abs(length - expected) < 0.001 * expected ? EXIT_SUCCESS : EXIT_FAILURE;
}
