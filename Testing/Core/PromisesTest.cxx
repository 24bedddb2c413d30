// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever the input, the right answer or a clear word; more cases: PromiseCampaign (Campaign.cxx).

#include "Promises.h"
#include "NastyCases.h"

#include <gtest/gtest.h>

#include <string>

using namespace geodesic::testing;

TEST(Promises, HoldOnNastyMeshes)
{
  PromiseReport report;
  for (unsigned number = 0; number < 2000; ++number)
  {
    const NastyCase test = nastyCase(number);
    checkPromises(test, report);
    for (const std::string& broken : report.broken)
    {
      ADD_FAILURE() << "case " << number << " (" << test.description() << "): " << broken;
    }
    report.broken.clear();
  }
  RecordProperty("fields", static_cast<int>(report.solves));
  // The cases are what they are meant to be.
  EXPECT_EQ(report.cases, 2000);
  EXPECT_GT(report.solves, 8000);
  EXPECT_GT(report.paths, 3000);
  EXPECT_GT(report.comparisons, 80000);
  EXPECT_GT(report.refusedSurfaces, 180);
  EXPECT_LT(report.refusedSurfaces, 400);
  EXPECT_LT(report.budgetsReached, 20);
}
