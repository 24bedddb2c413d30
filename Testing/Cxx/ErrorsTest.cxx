// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Each mistake is one message that names it, and leaves an empty output, never a stale one.

#include "Inputs.h"
#include "NastyCases.h"
#include "Observer.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFastMarchingGeodesicPath.h"
#include "vtkNew.h"
#include "vtkSurfaceGeodesicDistance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace geodesic::testing;

namespace
{

/** Runs well first, then with a mistake, then without it again. */
template <class Filter>
void expectError(Filter* filter, const std::function<void()>& mistake,
  const std::function<void()>& remedy, const std::string& named)
{
  ASSERT_EQ(errorsOf(filter), "");
  const vtkIdType points =
    vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints();
  ASSERT_GT(points, 0);
  mistake();
  EXPECT_NE(errorsOf(filter).find(named), std::string::npos) << errorsOf(filter);
  vtkPolyData* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 0);
  remedy();
  EXPECT_EQ(errorsOf(filter), "");
  EXPECT_EQ(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), points);
}

class ArticleClassErrors : public ::testing::Test
{
protected:
  ArticleClassErrors()
  {
    this->Filter->SetInputData(this->Input);
    this->Filter->SetSeeds(this->Seeds);
    this->Filter->SetFieldDataName("d");
  }

  const vtkSmartPointer<vtkPolyData> Input = square(4);
  const vtkSmartPointer<vtkIdList> Seeds = idList({ 3 });
  vtkNew<vtkFastMarchingGeodesicDistance> Filter;
};

class PathErrors : public ::testing::Test
{
protected:
  PathErrors()
  {
    this->Filter->SetInputData(this->Input);
    this->Filter->SetBeginPointId(7);
    this->Filter->SetSeeds(this->Seeds);
  }

  const vtkSmartPointer<vtkPolyData> Input = square(4);
  const vtkSmartPointer<vtkIdList> Seeds = idList({ 24 });
  vtkNew<vtkFastMarchingGeodesicPath> Filter;
};

class SurfaceFilterErrors : public ::testing::Test
{
protected:
  SurfaceFilterErrors()
  {
    this->Filter->SetInputDataObject(this->Input);
    this->Filter->AddSeedPosition(1.0, 1.0, 0.0);
  }

  const vtkSmartPointer<vtkPolyData> Input = square(4);
  vtkNew<vtkSurfaceGeodesicDistance> Filter;
};

}

TEST_F(ArticleClassErrors, NoSeed)
{
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetSeeds(nullptr); },
    [&] { this->Filter->SetSeeds(this->Seeds); }, "no seed");
}

TEST_F(ArticleClassErrors, IdsOutsideOfTheInputAreNamed)
{
  for (vtkIdType id : { vtkIdType{ -1 }, vtkIdType{ 25 }, vtkIdType{ 1 } << 40 })
  {
    const std::string name = std::to_string(id);
    expectError(
      this->Filter.Get(),
      [&] {
        this->Filter->SetSeeds(idList({ 3, id }));
      },
      [&] { this->Filter->SetSeeds(this->Seeds); }, name);
    expectError(
      this->Filter.Get(), [&] { this->Filter->SetExclusionPointIds(idList({ id })); },
      [&] { this->Filter->SetExclusionPointIds(nullptr); }, name);
    expectError(
      this->Filter.Get(), [&] { this->Filter->SetDestinationVertexStopCriterion(idList({ id })); },
      [&] { this->Filter->SetDestinationVertexStopCriterion(nullptr); }, name);
  }
}

TEST_F(ArticleClassErrors, AnExcludedSeedIsNamed)
{
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetExclusionPointIds(idList({ 3 })); },
    [&] { this->Filter->SetExclusionPointIds(nullptr); }, "point 3");
}

TEST_F(ArticleClassErrors, ASeedWithoutACellIsNamed)
{
  const vtkIdType bare = this->Input->GetPoints()->InsertNextPoint(9.0, 9.0, 9.0);
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetSeeds(idList({ bare })); },
    [&] { this->Filter->SetSeeds(this->Seeds); }, std::to_string(bare));
}

