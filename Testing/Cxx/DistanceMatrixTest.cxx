// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceGeodesicDistanceMatrix: lengths against formulas and CGAL, and mistakes.

#include "Inputs.h"

#include "ExactDistances.h"
#include "Surfaces.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSurfaceGeodesicDistanceMatrix.h"
#include "vtkTable.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

using Matrix = std::vector<std::vector<double>>;

void addLandmarks(vtkSurfaceGeodesicDistanceMatrix* filter, const std::vector<Vector3>& points)
{
  for (const Vector3& p : points)
  {
    for (const double coordinate : { p.x, p.y, p.z })
    {
      filter->AddLandmarkCoordinate(coordinate);
    }
  }
}

void addSecondLandmarks(
  vtkSurfaceGeodesicDistanceMatrix* filter, const std::vector<Vector3>& points)
{
  for (const Vector3& p : points)
  {
    for (const double coordinate : { p.x, p.y, p.z })
    {
      filter->AddSecondLandmarkCoordinate(coordinate);
    }
  }
}

vtkTable* tableOf(vtkSurfaceGeodesicDistanceMatrix* filter)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(0));
}

/** Row by row; the names of the columns are checked. */
Matrix matrixOf(vtkSurfaceGeodesicDistanceMatrix* filter)
{
  vtkTable* table = tableOf(filter);
  EXPECT_STREQ(table->GetColumnName(0), "From");
  Matrix matrix(table->GetNumberOfRows());
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    EXPECT_EQ(table->GetValue(row, 0).ToInt(), row);
    for (vtkIdType column = 1; column < table->GetNumberOfColumns(); ++column)
    {
      EXPECT_EQ(table->GetColumnName(column), "To " + std::to_string(column - 1));
      matrix[row].push_back(table->GetValue(row, column).ToDouble());
    }
  }
  return matrix;
}

Matrix matrixAmong(vtkPolyData* surface, const std::vector<Vector3>& landmarks, int method = 0)
{
  vtkNew<vtkSurfaceGeodesicDistanceMatrix> filter;
  filter->SetInputDataObject(surface);
  filter->SetMethod(method);
  addLandmarks(filter, landmarks);
  EXPECT_EQ(errorsOf(filter.Get()), "");
  return matrixOf(filter);
}

void expectMetric(const Matrix& matrix)
{
  for (std::size_t i = 0; i < matrix.size(); ++i)
  {
    EXPECT_EQ(matrix[i][i], 0.0);
    for (std::size_t j = 0; j < i; ++j)
    {
      EXPECT_EQ(matrix[i][j], matrix[j][i]);
    }
  }
}

std::vector<Vector3> randomPoints(std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vector3> points(count);
  for (Vector3& point : points)
  {
    point = { unit(random), unit(random), 0.0 };
  }
  return points;
}

}

// On a plane paths are straight lines, also from points inside faces.
TEST(DistanceMatrix, IsTheStraightDistanceOnAPlane)
{
  const auto surface = polyDataOf(delaunayPlane(2000, 3));
  const std::vector<Vector3> landmarks = randomPoints(30, 5);
  const Matrix matrix = matrixAmong(surface, landmarks);
  ASSERT_EQ(matrix.size(), landmarks.size());
  expectMetric(matrix);
  for (std::size_t i = 0; i < landmarks.size(); ++i)
  {
    for (std::size_t j = 0; j < landmarks.size(); ++j)
    {
      EXPECT_NEAR(matrix[i][j], norm(landmarks[i] - landmarks[j]), 1e-9) << i << ", " << j;
    }
  }
}

