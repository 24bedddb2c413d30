// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes an ellipsoid with the point array Curvature, the mean curvature, which is positive on it.

#include "SurfaceFile.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace
{

constexpr double a = 1.0;
constexpr double b = 0.6;
constexpr double c = 0.4;

/** The mean curvature at a point of the surface x^2 / a^2 + y^2 / b^2 + z^2 / c^2 = 1. */
double meanCurvature(const double p[3])
{
  const double squares = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
  const double slope =
    p[0] * p[0] / std::pow(a, 4) + p[1] * p[1] / std::pow(b, 4) + p[2] * p[2] / std::pow(c, 4);
  return (a * a + b * b + c * c - squares) / (2.0 * std::pow(a * b * c, 2) * std::pow(slope, 1.5));
}

}

int main(int argc, char* argv[])
{
  if (argc != 2 || std::string(argv[1]) == "--help")
  {
    std::ostream& stream = argc == 2 ? std::cout : std::cerr;
    stream << "usage: MakeEllipsoid Ellipsoid.vtp" << std::endl;
    return argc == 2 ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(160);
  sphere->SetPhiResolution(120);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();

  vtkNew<vtkPolyData> ellipsoid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> curvature;
  curvature->SetName("Curvature");
  for (vtkIdType i = 0; i < sphere->GetOutput()->GetNumberOfPoints(); ++i)
  {
    double p[3];
    sphere->GetOutput()->GetPoint(i, p);
    // The sphere's poles are on the z axis. They are put on the longest axis, where they disturb
    // least.
    const double q[3] = { a * p[2], b * p[0], c * p[1] };
    points->InsertNextPoint(q);
    curvature->InsertNextValue(meanCurvature(q));
  }
  ellipsoid->SetPoints(points);
  ellipsoid->SetPolys(sphere->GetOutput()->GetPolys());
  ellipsoid->GetPointData()->AddArray(curvature);

  try
  {
    geodesic::examples::writeSurface(ellipsoid, argv[1]);
  }
  catch (const std::exception& error)
  {
    std::cerr << "MakeEllipsoid: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