TEST_F(ArticleClassErrors, WeightsThatAreNoneAreNamed)
{
  vtkNew<vtkDoubleArray> weights;
  weights->SetNumberOfTuples(25);
  const auto clear = [&] { this->Filter->SetPropagationWeights(nullptr); };
  for (double bad : { 0.0, -2.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    weights->Fill(1.0);
    weights->SetValue(9, bad);
    weights->SetValue(17, bad);
    weights->Modified();
    expectError(
      this->Filter.Get(), [&] { this->Filter->SetPropagationWeights(weights); }, clear,
      "at point 9;");
  }
  weights->SetNumberOfTuples(24);
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetPropagationWeights(weights); }, clear, "24 tuples");
  weights->SetNumberOfComponents(5);
  weights->SetNumberOfTuples(25);
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetPropagationWeights(weights); }, clear,
    "5 components");
}

TEST_F(ArticleClassErrors, ADistanceStopThatIsNoNumberIsNamed)
{
  expectError(
    this->Filter.Get(),
    [&] { this->Filter->SetDistanceStopCriterion(std::numeric_limits<double>::quiet_NaN()); },
    [&] { this->Filter->SetDistanceStopCriterion(-1.0); }, "nan");
}

TEST_F(ArticleClassErrors, InputsWithoutASurface)
{
  const auto noPoints = vtkSmartPointer<vtkPolyData>::New();
  auto noCells = vtkSmartPointer<vtkPolyData>::New();
  noCells->SetPoints(this->Input->GetPoints());
  for (const auto& input : { noPoints, noCells })
  {
    expectError(
      this->Filter.Get(), [&] { this->Filter->SetInputData(input); },
      [&] { this->Filter->SetInputData(this->Input); }, "no surface");
  }
}

TEST_F(ArticleClassErrors, APointThatIsNotFiniteIsNamed)
{
  const auto broken = square(4);
  broken->GetPoints()->SetPoint(7, std::nan(""), 0.0, 0.0);
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetInputData(broken); },
    [&] { this->Filter->SetInputData(this->Input); }, "Point 7");
}

TEST_F(ArticleClassErrors, ACellOfAMissingPointIsNamed)
{
  const auto broken = square(4);
  broken->GetPolys()->InsertNextCell({ 0, 1, 99 });
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetInputData(broken); },
    [&] { this->Filter->SetInputData(this->Input); }, "99");
}

TEST_F(PathErrors, BeginPointsThatDoNotExistAreNamed)
{
  const vtkIdType bare = this->Input->GetPoints()->InsertNextPoint(9.0, 9.0, 9.0);
  const auto mend = [&] { this->Filter->SetBeginPointId(7); };
  for (vtkIdType id : { vtkIdType{ -1 }, vtkIdType{ 26 }, vtkIdType{ 1 } << 40 })
  {
    expectError(
      this->Filter.Get(), [&] { this->Filter->SetBeginPointId(id); }, mend,
      "Begin point id " + std::to_string(id) + " does not exist: the input has 26 points");
  }
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetBeginPointId(bare); }, mend,
    "Begin point id 25 is not on the surface");
}

TEST_F(PathErrors, SeedsThatDoNotExistAreNamed)
{
  const auto mend = [&] { this->Filter->SetSeeds(this->Seeds); };
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetSeeds(nullptr); }, mend, "no seed");
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetSeeds(idList({})); }, mend, "no seed");
  expectError(
    this->Filter.Get(),
    [&] {
      this->Filter->SetSeeds(idList({ 24, 25 }));
    },
    mend, "Seed point id 25 does not exist: the input has 25 points");
}

