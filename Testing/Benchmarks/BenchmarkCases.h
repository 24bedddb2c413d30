// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_BenchmarkCases_h
#define geodesic_testing_BenchmarkCases_h

#include "WorstSurfaces.h"
#include "base/Index.h"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace geodesic::testing
{

/** The words after a case's name, and the size of what it runs on. */
struct CaseArguments
{
  const std::string& word(std::size_t i) const { return this->words.at(i); }
  double number(std::size_t i) const { return std::stod(this->words.at(i)); }
  /** Of a case's parts; a tiny case has fewer. */
  Index count(std::size_t i) const;
  WorstSurface surface(std::size_t i) const { return worstSurface(this->word(i), this->tiny); }

  std::vector<std::string> words;
  bool tiny = false;
};

using BenchmarkCases = std::map<std::string, std::function<void(const CaseArguments&)>>;

/** Prints a number under its name, at once. */
void print(const std::string& name, double value);

/** Runs the case that the program's first argument names; an error is printed. With --tiny it is a
 * short one. @return the program's exit code */
int runCase(const BenchmarkCases& cases, int argc, char** argv);

}

#endif
