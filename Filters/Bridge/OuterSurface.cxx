// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OuterSurface.h"

#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGeometryFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGridBase.h"

#include <mutex>
#include <utility>
#include <vector>

namespace geodesic::bridge
{
namespace
{

/** Modification times are never used twice, so a reused address does not matter. */
using Identity = std::pair<vtkDataSet*, vtkMTimeType>;

struct Known
{
  Identity identity;
  std::weak_ptr<vtkPolyData> surface;
};

template <class Filter>
std::shared_ptr<vtkPolyData> extracted(vtkDataSet* data)
{
  vtkNew<Filter> filter;
  filter->PassThroughPointIdsOn();
  filter->PassThroughCellIdsOn();
  filter->SetInputDataObject(data);
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  surface->Register(nullptr);
  return { surface, [](vtkPolyData* s) { s->UnRegister(nullptr); } };
}

}

std::shared_ptr<vtkPolyData> outerSurfaceOf(vtkDataSet* data)
{
  static std::mutex mutex;
  static std::vector<Known> known;
  const Identity identity(data, data->GetMTime());
  const std::lock_guard lock(mutex);
  std::erase_if(known, [](const Known& k) { return k.surface.expired(); });
  for (const Known& k : known)
  {
    const auto surface = k.surface.lock();
    if (k.identity == identity && surface)
    {
      return surface;
    }
  }
  // Of an image the first would give six sheets that share no points; of a grid the second leaves
  // holes beside hidden cells.
  auto surface = vtkUnstructuredGridBase::SafeDownCast(data)
    ? extracted<vtkDataSetSurfaceFilter>(data)
    : extracted<vtkGeometryFilter>(data);
  known.push_back({ identity, surface });
  return surface;
}

}
