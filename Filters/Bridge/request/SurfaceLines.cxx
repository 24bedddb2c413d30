// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "request/SurfaceLines.h"

#include "march/FastMarchingSolver.h"
#include "path/SurfaceCurve.h"
#include "split/SplitMesh.h"

#include <algorithm>
#include <string>

namespace geodesic::bridge
{
namespace
{

std::vector<SurfacePath> joined(
  DistanceSolver& solver, const std::vector<LinePoints>& lines, const std::string& property)
{
  std::vector<SurfacePath> paths;
  for (const LinePoints& line : lines)
  {
    paths.push_back(
      joinedCurve(solver, line, property + "'s line " + std::to_string(paths.size())));
  }
  return paths;
}

}

void SurfaceLines::update(const std::shared_ptr<const TriangleMesh>& mesh,
  std::vector<LinePoints> seeds, std::vector<LinePoints> barriers)
{
  if (mesh == this->Mesh && seeds == this->Seeds && barriers == this->Barriers)
  {
    return;
  }
  *this = SurfaceLines();
  if (!seeds.empty() || !barriers.empty())
  {
    FastMarchingSolver solver(mesh);
    this->take(
      mesh, joined(solver, seeds, "SeedSource"), joined(solver, barriers, "BarrierSource"));
  }
  this->Mesh = mesh;
  this->Seeds = std::move(seeds);
  this->Barriers = std::move(barriers);
}

void SurfaceLines::take(const std::shared_ptr<const TriangleMesh>& mesh,
  std::vector<SurfacePath> seeds, std::vector<SurfacePath> barriers)
{
  *this = SurfaceLines();
  this->SeedPaths = std::move(seeds);
  this->BarrierPaths = std::move(barriers);
  const auto splits = [](const std::vector<SurfacePath>& paths)
  { return std::any_of(paths.begin(), paths.end(), SplitMesh::splits); };
  if (splits(this->SeedPaths) || splits(this->BarrierPaths))
  {
    this->Split = std::make_shared<const SplitMesh>(mesh, this->SeedPaths, this->BarrierPaths);
  }
}

}
