// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ranks/Agreement.h"

#include "filter/ErrorMessage.h"
#include "ranks/InjectedFault.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

namespace geodesic::distributed
{

Agreement::Agreement(vtkMultiProcessController* controller)
  : Controller(controller)
{
  if (controller)
  {
    this->Size = controller->GetNumberOfProcesses();
    this->Rank = controller->GetLocalProcessId();
  }
}

void Agreement::run(const std::function<void()>& work)
{
  if (this->Size == 1)
  {
    work();
    return;
  }
  try
  {
    work();
    this->agree(Phase::End);
  }
  catch (const AgreedError&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    this->fail(bridge::messageOf(error));
  }
}

void Agreement::together(const std::function<void()>& step)
{
  if (this->Size == 1)
  {
    step();
    return;
  }
  this->runStep(step);
  this->agree(Phase::Step);
}

vtkMultiProcessController& Agreement::after(const std::function<void()>& step)
{
  try
  {
    this->runStep(step);
  }
  catch (const std::exception& error)
  {
    this->HasFailed = true;
    this->Failure = bridge::messageOf(error);
  }
  return *this->Controller;
}

void Agreement::runStep(const std::function<void()>& step)
{
  injectFault(++this->PhasesBegun);
  this->IsInStep = true;
  try
  {
    step();
  }
  catch (...)
  {
    this->IsInStep = false;
    throw;
  }
  this->IsInStep = false;
}

vtkMultiProcessController& Agreement::agree(Phase phase, std::span<double> least)
{
  if (this->IsInStep)
  {
    throw std::logic_error("A step of one rank tried to send to others.");
  }
  if (!this->HasFailed)
  {
    injectFault(++this->PhasesBegun);
  }
  // All agreements have the same size, as a rank that failed does not know what the others want.
  const auto number = static_cast<double>(phase);
  std::array<double, 3 + MostValues> own{ this->HasFailed ? 0.0 : 1.0, number, -number };
  const bool travelAlong = least.size() <= MostValues;
  if (travelAlong)
  {
    std::copy(least.begin(), least.end(), own.begin() + 3);
  }
  std::array<double, 3 + MostValues> all{};
  this->Controller->AllReduce(own.data(), all.data(), own.size(), vtkCommunicator::MIN_OP);
  const auto [allWell, lowest, minusHighest] = std::tuple(all[0], all[1], all[2]);
  if (allWell == 0.0)
  {
    this->throwFailure();
  }
  if (lowest != -minusHighest)
  {
    throw AgreedError("The ranks don't do the same: one is in phase " +
      std::to_string(static_cast<int>(lowest)) + ", another in phase " +
      std::to_string(static_cast<int>(-minusHighest)) + ". Please report this.");
  }
  if (travelAlong)
  {
    std::copy_n(all.begin() + 3, least.size(), least.begin());
  }
  else
  {
    const std::vector<double> values(least.begin(), least.end());
    this->Controller->AllReduce(
      values.data(), least.data(), static_cast<vtkIdType>(values.size()), vtkCommunicator::MIN_OP);
  }
  return *this->Controller;
}

void Agreement::fail(const std::string& message)
{
  if (!this->HasFailed)
  {
    this->HasFailed = true;
    this->Failure = message;
  }
  this->agree(Phase::End);
  // agree() has thrown, as this rank has failed.
  throw std::logic_error(message);
}

void Agreement::throwFailure()
{
  const double own = this->HasFailed ? this->Rank : this->Size;
  double first = own;
  this->Controller->AllReduce(&own, &first, 1, vtkCommunicator::MIN_OP);
  const int rank = static_cast<int>(first);
  std::string message = this->Failure;
  auto length = static_cast<vtkIdType>(message.size());
  this->Controller->Broadcast(&length, 1, rank);
  message.resize(length);
  if (length > 0)
  {
    this->Controller->Broadcast(message.data(), length, rank);
  }
  this->HasFailed = false;
  throw AgreedError(message);
}

}
