// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_InputTimes_h
#define geodesic_bridge_InputTimes_h

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <vector>

namespace geodesic::bridge
{

/**
 * Gives a filter's output the time steps of all its inputs. By itself VTK takes those of the first,
 * and runs a filter at another time only if its output has times: seeds that move on a surface at
 * rest would stay where they are. To be called in RequestInformation().
 */
inline void takeTimesOfInputs(
  int numberOfPorts, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  std::vector<double> steps;
  std::vector<double> ends;
  const auto append = [](vtkInformation* from, auto* key, std::vector<double>& to)
  {
    if (from->Has(key))
    {
      to.insert(to.end(), from->Get(key), from->Get(key) + from->Length(key));
    }
  };
  for (int port = 0; port < numberOfPorts; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      append(inputs[port]->GetInformationObject(i), Pipeline::TIME_STEPS(), steps);
      append(inputs[port]->GetInformationObject(i), Pipeline::TIME_RANGE(), ends);
    }
  }
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  vtkInformation* output = outputs->GetInformationObject(0);
  if (!steps.empty())
  {
    output->Set(Pipeline::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
  }
  if (!ends.empty())
  {
    const auto [first, last] = std::minmax_element(ends.begin(), ends.end());
    const std::array range{ *first, *last };
    output->Set(Pipeline::TIME_RANGE(), range.data(), 2);
  }
}

}

#endif
