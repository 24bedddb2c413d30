// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SelectedPositions_h
#define seeds_SelectedPositions_h

#include "Position.h"

#include <QVector>

namespace seeds
{

/**
 * Returns the positions of ParaView's active selection: its points, or the centres of its cells.
 * Empty if nothing is selected.
 */
QVector<Position> selectedPositions();

}

#endif
