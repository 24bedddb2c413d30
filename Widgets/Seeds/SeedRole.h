// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_SeedRole_h
#define seeds_SeedRole_h

#include <QColor>
#include <QString>
#include <QStringList>

class vtkPVXMLElement;

namespace seeds
{

/**
 * The role of the points of a property group, which the group's hints give:
 *
 *   <Hints>
 *     <SurfaceSeeds role="seed" color="0.9 0.3 0.1" joined="0" />
 *   </Hints>
 */
struct SeedRole
{
  /** The word for one point in the panel's texts. */
  QString name = "seed";
  /** The colour of the markers. */
  QColor color = QColor::fromRgbF(0.9, 0.3, 0.1);
  /** Whether lines join the points in their order while the filter's result is not up to date. */
  bool isJoined = false;

  /** The properties of the filter that also give such points. */
  QStringList others;
  /** The property of the filter that names its array of distances; empty if it makes none. */
  QByteArray distances;
  /** The cell array that numbers the segments of a path through the points; empty if there is none.
   */
  QByteArray segments;

  QString plural() const { return this->name + "s"; }

  /** Reads the hints, which may be null. What they leave out has the defaults above. */
  static SeedRole fromHints(vtkPVXMLElement* hints);
};

}

#endif
