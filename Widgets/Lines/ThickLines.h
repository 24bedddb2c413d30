// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ThickLines_h
#define ThickLines_h

#include <QObject>

class pqRepresentation;

/**
 * Makes the lines in a filter's output easy to see. If the filter's proxy has the hint
 *
 *     <ThickLines width="4" />
 *
 * each new representation of its output draws lines as tubes of this width in pixels. By default
 * ParaView draws lines of one pixel, and a surface that they lie on hides about half of each.
 * Only properties with their default values are changed, and none while a state is loaded.
 */
class ThickLines : public QObject
{
  Q_OBJECT

public:
  explicit ThickLines(QObject* parent = nullptr);

  // ParaView calls startup() when it loads the plugin, and shutdown() before it unloads it.
  void startup();
  void shutdown();

private:
  void thicken(pqRepresentation* representation);
};

#endif
