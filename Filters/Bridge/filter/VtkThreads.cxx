// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "filter/VtkThreads.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace geodesic::bridge
{

int threadsOfVtk()
{
  return std::max(vtkSMPTools::GetEstimatedNumberOfThreads(), 1);
}

}
