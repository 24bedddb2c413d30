// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pieces/DividedMesh.h"

#include <algorithm>

namespace geodesic::distributed
{

DividedMesh::DividedMesh(
  RankGroup& ranks, std::shared_ptr<const TriangleMesh> mesh, std::span<const Key> keys)
  : Mesh(std::move(mesh))
  , Shared(ranks, *this->Mesh, keys)
  , Beside(*this->Mesh, this->Shared.vertices())
{
  if (ranks.size() > 1)
  {
    this->agreeOnLongestSides(ranks);
  }
  this->chooseStep(ranks);
}

void DividedMesh::agreeOnLongestSides(RankGroup& ranks)
{
  const std::span<const float> own = this->mesh().rings().longestSides();
  this->LongestSides.assign(own.begin(), own.end());
  this->Shared.takeLargest(ranks, this->LongestSides);
}

void DividedMesh::chooseStep(RankGroup& ranks)
{
  const auto vertices = static_cast<double>(this->mesh().numberOfVertices());
  const auto shared = static_cast<double>(this->Shared.vertices().size());
  constexpr double atSharedVertex = 0.1;
  constexpr double least = 0.5;
  this->StepInEdges = std::max(least, atSharedVertex * ranks.sum(vertices) / ranks.sum(shared));
}

}