// Great circles; the sides of the polyhedron are shorter by the square of an edge (1/16 / 2)^2 / 6.
TEST(DistanceMatrix, IsTheGreatCircleOnASphere)
{
  const Surface sphere = icosphere(5);
  std::vector<Vector3> landmarks;
  for (std::size_t i = 0; i < 12; ++i)
  {
    landmarks.push_back(sphere.points[i * 701 % sphere.points.size()]);
  }
  const Matrix matrix = matrixAmong(polyDataOf(sphere), landmarks);
  expectMetric(matrix);
  for (std::size_t i = 0; i < landmarks.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const double truth = std::acos(std::clamp(dot(landmarks[i], landmarks[j]), -1.0, 1.0));
      EXPECT_NEAR(matrix[i][j], truth, 1e-3 * truth) << i << ", " << j;
    }
  }
}

// CGAL's exact distances between points of a torus. Exact is right to rounding; straightened paths
// are never shorter, and another path round is at most some per cent longer here.
TEST(DistanceMatrix, IsExactOrALittleLongerOnATorus)
{
  const Surface surface = torus(40, 24, 1.0, 0.4);
  const std::vector<Index> ids{ 0, 17, 202, 333, 470, 611, 888 };
  std::vector<Vector3> landmarks;
  for (const Index id : ids)
  {
    landmarks.push_back(surface.points[id]);
  }
  const auto data = polyDataOf(surface);
  const Matrix exact = matrixAmong(data, landmarks, vtkSurfaceGeodesicFilter::EXACT);
  const Matrix straightened = matrixAmong(data, landmarks);
  const Matrix alongEdges = matrixAmong(data, landmarks, vtkSurfaceGeodesicFilter::DIJKSTRA);
  expectMetric(exact);
  expectMetric(straightened);
  expectMetric(alongEdges);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const std::vector<double> truth = exactDistances(surface, { ids[i] });
    for (std::size_t j = 0; j < ids.size(); ++j)
    {
      const double distance = truth[ids[j]];
      EXPECT_NEAR(exact[i][j], distance, 1e-9) << i << ", " << j;
      EXPECT_GE(straightened[i][j], distance - 1e-9) << i << ", " << j;
      EXPECT_LE(straightened[i][j], 1.02 * distance + 1e-9) << i << ", " << j;
      EXPECT_GE(alongEdges[i][j], straightened[i][j] - 1e-9) << i << ", " << j;
    }
  }
}

// Rows are the first set, columns the second, whichever has fewer landmarks and marches.
TEST(DistanceMatrix, LeadsFromOneSetToAnother)
{
  const auto surface = polyDataOf(delaunayPlane(500, 3));
  for (const auto& [rows, columns] : std::vector<std::pair<int, int>>{ { 3, 7 }, { 7, 3 } })
  {
    const std::vector<Vector3> from = randomPoints(rows, 1);
    const std::vector<Vector3> to = randomPoints(columns, 2);
    vtkNew<vtkSurfaceGeodesicDistanceMatrix> filter;
    filter->SetInputDataObject(surface);
    addLandmarks(filter, from);
    addSecondLandmarks(filter, to);
    EXPECT_EQ(errorsOf(filter.Get()), "");
    const Matrix matrix = matrixOf(filter);
    ASSERT_EQ(matrix.size(), from.size());
    for (std::size_t i = 0; i < from.size(); ++i)
    {
      ASSERT_EQ(matrix[i].size(), to.size());
      for (std::size_t j = 0; j < to.size(); ++j)
      {
        EXPECT_NEAR(matrix[i][j], norm(from[i] - to[j]), 1e-9);
      }
    }
  }
}

TEST(DistanceMatrix, IsNanWhereNoPathLeads)
{
  Surface far = planeGrid(4, 4, 1.0, 1.0);
  for (Vector3& point : far.points)
  {
    point.z = 5.0;
  }
  const auto surface = polyDataOf(joined(planeGrid(4, 4, 1.0, 1.0), far));
  vtkNew<vtkSurfaceGeodesicDistanceMatrix> filter;
  filter->SetInputDataObject(surface);
  addLandmarks(filter, { { 0.1, 0.1, 0 }, { 0.3, 0.6, 5 }, { 0.9, 0.1, 0 }, { 0.3, 0.2, 5 } });
  EXPECT_EQ(errorsOf(filter.Get()), "");
  const Matrix matrix = matrixOf(filter);
  expectMetric({ { matrix[0][0], matrix[0][2] }, { matrix[2][0], matrix[2][2] } });
  EXPECT_NEAR(matrix[0][2], 0.8, 1e-12);
  EXPECT_NEAR(matrix[1][3], 0.4, 1e-12);
  EXPECT_TRUE(std::isnan(matrix[0][1]));
  EXPECT_TRUE(std::isnan(matrix[1][0]));
  EXPECT_TRUE(std::isnan(matrix[2][3]));
  EXPECT_EQ(filter->GetNumberOfUnjoinedPairs(), 4);
}

