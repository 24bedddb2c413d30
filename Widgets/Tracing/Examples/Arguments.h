// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_examples_Arguments_h
#define geodesic_examples_Arguments_h

#include "vtkType.h"

#include <vtksys/CommandLineArguments.hxx>

#include <string>
#include <vector>

namespace geodesic::examples
{

/** The options by which a program is driven. */
struct RunOptions
{
  std::vector<vtkIdType> seeds;
  std::string events;
  std::string record;
  std::string screenshot;

  /** Whether the program runs without a user and ends by itself. */
  bool isUnattended() const
  {
    return !this->seeds.empty() || !this->events.empty() || !this->screenshot.empty();
  }
};

/**
 * Reads a number.
 * @param name name of the number in the error message
 * @throws std::invalid_argument if the text is not one finite number
 */
double numberIn(const std::string& text, const std::string& name);

/**
 * The arguments of a program: some by position and some by name, among them --help and those of
 * RunOptions.
 */
class Arguments
{
public:
  /** @param usage the first lines of the help: the arguments by position, and what is done */
  explicit Arguments(std::string usage);

  void addFlag(const char* name, bool& flag, const char* help);
  void addText(const char* name, std::string& text, const char* help);

  /**
   * @return whether the program must go on; false if it was asked for help, which has been printed
   * @throws std::invalid_argument if a name is not known or has no value, or if there are too few
   * or too many arguments by position
   */
  bool parse(int argc, char* argv[], std::size_t fewest, std::size_t most);

  /** The arguments by position. */
  const std::vector<std::string>& positional() const { return this->Positional; }
  /** @throws std::invalid_argument if a seed is not a number */
  RunOptions runOptions() const;

private:
  vtksys::CommandLineArguments Parser;
  std::string Usage;
  bool AsksForHelp = false;
  std::vector<std::string> Seeds;
  RunOptions Options;
  std::vector<std::string> Positional;
};

}

#endif
