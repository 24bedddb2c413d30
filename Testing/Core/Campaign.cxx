// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// usage: PromiseCampaign FIRST COUNT
// Holds all solvers to their promises (Promises.h) on as many nasty cases, beginning with case
// FIRST. Prints what is broken, and the counts; fails if anything is broken.

#include "NastyCases.h"
#include "Promises.h"

#include <cstdio>
#include <cstdlib>

int main(int count, char** values)
{
  using namespace geodesic::testing;
  if (count != 3)
  {
    std::fputs("usage: PromiseCampaign FIRST COUNT\n", stderr);
    return EXIT_FAILURE;
  }
  const auto first = static_cast<unsigned>(std::strtoul(values[1], nullptr, 10));
  const auto cases = static_cast<unsigned>(std::strtoul(values[2], nullptr, 10));
  PromiseReport report;
  for (unsigned number = first; number < first + cases; ++number)
  {
    const std::size_t before = report.broken.size();
    const NastyCase test = nastyCase(number);
    checkPromises(test, report);
    for (std::size_t i = before; i < report.broken.size(); ++i)
    {
      std::printf(
        "case %u (%s): %s\n", number, test.description().c_str(), report.broken[i].c_str());
    }
    std::fflush(stdout);
  }
  std::printf(
    "%zu cases, %zu surfaces refused, %zu fields, %zu requests refused, %zu at the budget "
    "of updates, %zu settled only roughly, %zu paths, %zu comparisons, at most %zu steps in a run, "
    "%zu promises "
    "broken\n",
    report.cases, report.refusedSurfaces, report.solves, report.refusedRequests,
    report.budgetsReached, report.roughFields, report.paths, report.comparisons, report.mostSteps,
    report.broken.size());
  return report.broken.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}
