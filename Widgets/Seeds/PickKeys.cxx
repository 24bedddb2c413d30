// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PickKeys.h"

#include "pqKeySequences.h"
#include "pqModalShortcut.h"
#include "pqPropertyWidget.h"
#include "pqRenderView.h"
#include "pqShortcutDecorator.h"

#include <QApplication>

namespace seeds
{

PickKeys::PickKeys(pqPropertyWidget* panel)
  : QObject(panel)
  , Panel(panel)
{
  auto* decorator = new pqShortcutDecorator(panel);
  const std::pair<const char*, SurfaceProbe::Snap> keys[] = {
    { "P", SurfaceProbe::Snap::ToSurface }, { "Ctrl+P", SurfaceProbe::Snap::ToMeshPoint }
  };
  for (const auto& [key, snap] : keys)
  {
    auto* shortcut = pqKeySequences::instance().addModalShortcut(QKeySequence(key), nullptr, panel);
    decorator->addShortcut(shortcut);
    this->Keys.append(shortcut);
    this->connect(shortcut, &pqModalShortcut::activated, this,
      [this, snap = snap] { Q_EMIT this->pressed(snap); });
  }
  this->giveUp();
  // A decorator's frame gets its colour by the object's name, which the panel sets later.
  panel->setFrameShape(QFrame::NoFrame);
}

void PickKeys::setView(pqRenderView* view)
{
  for (pqModalShortcut* key : this->Keys)
  {
    key->setContextWidget(view->widget());
  }
}

void PickKeys::take()
{
  if (!this->Panel->isVisible())
  {
    return;
  }
  // Enabling the keys moves the focus to the view, so it is set back.
  QWidget* focus = QApplication::focusWidget();
  this->Keys.front()->setEnabled(true);
  if (focus && this->Panel->isAncestorOf(focus))
  {
    focus->setFocus();
  }
}

void PickKeys::giveUp()
{
  this->Keys.front()->setEnabled(false);
}

}
