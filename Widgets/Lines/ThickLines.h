// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ThickLines_h
#define ThickLines_h

#include <QObject>

class pqRepresentation;

/**
 * Shows what a filter makes of lines so that it is seen: where the filter's proxy has the hint
 *
 *     <ThickLines width="4" />
 *
 * a new representation of its output draws lines as tubes of so many pixels. ParaView's own, of one
 * pixel, vanish half on the surface that they lie on. Only defaults are changed, and none while a
 * state is loaded.
 */
class ThickLines : public QObject
{
  Q_OBJECT

public:
  explicit ThickLines(QObject* parent = nullptr);

  // Called by ParaView when the plugin is loaded, and before it is not any more.
  void startup();
  void shutdown();

private:
  void thicken(pqRepresentation* representation);
};

#endif