TEST_F(PathErrors, NoRouteNamesThePoints)
{
  const vtkIdType far = this->Input->GetPoints()->InsertNextPoint(9.0, 0.0, 0.0);
  this->Input->GetPoints()->InsertNextPoint(10.0, 0.0, 0.0);
  this->Input->GetPoints()->InsertNextPoint(9.0, 1.0, 0.0);
  this->Input->GetPolys()->InsertNextCell({ far, far + 1, far + 2 });
  expectError(
    this->Filter.Get(),
    [&] {
      this->Filter->SetSeeds(idList({ far, far + 1 }));
    },
    [&] { this->Filter->SetSeeds(this->Seeds); },
    "no path from begin point 7 to any of the seed points 25, 26: they are on parts");
  // The neighbours of point 24, in the corner.
  const auto loop = idList({ 18, 19, 23 });
  expectError(
    this->Filter.Get(), [&] { this->Filter->GetGeodesic()->SetExclusionPointIds(loop); },
    [&] { this->Filter->GetGeodesic()->SetExclusionPointIds(nullptr); },
    "no path from begin point 7 to seed point 24: they are on parts");
}

TEST_F(PathErrors, FailTheRun)
{
  this->Filter->GetGeodesic()->SetExclusionPointIds(idList({ 18, 19, 23 }));
  EXPECT_NE(errorsOf(this->Filter.Get()).find("returned failure"), std::string::npos);
  EXPECT_EQ(this->Filter->GetGeodesicLength(), 0.0);
  EXPECT_EQ(this->Filter->GetZerothOrderPathPointIds()->GetNumberOfIds(), 0);
  EXPECT_EQ(this->Filter->GetFirstOrderPathPointIds()->GetNumberOfIds(), 0);
}

TEST_F(PathErrors, ExcludedEndsAreNamed)
{
  const auto mend = [&] { this->Filter->GetGeodesic()->SetExclusionPointIds(nullptr); };
  expectError(
    this->Filter.Get(), [&] { this->Filter->GetGeodesic()->SetExclusionPointIds(idList({ 7 })); },
    mend, "Begin point id 7 is among the exclusion points");
  expectError(
    this->Filter.Get(), [&] { this->Filter->GetGeodesic()->SetExclusionPointIds(idList({ 24 })); },
    mend, "is at point 24, which is on a barrier");
}

TEST_F(PathErrors, WhatCannotBeStraightened)
{
  const auto mend = [&]
  {
    this->Filter->StraightenOff();
    this->Filter->GetGeodesic()->SetPropagationWeights(nullptr);
  };
  vtkNew<vtkDoubleArray> weights;
  weights->SetNumberOfTuples(25);
  weights->Fill(2.0);
  expectError(
    this->Filter.Get(),
    [&]
    {
      this->Filter->StraightenOn();
      this->Filter->GetGeodesic()->SetPropagationWeights(weights);
    },
    mend, "varying cost");
  this->Filter->SetInterpolationOrder(0);
  expectError(
    this->Filter.Get(), [&] { this->Filter->StraightenOn(); }, mend, "along edges");
}

TEST_F(PathErrors, LimitsThatAreNoneAreNamed)
{
  const auto mend = [&]
  {
    this->Filter->SetMaximumPathLength(VTK_DOUBLE_MAX);
    this->Filter->SetMaximumPathPoints(VTK_ID_MAX);
  };
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetMaximumPathLength(-0.5); }, mend,
    "MaximumPathLength is -0.5; it must be at least 0");
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetMaximumPathLength(std::nan("")); }, mend,
    "MaximumPathLength is nan");
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetMaximumPathPoints(0); }, mend,
    "MaximumPathPoints is 0; it must be at least 1");
}

TEST_F(SurfaceFilterErrors, NoSeedSaysHowToGiveOne)
{
  expectError(
    this->Filter.Get(), [&] { this->Filter->ClearSeedPositions(); },
    [&] { this->Filter->AddSeedPosition(0.0, 0.0, 0.0); }, "SeedPositions");
}

TEST_F(SurfaceFilterErrors, CoordinatesThatAreNoTriples)
{
  expectError(
    this->Filter.Get(), [&] { this->Filter->AddSeedCoordinate(1.0); },
    [&]
    {
      this->Filter->ClearSeedPositions();
      this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
    },
    "multiple of 3");
}

