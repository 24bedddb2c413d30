// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ranks/RankGroup.h"

#include "vtkMultiProcessController.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>

#include <unistd.h>

namespace geodesic::distributed
{
namespace
{

/** Tags that distinguish these messages from others on the same controller. */
constexpr int LengthTag = 81501;
constexpr int ContentTag = 81502;

/** Whether two numbers are equal; NaN is equal to NaN. */
bool areSame(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

void send(vtkMultiProcessController& controller, const RankGroup::Message& message, int partner)
{
  const auto length = static_cast<vtkIdType>(message.size());
  controller.Send(&length, 1, partner, LengthTag);
  if (length > 0)
  {
    controller.Send(message.data(), length, partner, ContentTag);
  }
}

RankGroup::Message receive(vtkMultiProcessController& controller, int partner)
{
  vtkIdType length = 0;
  controller.Receive(&length, 1, partner, LengthTag);
  RankGroup::Message message(length);
  if (length > 0)
  {
    controller.Receive(message.data(), length, partner, ContentTag);
  }
  return message;
}

/** Of two ranks, the lower one sends first. */
std::vector<RankGroup::Message> exchanged(vtkMultiProcessController& controller,
  std::span<const int> partners, const std::vector<RankGroup::Message>& messages)
{
  std::vector<RankGroup::Message> received;
  for (std::size_t i = 0; i < partners.size(); ++i)
  {
    if (controller.GetLocalProcessId() < partners[i])
    {
      send(controller, messages[i], partners[i]);
      received.push_back(receive(controller, partners[i]));
    }
    else
    {
      received.push_back(receive(controller, partners[i]));
      send(controller, messages[i], partners[i]);
    }
  }
  return received;
}

}

RankGroup::RankGroup(vtkMultiProcessController* controller)
  : Agreed(controller)
{
}

std::vector<std::vector<double>> RankGroup::gatherByRank(std::span<const double> own)
{
  if (this->size() == 1)
  {
    return { { own.begin(), own.end() } };
  }
  vtkMultiProcessController& controller = this->Agreed.agree(Phase::Gather);
  const auto length = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(this->size());
  controller.AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(this->size());
  std::exclusive_scan(lengths.begin(), lengths.end(), offsets.begin(), vtkIdType{ 0 });
  std::vector<double> all(offsets.back() + lengths.back());
  if (!all.empty())
  {
    controller.AllGatherV(own.data(), all.data(), length, lengths.data(), offsets.data());
  }
  std::vector<std::vector<double>> byRank;
  for (int rank = 0; rank < this->size(); ++rank)
  {
    const auto first = all.begin() + offsets[rank];
    byRank.emplace_back(first, first + lengths[rank]);
  }
  return byRank;
}

std::vector<double> RankGroup::gather(std::span<const double> own)
{
  std::vector<double> all;
  for (const std::vector<double>& values : this->gatherByRank(own))
  {
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

void RankGroup::takeLeast(std::span<double> values)
{
  if (this->size() > 1)
  {
    this->Agreed.agree(Phase::Least, values);
  }
}

double RankGroup::sum(double own)
{
  const std::vector<double> all = this->gather({ &own, 1 });
  return std::accumulate(all.begin(), all.end(), 0.0);
}

double RankGroup::largest(double own)
{
  double least = -own;
  this->takeLeast({ &least, 1 });
  return -least;
}

RankGroup::Message RankGroup::fromFirst(Message message)
{
  if (this->size() > 1)
  {
    vtkMultiProcessController& controller = this->Agreed.agree(Phase::FromFirst);
    auto length = static_cast<vtkIdType>(message.size());
    controller.Broadcast(&length, 1, 0);
    message.resize(length);
    if (length > 0)
    {
      controller.Broadcast(message.data(), length, 0);
    }
  }
  return message;
}

std::vector<RankGroup::Message> RankGroup::toFirst(const Message& own)
{
  if (this->size() == 1)
  {
    return { own };
  }
  vtkMultiProcessController& controller = this->Agreed.agree(Phase::ToFirst);
  const auto length = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(this->size());
  controller.Gather(&length, lengths.data(), 1, 0);
  std::vector<vtkIdType> offsets(this->size());
  std::exclusive_scan(lengths.begin(), lengths.end(), offsets.begin(), vtkIdType{ 0 });
  Message all(offsets.back() + lengths.back());
  controller.GatherV(own.data(), all.data(), length, lengths.data(), offsets.data(), 0);
  std::vector<Message> byRank;
  for (int rank = 0; this->rank() == 0 && rank < this->size(); ++rank)
  {
    const auto first = all.begin() + offsets[rank];
    byRank.emplace_back(first, first + lengths[rank]);
  }
  return byRank;
}

double RankGroup::newNumber()
{
  // Without this lock, two filters in two threads of the only rank could get the same number.
  static std::mutex mutex;
  static double last = 0.0;
  const std::lock_guard lock(mutex);
  const std::vector<double> lasts = this->gather({ &last, 1 });
  last = *std::max_element(lasts.begin(), lasts.end()) + 1.0;
  return last;
}

double RankGroup::largestCommon(std::span<const double> numbers)
{
  const auto byRank = this->gatherByRank(numbers);
  double largest = 0.0;
  for (const double number : numbers)
  {
    const bool isCommon = std::all_of(byRank.begin(), byRank.end(),
      [&](const auto& of) { return std::find(of.begin(), of.end(), number) != of.end(); });
    largest = isCommon ? std::max(largest, number) : largest;
  }
  return largest;
}

unsigned RankGroup::threadsOfThisRank()
{
  const unsigned usable = std::max(1u, std::thread::hardware_concurrency());
  if (this->size() == 1)
  {
    return usable;
  }
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  // A double holds the shifted hash exactly.
  const auto machine = static_cast<double>(std::hash<std::string>{}(name.data()) >> 12);
  const std::vector<double> machines = this->gather({ &machine, 1 });
  const auto ranks = static_cast<unsigned>(std::count(machines.begin(), machines.end(), machine));
  // A rank that is bound to some of the processors shares those with no other rank.
  const auto processors = static_cast<unsigned>(sysconf(_SC_NPROCESSORS_ONLN));
  return std::clamp(processors / ranks, 1u, usable);
}

void RankGroup::requireSame(std::span<const double> values, const std::string& what)
{
  const auto all = this->gatherByRank(values);
  const auto isOther = [&](const std::vector<double>& others)
  { return !std::equal(others.begin(), others.end(), all[0].begin(), all[0].end(), areSame); };
  const auto other = std::find_if(all.begin(), all.end(), isOther);
  if (other != all.end())
  {
    throw std::invalid_argument("The " + what + " of rank " + std::to_string(other - all.begin()) +
      " are not those of rank 0. Set the same on all ranks.");
  }
}

std::vector<int> RankGroup::others() const
{
  std::vector<int> others;
  for (int rank = 0; rank < this->size(); ++rank)
  {
    if (rank != this->rank())
    {
      others.push_back(rank);
    }
  }
  this->sort(others);
  return others;
}

void RankGroup::sort(std::vector<int>& partners) const
{
  std::sort(partners.begin(), partners.end(),
    [this](int a, int b) { return (a ^ this->rank()) < (b ^ this->rank()); });
}

std::vector<RankGroup::Message> RankGroup::exchange(
  std::span<const int> partners, const std::vector<Message>& messages)
{
  if (this->size() == 1)
  {
    return {};
  }
  return exchanged(this->Agreed.agree(Phase::Exchange), partners, messages);
}

std::vector<RankGroup::Message> RankGroup::exchangeAfter(
  std::span<const int> partners, const std::function<std::vector<Message>()>& step)
{
  std::vector<Message> messages(partners.size());
  if (this->size() == 1)
  {
    step();
    return {};
  }
  vtkMultiProcessController& controller = this->Agreed.after([&] { messages = step(); });
  return exchanged(controller, partners, messages);
}

}
