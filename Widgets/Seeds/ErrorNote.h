// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_ErrorNote_h
#define seeds_ErrorNote_h

#include <QLabel>
#include <QPointer>

class pqPropertyWidget;

namespace seeds
{

/**
 * An error message that stands under the property that it names, in that property's own widget,
 * below its contents. It deletes itself when the property is changed.
 */
class ErrorNote : public QLabel
{
  Q_OBJECT

public:
  ErrorNote(pqPropertyWidget* widget, const QString& message);
  ~ErrorNote() override;

  /**
   * The widget of the first property that a message names, among those that are shown beside @p
   * sibling; null if there is none.
   */
  static pqPropertyWidget* namedWidget(pqPropertyWidget* sibling, const QString& message);

  /** The look of error messages, which suits a light or a dark panel. */
  static QString styleFor(const QWidget* widget);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  void dismiss();
  void place();
  /** How much of the property's widget is seen where the panel is wider than its scroll area. */
  int seenWidth() const;

  QPointer<pqPropertyWidget> Widget;
  QMargins Margins;
};

}

#endif
