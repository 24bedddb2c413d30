// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/TupleRuns.h"

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"

#include <numeric>

namespace geodesic::bridge
{

void TupleRuns::add(vtkIdType first, vtkIdType count)
{
  if (count == 0)
  {
    return;
  }
  this->Size += count;
  if (!this->Runs.empty() && this->Runs.back().first + this->Runs.back().count == first)
  {
    this->Runs.back().count += count;
  }
  else
  {
    this->Runs.push_back({ first, count });
  }
}

void TupleRuns::writeSources(vtkIdType* sources) const
{
  for (const Run& run : this->Runs)
  {
    std::iota(sources, sources + run.count, run.first);
    sources += run.count;
  }
}

vtkSmartPointer<vtkAbstractArray> TupleRuns::copied(vtkAbstractArray* input, vtkIdType more) const
{
  auto output = vtkSmartPointer<vtkAbstractArray>::Take(input->NewInstance());
  output->SetName(input->GetName());
  output->SetNumberOfComponents(input->GetNumberOfComponents());
  output->CopyComponentNames(input);
  output->SetNumberOfTuples(this->Size + more);
  vtkIdType place = 0;
  for (const Run& run : this->Runs)
  {
    output->InsertTuples(place, run.count, run.first, input);
    place += run.count;
  }
  return output;
}

void TupleRuns::copyArrays(
  vtkDataSetAttributes& input, vtkDataSetAttributes& output, vtkIdType more) const
{
  output.Initialize();
  for (int i = 0; i < input.GetNumberOfArrays(); ++i)
  {
    // Not by SetAttribute(): arrays without a name have an index only.
    output.AddArray(this->copied(input.GetAbstractArray(i), more));
    const int attribute = input.IsArrayAnAttribute(i);
    if (attribute >= 0)
    {
      output.SetActiveAttribute(output.GetNumberOfArrays() - 1, attribute);
    }
  }
}

}
