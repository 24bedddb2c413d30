// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_examples_SurfaceFile_h
#define geodesic_examples_SurfaceFile_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace geodesic::examples
{

/** @throws std::runtime_error if there is no such file */
void requireFile(const std::string& file);

/**
 * Reads a surface from a .vtp file.
 * @throws std::runtime_error if the file cannot be read, or holds no surface
 */
vtkSmartPointer<vtkPolyData> readSurface(const std::string& file);

/**
 * Writes a surface to a .vtp file.
 * @throws std::runtime_error if the file cannot be written
 */
void writeSurface(vtkPolyData* surface, const std::string& file);

}

#endif
