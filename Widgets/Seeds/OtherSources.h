// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_OtherSources_h
#define seeds_OtherSources_h

#include "vtkSMProxy.h"
#include "vtkSmartPointer.h"

#include <QObject>
#include <QStringList>

#include <utility>
#include <vector>

namespace seeds
{

/**
 * Tells what counts beside the points of a panel: other properties of the filter that give points,
 * which may be inputs, arrays or lists of ids. What the panel has not applied yet counts, too.
 */
class OtherSources : public QObject
{
  Q_OBJECT

public:
  /** @param names  the properties; the filter need not have all of them */
  OtherSources(vtkSMProxy* filter, const QStringList& names);
  ~OtherSources() override;

  /** In words, as "3 points of Ball (Seed Source)"; empty if there is nothing. */
  QString text() const;

Q_SIGNALS:
  void changed();

private:
  void propertyModified() { Q_EMIT this->changed(); }

  vtkSmartPointer<vtkSMProxy> Filter;
  QStringList Names;
  std::vector<std::pair<vtkSmartPointer<vtkObject>, unsigned long>> Observers;
};

}

#endif
