// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include <charconv>
#include <cmath>
#include <iostream>
#include <stdexcept>

namespace geodesic::examples
{
namespace
{

template <class Number>
bool isNumber(const std::string& text, Number& number)
{
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end;
}

}

double numberIn(const std::string& text, const std::string& name)
{
  double number = 0.0;
  if (!isNumber(text, number) || !std::isfinite(number))
  {
    throw std::invalid_argument(name + " is \"" + text + "\", which is no number.");
  }
  return number;
}

Arguments::Arguments(std::string usage)
  : Usage(std::move(usage))
{
  using Parser = vtksys::CommandLineArguments;
  this->addFlag("--help", this->AsksForHelp, "This text.");
  this->Parser.AddArgument("--seed", Parser::SPACE_ARGUMENT, &this->Seeds,
    "The id of a point, instead of a click there. May be given several times.");
  this->addText("--events", this->Options.events, "Plays the mouse and keys of a file.");
  this->addText("--record", this->Options.record, "Records mouse and keys to a file.");
  this->addText("--screenshot", this->Options.screenshot,
    "Writes a picture (PNG). With this, --seed or --events the program ends by itself.");
}

void Arguments::addFlag(const char* name, bool& flag, const char* help)
{
  this->Parser.AddArgument(name, vtksys::CommandLineArguments::NO_ARGUMENT, &flag, help);
}

void Arguments::addText(const char* name, std::string& text, const char* help)
{
  this->Parser.AddArgument(name, vtksys::CommandLineArguments::SPACE_ARGUMENT, &text, help);
}

bool Arguments::parse(int argc, char* argv[], std::size_t fewest, std::size_t most)
{
  this->Parser.Initialize(argc, argv);
  this->Parser.StoreUnusedArguments(true);
  const bool isComplete = this->Parser.Parse();
  if (this->AsksForHelp)
  {
    std::cout << this->Usage << "\n" << this->Parser.GetHelp();
    return false;
  }
  if (!isComplete)
  {
    throw std::invalid_argument(std::string(argv[argc - 1]) + " needs a value after it.");
  }
  int count = 0;
  char** unused = nullptr;
  this->Parser.GetUnusedArguments(&count, &unused);
  // The first argument is the program's name.
  this->Positional.assign(unused + 1, unused + count);
  this->Parser.DeleteRemainingArguments(count, &unused);
  for (const std::string& argument : this->Positional)
  {
    if (argument.starts_with("--"))
    {
      throw std::invalid_argument("The argument " + argument + " is not known.");
    }
  }
  const std::size_t given = this->Positional.size();
  if (given < fewest || given > most)
  {
    const std::string upTo = fewest == most ? "" : " to " + std::to_string(most);
    throw std::invalid_argument("Arguments given: " + std::to_string(given) +
      ", needed: " + std::to_string(fewest) + upTo + ".");
  }
  return true;
}

RunOptions Arguments::runOptions() const
{
  RunOptions options = this->Options;
  for (const std::string& seed : this->Seeds)
  {
    vtkIdType id = 0;
    if (!isNumber(seed, id))
    {
      throw std::invalid_argument("--seed is \"" + seed + "\", which is no point id.");
    }
    options.seeds.push_back(id);
  }
  return options;
}

}
