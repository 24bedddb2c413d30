// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFastMarchingGeodesicDistance.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

/** Half a great circle is pi R. A first-order scheme is within 2 % of it on this mesh. */
int main()
{
  const double radius = 3.0;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);

  const vtkIdType northPole = 0;
  vtkNew<vtkIdList> seeds;
  seeds->InsertNextId(northPole);

  vtkNew<vtkFastMarchingGeodesicDistance> distance;
  distance->SetInputConnection(sphere->GetOutputPort());
  distance->SetSeeds(seeds);
  distance->Update();

  const double expected = vtkMath::Pi() * radius;
  std::cout << "pole to pole: " << distance->GetMaximumDistance() << ", exactly " << expected
            << "\n";
  const bool close = std::abs(distance->GetMaximumDistance() - expected) < 0.02 * expected;
  return close ? EXIT_SUCCESS : EXIT_FAILURE;
}
