// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_Solving_h
#define geodesic_testing_Solving_h

#include "Surfaces.h"
#include "mesh/TriangleMesh.h"
#include "solve/DistanceField.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace geodesic::testing
{

std::shared_ptr<const TriangleMesh> meshOf(
  const Surface& surface, CoincidentPoints coincident = CoincidentPoints::Separate);

/** A seed at a point of the input. */
Seed seedAt(const TriangleMesh& mesh, Index point);
/** The point of the mesh that is nearest to a position. */
SurfacePoint pointNear(const std::shared_ptr<const TriangleMesh>& mesh, const Vector3& position);
/** A seed at the point of the mesh that is nearest to a position. */
Seed seedNear(const std::shared_ptr<const TriangleMesh>& mesh, const Vector3& position);

/** Distances at the points of the input by a solver of this kind; +infinity where unreached. */
template <class Solver>
std::vector<double> distances(const std::shared_ptr<const TriangleMesh>& mesh,
  const std::vector<Seed>& seeds, const SolveOptions& options = {})
{
  Solver solver(mesh);
  const DistanceField& field = solver.solve(seeds, options);
  std::vector<double> result;
  for (Index i = 0; i < mesh->numberOfPoints(); ++i)
  {
    const Index vertex = mesh->vertexOfPoint(i);
    result.push_back(vertex == NoIndex ? DistanceField::Unreached : field.distance(vertex));
  }
  return result;
}

/** The lengths of straight lines from a source to all points: the truth in a plane. */
std::vector<double> straightLines(const Surface& surface, const Vector3& source);

/** What a call complains about by an exception of a class; empty where it throws none. */
template <class Error = std::invalid_argument>
std::string errorOf(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

/** For what asks now and then whether it goes on: it does. */
inline bool goesOn()
{
  return true;
}

/** Whether fast marching takes seeds for dense, which are few fronts then. */
bool areDense(const TriangleMesh& mesh, const std::vector<Seed>& seeds);

/** The largest finite distance. */
double largestOf(const std::vector<double>& distances);

/** Relative error against the truth: mean over all points, and largest. */
struct Error
{
  double mean = 0.0;
  double largest = 0.0;
};

/** Points whose true distance is 0 don't count. */
Error relativeError(const std::vector<double>& distances, const std::vector<double>& truth);

/** Difference of the field of some seeds by fast marching to the least of their single fields, in
 * mean longest edges times the dearest cost. */
struct DifferenceToLeast
{
  double mean = 0.0;
  double largest = 0.0;
};
DifferenceToLeast differenceToLeast(const std::shared_ptr<const TriangleMesh>& mesh,
  const std::vector<Seed>& seeds, const SolveOptions& options = {});

}

#endif
