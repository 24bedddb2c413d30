// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_PickKeys_h
#define seeds_PickKeys_h

#include "SurfaceProbe.h"

#include <QList>
#include <QObject>
#include <QPointer>

class pqModalShortcut;
class pqPropertyWidget;
class pqRenderView;

namespace seeds
{

/**
 * The keys P and Ctrl+P, which pick under the pointer in a view. They belong to one panel at a
 * time, which has a blue frame.
 */
class PickKeys : public QObject
{
  Q_OBJECT

public:
  explicit PickKeys(pqPropertyWidget* panel);

  void setView(pqRenderView* view);
  /** Lets the panel have the keys, if it is shown. */
  void take();
  void giveUp();

Q_SIGNALS:
  void pressed(seeds::SurfaceProbe::Snap snap);

private:
  pqPropertyWidget* Panel;
  /** Enabling or disabling one does the same to the other. */
  QList<QPointer<pqModalShortcut>> Keys;
};

}

#endif
