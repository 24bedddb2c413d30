// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFastMarchingGeodesicPath.h"

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
  const vtkIdType southPole = 1;
  vtkNew<vtkIdList> seeds;
  seeds->InsertNextId(northPole);

  vtkNew<vtkFastMarchingGeodesicDistance> distance;
  distance->SetInputConnection(sphere->GetOutputPort());
  distance->SetSeeds(seeds);
  distance->Update();

  vtkNew<vtkFastMarchingGeodesicPath> path;
  path->SetInputConnection(sphere->GetOutputPort());
  path->SetBeginPointId(southPole);
  path->SetSeeds(seeds);
  path->Update();

  const double expected = vtkMath::Pi() * radius;
  const auto isClose = [&](double length) { return std::abs(length - expected) < 0.02 * expected; };
  std::cout << "pole to pole: " << distance->GetMaximumDistance() << ", along a path "
            << path->GetGeodesicLength() << ", exactly " << expected << "\n";
  return isClose(distance->GetMaximumDistance()) && isClose(path->GetGeodesicLength())
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