TEST_F(SurfaceFilterErrors, APositionThatIsNotFiniteIsNamed)
{
  expectError(
    this->Filter.Get(), [&] { this->Filter->AddSeedPosition(0.0, std::nan(""), 0.0); },
    [&]
    {
      this->Filter->ClearSeedPositions();
      this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
    },
    "Point 1 of SeedPositions");
}

TEST_F(SurfaceFilterErrors, ANegativeMaximumDistanceIsNamed)
{
  expectError(
    this->Filter.Get(),
    [&]
    {
      this->Filter->UseMaximumDistanceOn();
      this->Filter->SetMaximumDistance(-2.0);
    },
    [&] { this->Filter->UseMaximumDistanceOff(); }, "-2");
}

// Triangles that lie on each other, from a point on an edge that many of them share.
TEST(Errors, AFrontThatSettlesOnlyRoughlyIsAWarning)
{
  const geodesic::testing::NastyCase test = nastyCase(11442);
  Surface surface = test.surface;
  constexpr geodesic::Index a = 8;
  constexpr geodesic::Index b = 5;
  const auto middle = static_cast<geodesic::Index>(surface.points.size());
  surface.points.push_back(0.5 * (surface.points[a] + surface.points[b]));
  surface.triangles.clear();
  for (const geodesic::Triangle& triangle : test.surface.triangles)
  {
    geodesic::Triangle ofA = triangle;
    geodesic::Triangle ofB = triangle;
    std::replace(ofA.begin(), ofA.end(), b, middle);
    std::replace(ofB.begin(), ofB.end(), a, middle);
    if (ofA == triangle || ofB == triangle)
    {
      surface.triangles.push_back(triangle);
      continue;
    }
    surface.triangles.insert(surface.triangles.end(), { ofA, ofB });
  }
  const auto warningOf = [](vtkAlgorithm* filter)
  {
    auto observer = vtkSmartPointer<vtkTest::ErrorObserver>::New();
    filter->AddObserver(vtkCommand::WarningEvent, observer);
    filter->Update();
    filter->RemoveObserver(observer);
    return observer->GetWarningMessage();
  };
  const auto expectSaid = [](const std::string& words, const std::string& remedy)
  {
    for (const std::string& part : { std::string("settled only roughly"),
           std::string("more than 40 updates"), std::string("a part of 1e-"), remedy })
    {
      EXPECT_NE(words.find(part), std::string::npos) << words;
    }
  };
  vtkNew<vtkSurfaceGeodesicDistance> filter;
  filter->SetInputData(polyDataOf(surface));
  filter->AddSeedPointId(middle);
  // So little memory that it goes over the thin triangles themselves.
  filter->SetMemoryLimit(1e-9);
  expectSaid(warningOf(filter), "Use the method Exact, Bounded or VirtualSources");
  expectSaid(filter->GetNoticeText(), "Use the method Exact, Bounded or VirtualSources");
  filter->SetMethod(vtkSurfaceGeodesicDistance::EXACT);
  EXPECT_EQ(warningOf(filter), "");
  EXPECT_STREQ(filter->GetNoticeText(), "");

  vtkNew<vtkFastMarchingGeodesicDistance> ofTheArticle;
  ofTheArticle->SetInputData(polyDataOf(surface));
  ofTheArticle->SetFieldDataName("d");
  ofTheArticle->SetSeeds(idList({ middle }));
  expectSaid(warningOf(ofTheArticle), "Clean or remesh the surface.");
  ofTheArticle->SetSeeds(idList({ 0 }));
  EXPECT_EQ(warningOf(ofTheArticle), "");
}

TEST(Errors, SeedCoordinateThatIsNotThere)
{
  vtkNew<vtkSurfaceGeodesicDistance> filter;
  filter->AddSeedPosition(1.0, 2.0, 3.0);
  EXPECT_EQ(filter->GetSeedCoordinate(2), 3.0);
  for (const int index : { -1, 3, 99 })
  {
    int errors = 0;
    Observer observer(filter, vtkCommand::ErrorEvent, [&] { ++errors; });
    EXPECT_EQ(filter->GetSeedCoordinate(index), 0.0);
    EXPECT_EQ(errors, 1);
    filter->RemoveAllObservers();
  }
}
