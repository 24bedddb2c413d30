// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedRole_h
#define seeds_SeedRole_h

#include <QColor>
#include <QString>

class vtkPVXMLElement;

namespace seeds
{

/**
 * What the points of a property group are, from its hints:
 *
 *   <Hints>
 *     <SurfaceSeeds role="seed" color="0.9 0.3 0.1" joined="0" />
 *   </Hints>
 */
struct SeedRole
{
  /** A word for one of them, as it stands in the panel's sentences. */
  QString name = "seed";
  /** Of the markers. */
  QColor color = QColor::fromRgbF(0.9, 0.3, 0.1);
  /** Whether they are joined by lines in their order, while the filter's result is not. */
  bool isJoined = false;

  QString plural() const { return this->name + "s"; }

  /** The defaults above stand for what the hints leave out, and for null. */
  static SeedRole fromHints(vtkPVXMLElement* hints);
};

}

#endif
