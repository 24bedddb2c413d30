// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorNote.h"

#include "pqPropertyWidget.h"
#include "pqProxyWidget.h"
#include "vtkSMProxy.h"

#include <QEvent>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>

#include <algorithm>

namespace seeds
{
namespace
{

template <class Ancestor>
Ancestor* ancestorOf(QWidget* widget)
{
  while (widget && !qobject_cast<Ancestor*>(widget))
  {
    widget = widget->parentWidget();
  }
  return qobject_cast<Ancestor*>(widget);
}

/** Narrower text is not read any more. */
constexpr int LeastWidth = 80;

}

ErrorNote::ErrorNote(pqPropertyWidget* widget, const QString& message)
  : QLabel(message, widget)
  , Widget(widget)
  , Margins(widget->contentsMargins())
{
  this->setObjectName("Error");
  this->setTextFormat(Qt::PlainText);
  this->setWordWrap(true);
  this->setStyleSheet(styleFor(widget));
  this->connect(widget, &pqPropertyWidget::changeAvailable, this, &ErrorNote::dismiss);
  widget->installEventFilter(this);
  if (auto* area = ancestorOf<QScrollArea>(widget))
  {
    area->viewport()->installEventFilter(this);
  }
  this->place();
  this->show();
  // Once the panel has made room for it.
  QTimer::singleShot(0, this,
    [this]
    {
      if (auto* area = ancestorOf<QScrollArea>(this))
      {
        const int x = area->horizontalScrollBar()->value();
        for (const int y : { this->height(), -this->y() })
        {
          area->ensureVisible(x, this->mapTo(area->widget(), QPoint(0, y)).y(), 0, 8);
        }
      }
    });
}

void ErrorNote::dismiss()
{
  this->hide();
  this->deleteLater();
  this->Widget->setContentsMargins(this->Margins);
  this->Widget->removeEventFilter(this);
  this->Widget = nullptr;
}

ErrorNote::~ErrorNote()
{
  if (this->Widget)
  {
    this->Widget->setContentsMargins(this->Margins);
  }
}

pqPropertyWidget* ErrorNote::namedWidget(pqPropertyWidget* sibling, const QString& message)
{
  auto* panel = ancestorOf<pqProxyWidget>(sibling);
  const auto widgets =
    panel ? panel->findChildren<pqPropertyWidget*>() : QList<pqPropertyWidget*>();
  static const QRegularExpression word("\\b[A-Z]\\w+");
  auto words = word.globalMatch(message);
  while (words.hasNext())
  {
    const QString name = words.next().captured();
    vtkSMProperty* property = sibling->proxy()->GetProperty(qPrintable(name));
    for (pqPropertyWidget* widget : widgets)
    {
      if (property && widget->property() == property && widget->isVisibleTo(panel))
      {
        return widget;
      }
    }
    if (property)
    {
      return nullptr;
    }
  }
  return nullptr;
}

QString ErrorNote::styleFor(const QWidget* widget)
{
  const bool isDark = widget->palette().color(QPalette::Window).lightness() < 128;
  // Qt 6 paints no border of border-left alone.
  return QString("QLabel { color: %1; border: 0px solid %1; border-left-width: 3px;"
                 " padding: 2px 0 2px 4px; }")
    .arg(isDark ? "#ff8a80" : "#b71c1c");
}

bool ErrorNote::eventFilter(QObject* object, QEvent* event)
{
  if (event->type() == QEvent::Resize)
  {
    // Within a layout's run the layout would not notice that the margins change.
    QTimer::singleShot(0, this, &ErrorNote::place);
  }
  return QLabel::eventFilter(object, event);
}

int ErrorNote::seenWidth() const
{
  const int width = this->Widget->width();
  const auto* area = ancestorOf<QScrollArea>(this->Widget);
  if (!area)
  {
    return width;
  }
  const int left = this->Widget->mapTo(area->widget(), QPoint(0, 0)).x();
  return std::clamp(area->viewport()->width() - left, std::min(width, LeastWidth), width);
}

void ErrorNote::place()
{
  if (!this->Widget)
  {
    return;
  }
  const int width = this->seenWidth();
  const int height = this->heightForWidth(width);
  QMargins margins = this->Margins;
  margins.setBottom(margins.bottom() + height);
  this->Widget->setContentsMargins(margins);
  this->setGeometry(0, this->Widget->height() - this->Margins.bottom() - height, width, height);
}

}
