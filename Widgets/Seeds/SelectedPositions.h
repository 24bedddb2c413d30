// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SelectedPositions_h
#define seeds_SelectedPositions_h

#include "Position.h"

#include <QVector>

namespace seeds
{

/**
 * Where ParaView's active selection is: its points, or the centres of its cells. Empty where
 * nothing is selected.
 */
QVector<Position> selectedPositions();

}

#endif