TEST(DistanceMatrix, TakesOneLandmarkAndEqualOnes)
{
  const auto surface = square(4);
  EXPECT_EQ(matrixAmong(surface, { { 1.3, 1.2, 0 } }), Matrix{ { 0.0 } });
  for (const int method : { 0, 1, 2, 3 })
  {
    const Matrix matrix =
      matrixAmong(surface, { { 1, 1, 0 }, { 3, 1, 0 }, { 1, 1, 0 }, { 3, 1, 0 } }, method);
    expectMetric(matrix);
    EXPECT_EQ(matrix[0][2], 0.0) << method;
    EXPECT_EQ(matrix[1][3], 0.0) << method;
    EXPECT_NEAR(matrix[0][1], 2.0, 1e-12) << method;
    EXPECT_NEAR(matrix[2][3], 2.0, 1e-12) << method;
  }
  // Inside one face.
  const Matrix inside = matrixAmong(surface, { { 1.3, 1.2, 0 }, { 1.3, 1.2, 0 }, { 1.4, 1.2, 0 } });
  EXPECT_EQ(inside[0][1], 0.0);
  EXPECT_NEAR(inside[1][2], 0.1, 1e-12);
}

TEST(DistanceMatrix, TakesLandmarksOfASource)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(3, 4, 0);
  vtkNew<vtkPolyData> source;
  source->SetPoints(points);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(source);
  vtkNew<vtkSurfaceGeodesicDistanceMatrix> filter;
  filter->SetInputDataObject(square(4));
  filter->SetLandmarkSourceConnection(producer->GetOutputPort());
  EXPECT_EQ(errorsOf(filter.Get()), "");
  EXPECT_NEAR(matrixOf(filter)[0][1], 5.0, 1e-12);

  addLandmarks(filter, { { 1, 1, 0 } });
  EXPECT_NE(errorsOf(filter.Get()).find("LandmarkSource is set as well"), std::string::npos);
  EXPECT_EQ(tableOf(filter)->GetNumberOfColumns(), 0);
}

TEST(DistanceMatrix, SaysWhatIsWrong)
{
  const auto expectError =
    [](const std::string& words, const auto& change, const std::vector<Vector3>& landmarks)
  {
    vtkNew<vtkSurfaceGeodesicDistanceMatrix> filter;
    filter->SetInputDataObject(square(4));
    addLandmarks(filter, landmarks);
    change(filter.Get());
    EXPECT_NE(errorsOf(filter.Get()).find(words), std::string::npos) << filter->GetErrorText();
    EXPECT_EQ(tableOf(filter)->GetNumberOfColumns(), 0) << words;
  };
  using Filter = vtkSurfaceGeodesicDistanceMatrix;
  const std::vector<Vector3> two{ { 0, 0, 0 }, { 1, 1, 0 } };
  expectError("There is no landmark", [](Filter*) {}, {});
  expectError(
    "multiple of 3", [](Filter* filter) { filter->AddLandmarkCoordinate(1.0); }, two);
  expectError(
    "multiple of 3", [](Filter* filter) { filter->AddSecondLandmarkCoordinate(1.0); }, two);
  expectError(
    "There is no method 7", [](Filter* filter) { filter->SetMethod(7); }, two);
  expectError(
    "MemoryLimit", [](Filter* filter) { filter->SetMemoryLimit(-1.0); }, two);
  expectError(
    "NumberOfThreads is -2", [](Filter* filter) { filter->SetNumberOfThreads(-2); }, two);
  expectError(
    "NumberOfThreads is 1025", [](Filter* filter) { filter->SetNumberOfThreads(1025); }, two);
  expectError(
    "A matrix of 2 by 2 landmarks needs 6.4e-08 gigabytes",
    [](Filter* filter) { filter->SetMemoryLimit(5e-8); }, two);
}

