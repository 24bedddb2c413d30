// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The table of solvers: what it says is what the XML offers, what solvers do and what errors tell.

#include "methods/SolverTable.h"
#include "Solving.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** The entries of the property Method in one of the project's XML files: text by number. */
std::map<int, std::string> methodsIn(const std::string& file)
{
  std::ifstream stream(GEODESICS_XML_DIRECTORY "/" + file);
  const std::string xml{ std::istreambuf_iterator<char>(stream), {} };
  const std::size_t first = xml.find("<IntVectorProperty name=\"Method\"");
  const std::string property = xml.substr(first, xml.find("</IntVectorProperty>", first) - first);
  const std::regex entry("<Entry value=\"([0-9]+)\" text=\"([A-Za-z]+)\"");
  std::map<int, std::string> methods;
  for (std::sregex_iterator i(property.begin(), property.end(), entry); i != std::sregex_iterator();
       ++i)
  {
    methods[std::stoi((*i)[1])] = (*i)[2];
  }
  return methods;
}

/** A solver that can do nothing but measure. */
SolverTraits plainSolver()
{
  SolverTraits solver = solverOfName("FastMarching");
  solver.name = "Plain";
  solver.takesCosts = false;
  solver.takesBarriers = false;
  solver.ranks = RankSupport::None;
  return solver;
}

}

TEST(SolverTable, IsWhatTheXmlOffers)
{
  std::map<int, std::string> offered;
  for (const SolverTraits& solver : solverTable())
  {
    if (solver.isOffered)
    {
      offered[solver.number] = solver.name;
    }
  }
  EXPECT_EQ(methodsIn("GeodesicCentre.xml"), offered);
  EXPECT_EQ(methodsIn("GeodesicDistance.xml"), offered);
  EXPECT_EQ(methodsIn("GeodesicDistanceMatrix.xml"), offered);
  EXPECT_EQ(methodsIn("GeodesicPath.xml"), offered);
  EXPECT_EQ(methodsIn("GeodesicSamples.xml"), offered);
}

// State files and programs have these numbers.
TEST(SolverTable, NumbersStay)
{
  EXPECT_EQ(solverOfName("FastMarching").number, 0);
  EXPECT_EQ(solverOfName("Dijkstra").number, 1);
  EXPECT_EQ(solverOfName("VirtualSources").number, 3);
  EXPECT_EQ(solverOfName("Bounded").number, 4);
  EXPECT_EQ(solverOfInterpolator(0).name, std::string("Dijkstra"));
  EXPECT_EQ(solverOfInterpolator(1).name, std::string("FastMarching"));
  std::map<int, int> count;
  for (const SolverTraits& solver : solverTable())
  {
    EXPECT_EQ(++count[solver.number], 1) << solver.name;
  }
}

TEST(SolverTable, UnknownMethodsAreNamedWithThoseThereAre)
{
  const std::string numbers = "0 (FastMarching), 1 (Dijkstra)";
  const std::string byNumber = errorOf([] { solverOfNumber(7); });
  EXPECT_NE(byNumber.find("7"), std::string::npos) << byNumber;
  EXPECT_NE(byNumber.find(numbers), std::string::npos) << byNumber;
  const std::string byName = errorOf([] { solverOfName("Exakt"); });
  EXPECT_NE(byName.find("Exakt"), std::string::npos) << byName;
  EXPECT_NE(
    byName.find("FastMarching, Dijkstra, Exact, VirtualSources, Bounded."), std::string::npos)
    << byName;
  const std::string byInterpolator = errorOf([] { solverOfInterpolator(-1); });
  EXPECT_NE(byInterpolator.find("1 (FastMarching), 0 (Dijkstra)."), std::string::npos)
    << byInterpolator;
}

TEST(SolverTable, SaysWhatASolverCannotDoAndWhichCan)
{
  const SolverTraits plain = plainSolver();
  EXPECT_EQ(errorOf([&] { checkServes(plain, {}); }), "");
  const std::string two = "FastMarching, Dijkstra";
  for (const auto& [demands, what, who] :
    std::vector<std::tuple<SolverDemands, std::string, std::string>>{
      { { true, false, false }, "costs", two },
      { { false, true, false }, "barriers", two + ", Exact, VirtualSources, Bounded" },
      { { false, false, true }, "a surface on several ranks", two } })
  {
    const std::string error = errorOf([&, asked = demands] { checkServes(plain, asked); });
    EXPECT_EQ(
      error.find("The method Plain can't work with " + what + "; these can: " + who + "."), 0)
      << error;
    EXPECT_EQ(error.find("Aggregate Dataset") != std::string::npos, demands.isOnSeveralRanks);
    EXPECT_EQ(errorOf([asked = demands] { checkServes(solverOfName("Dijkstra"), asked); }), "");
  }
}

// Each solver does on a plane what it says: across faces straight lines, along edges none shorter.
TEST(SolverTable, EachSolverMeasures)
{
  const Surface plane = planeGrid(20, 20, 1.0, 1.0);
  const auto mesh = meshOf(plane);
  const Seed seed = seedAt(*mesh, 0);
  // For Bounded, which promises nothing smaller than that.
  SolveOptions options;
  options.tolerance = 1e-13;
  for (const SolverTraits& traits : solverTable())
  {
    const auto solver = traits.make(mesh);
    const DistanceField& field = solver->solve({ &seed, 1 }, options);
    for (Index i = 0; i < plane.points.size(); ++i)
    {
      const double straight = norm(plane.points[i] - plane.points[0]);
      const double d = field.distance(mesh->vertexOfPoint(i));
      ASSERT_GE(d, straight - 1e-12) << traits.name;
      ASSERT_LE(d, straight * (traits.crossesFaces ? 1.0 : 1.5) + 1e-12) << traits.name;
    }
  }
}
