// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_Subject_h
#define geodesic_testing_Subject_h

#include "HeapDijkstra.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "search/ClosestPointTree.h"

#include <functional>
#include <random>
#include <string>
#include <vector>

namespace geodesic::testing
{

/**
 * True distances of all points of a surface from a point in one of its triangles, -1 where there is
 * none.
 */
using Truth = std::function<std::vector<double>(const SurfacePoint& source)>;

/** A surface whose distances may be known. */
struct KnownSurface
{
  Surface surface;
  Truth truth;
};

/** What is made once for an input: its mesh, and the bounds that fast marching makes from it. */
struct SetUp
{
  std::shared_ptr<const TriangleMesh> mesh;
  std::shared_ptr<const UpdateBounds> bounds;
};

/** As every benchmark makes it. */
SetUp setUp(const Surface& surface, unsigned threads = 1);

/** A surface of the suite with everything that is measured on it. */
struct Subject
{
  explicit Subject(KnownSurface known);

  /** A random point of the surface, as a user would give it: a position in space. */
  Vector3 randomPosition();
  /** The point of the surface at a position. */
  SurfacePoint pointAt(const Vector3& position) const;
  Seed seedAt(const Vector3& position) const { return Seed::atPoint(this->pointAt(position)); }
  /** The vertex that is nearest to a point within the point's triangle. */
  Index vertexNear(const SurfacePoint& point) const;

  Surface surface;
  Truth truth;
  SetUp made;
  std::shared_ptr<const TriangleMesh> mesh;
  ClosestPointTree tree;
  FastMarchingSolver solver;
  HeapDijkstra dijkstra;
  std::mt19937 random;
};

/** The names of the suite's surfaces, as the document shows them. */
std::vector<std::string> subjectNames();

/**
 * A surface of the suite, built when first asked for.
 * @param name one of subjectNames()
 */
Subject& subject(const std::string& name);

/** Makes all surfaces tiny, to try whether the suite runs. To be called first. */
void useTinySubjects();
bool areSubjectsTiny();

}

#endif
