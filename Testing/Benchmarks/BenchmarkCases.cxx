// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkCases.h"

#include <algorithm>
#include <cstdio>
#include <exception>

namespace geodesic::testing
{

Index CaseArguments::count(std::size_t i) const
{
  const auto count = static_cast<Index>(this->number(i));
  return this->tiny ? std::min<Index>(count, 50) : count;
}

void print(const std::string& name, double value)
{
  std::printf("%s %.6g\n", name.c_str(), value);
  std::fflush(stdout);
}

int runCase(const BenchmarkCases& cases, int argc, char** argv)
{
  try
  {
    CaseArguments arguments{ { argv + 1, argv + argc } };
    arguments.tiny = std::erase(arguments.words, "--tiny") > 0;
    const std::string name = arguments.word(0);
    arguments.words.erase(arguments.words.begin());
    cases.at(name)(arguments);
  }
  catch (const std::exception& exception)
  {
    std::printf("error %s\n", exception.what());
    return 1;
  }
  return 0;
}

}
