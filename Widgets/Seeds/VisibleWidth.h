// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_VisibleWidth_h
#define seeds_VisibleWidth_h

#include <QObject>

class QScrollArea;
class QWidget;

namespace seeds
{

/**
 * Keeps the only widget in another one as narrow as the scroll area around both shows. Where
 * ParaView's panel is narrower than its widest row, all of it would be wider than what is seen.
 */
class VisibleWidth : public QObject
{
  Q_OBJECT

public:
  /**
   * @param inner  the only widget in the layout of @p outer
   * @param outer  a widget that will be in a scroll area
   */
  VisibleWidth(QWidget* inner, QWidget* outer);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  void fit();

  QWidget* Inner;
  QWidget* Outer;
  QScrollArea* Area = nullptr;
};

}

#endif