// After an abort there is no table, and the next run has all of it.
TEST(DistanceMatrix, CanBeAborted)
{
  for (const int threads : { 1, 2, 8 })
  {
    vtkNew<vtkSurfaceGeodesicDistanceMatrix> filter;
    filter->SetNumberOfThreads(threads);
    filter->SetInputDataObject(polyDataOf(icosphere(5)));
    addLandmarks(filter, { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
    vtkNew<vtkCallbackCommand> abort;
    abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
      { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
    const auto tag = filter->AddObserver(vtkCommand::ProgressEvent, abort);
    EXPECT_EQ(errorsOf(filter.Get()), "");
    EXPECT_EQ(tableOf(filter)->GetNumberOfColumns(), 0);
    filter->RemoveObserver(tag);
    filter->SetAbortExecute(0);
    filter->Modified();
    EXPECT_EQ(errorsOf(filter.Get()), "");
    EXPECT_NEAR(matrixOf(filter)[0][2], std::numbers::pi / 2, 2e-3);
  }
}

// Whatever the number of threads, each length is the same to the bit, for each method.
TEST(DistanceMatrix, IsTheSameForAnyNumberOfThreads)
{
  const auto input = polyDataOf(icosphere(5));
  std::mt19937 random(35);
  std::normal_distribution<double> anywhere;
  std::vector<Vector3> landmarks(12);
  for (Vector3& landmark : landmarks)
  {
    landmark = { anywhere(random), anywhere(random), anywhere(random) };
    landmark = (1.0 / norm(landmark)) * landmark;
  }
  for (const int method : { 0, 1, 4 })
  {
    for (const bool hasSecond : { false, true })
    {
      Matrix ofOne;
      for (const int threads : { 1, 2, 3, 8, 0, -1 })
      {
        vtkNew<vtkSurfaceGeodesicDistanceMatrix> filter;
        filter->SetInputDataObject(input);
        filter->SetMethod(method);
        filter->SetNumberOfThreads(threads);
        addLandmarks(filter, landmarks);
        if (hasSecond)
        {
          addSecondLandmarks(filter, { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
        }
        EXPECT_EQ(errorsOf(filter.Get()), "");
        const Matrix matrix = matrixOf(filter);
        ofOne = threads == 1 ? matrix : ofOne;
        EXPECT_EQ(matrix, ofOne) << "method " << method << ", " << threads << " threads";
      }
    }
  }
}

// The windows of runs at a time share the limit; what needs all of it runs alone.
TEST(DistanceMatrix, KeepsTheMemoryLimitOnSeveralThreads)
{
  const auto input = polyDataOf(icosphere(4));
  const auto errorAt = [&](double gigabytes, int threads)
  {
    vtkNew<vtkSurfaceGeodesicDistanceMatrix> filter;
    filter->SetInputDataObject(input);
    filter->SetMethod(vtkSurfaceGeodesicFilter::EXACT);
    filter->SetMemoryLimit(gigabytes);
    filter->SetNumberOfThreads(threads);
    addLandmarks(filter, { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -1, 0, 0 } });
    return errorsOf(filter.Get());
  };
  double least = 1e-6;
  while (!errorAt(least, 1).empty())
  {
    least *= 1.5;
  }
  EXPECT_EQ(errorAt(least, 4), "");
  EXPECT_NE(errorAt(least / 1.5, 4).find("more than the memory limit of"), std::string::npos);
}
