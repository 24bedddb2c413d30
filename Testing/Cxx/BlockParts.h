// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_BlockParts_h
#define geodesic_testing_BlockParts_h

#include "Inputs.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSurfaceGeodesicDistance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>

namespace geodesic::testing
{

/** Some cells of a surface with points of their own; the array Whole tells which they were. */
vtkSmartPointer<vtkPolyData> partOf(
  vtkPolyData* surface, const std::function<bool(vtkIdType cell)>& isInside);
/** One of so many parts, cut at random: the worst case. */
vtkSmartPointer<vtkPolyData> scatteredPart(vtkPolyData* surface, int part, int parts);
/** The square moved by x and y. */
vtkSmartPointer<vtkPolyData> squareAt(double x, double y);
vtkSmartPointer<vtkMultiBlockDataSet> blocksOf(
  std::initializer_list<vtkSmartPointer<vtkDataObject>> leaves);

void setGlobalIds(vtkPolyData* surface, const std::function<vtkIdType(vtkIdType point)>& idOf);
/** The id of the whole's point. */
void setWholeIds(vtkPolyData* part);

/** The distance filter on blocks, and on the whole of which they are parts. */
class Blocks : public ::testing::Test
{
protected:
  vtkDataObject* run(vtkDataObject* input)
  {
    this->Filter->SetInputDataObject(input);
    EXPECT_EQ(errorsOf(this->Filter.Get()), "");
    return this->Filter->GetOutputDataObject(0);
  }

  void expectError(vtkDataObject* input, const std::string& named)
  {
    this->Filter->SetInputDataObject(input);
    const std::string message = errorsOf(this->Filter.Get());
    EXPECT_NE(message.find(named), std::string::npos) << message;
    EXPECT_EQ(this->Filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  }

  static vtkDataArray* distancesOf(vtkDataObject* leaf)
  {
    return vtkPolyData::SafeDownCast(leaf)->GetPointData()->GetArray("GeodesicDistance");
  }

  /** A part's distances are those of the whole, which is its own part. */
  static void expectSame(vtkDataObject* leaf, vtkDataArray* whole)
  {
    auto* part = vtkPolyData::SafeDownCast(leaf);
    ASSERT_TRUE(part);
    vtkDataArray* distances = distancesOf(part);
    vtkDataArray* origin = part->GetPointData()->GetArray("Whole");
    const double largest = whole->GetFiniteRange()[1];
    ASSERT_EQ(distances->GetNumberOfTuples(), part->GetNumberOfPoints());
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      const double truth =
        whole->GetComponent(static_cast<vtkIdType>(origin->GetComponent(i, 0)), 0);
      const double found = distances->GetComponent(i, 0);
      ASSERT_TRUE(std::isnan(truth) ? std::isnan(found) : std::abs(found - truth) < 1e-9 * largest)
        << found << " is not " << truth;
    }
  }

  void seedAt(vtkPolyData* surface, vtkIdType point)
  {
    double p[3];
    surface->GetPoint(point, p);
    this->Filter->AddSeedPosition(p[0], p[1], p[2]);
  }

  vtkSmartPointer<vtkDataArray> wholeField(vtkPolyData* surface)
  {
    return distancesOf(this->run(surface));
  }

  vtkNew<vtkSurfaceGeodesicDistance> Filter;
};

}

#endif
