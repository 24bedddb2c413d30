// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibleWidth.h"

#include <QEvent>
#include <QLayout>
#include <QScrollArea>
#include <QTimer>

#include <algorithm>

namespace seeds
{

VisibleWidth::VisibleWidth(QWidget* inner, QWidget* outer)
  : QObject(outer)
  , Inner(inner)
  , Outer(outer)
{
  outer->installEventFilter(this);
}

bool VisibleWidth::eventFilter(QObject* object, QEvent* event)
{
  if (event->type() == QEvent::Show && !this->Area)
  {
    QWidget* above = this->Outer;
    while (above && !qobject_cast<QScrollArea*>(above))
    {
      above = above->parentWidget();
    }
    this->Area = qobject_cast<QScrollArea*>(above);
    if (this->Area)
    {
      this->Area->viewport()->installEventFilter(this);
    }
  }
  if (event->type() == QEvent::Show || event->type() == QEvent::Resize)
  {
    // After the layouts that run now.
    QTimer::singleShot(0, this, &VisibleWidth::fit);
  }
  return QObject::eventFilter(object, event);
}

void VisibleWidth::fit()
{
  if (!this->Area || !this->Area->isAncestorOf(this->Outer))
  {
    return;
  }
  const int left = this->Outer->mapTo(this->Area->widget(), QPoint()).x();
  const int seen = this->Area->viewport()->width() - left;
  const int frame = this->Outer->width() - this->Outer->contentsRect().width();
  // Together with its least width the margin must be seen, or it would keep the panel wide.
  const int room = std::max(seen - frame - this->Inner->minimumSizeHint().width(), 0);
  this->Outer->layout()->setContentsMargins(
    0, 0, std::clamp(this->Outer->width() - seen, 0, room), 0);
}

}
