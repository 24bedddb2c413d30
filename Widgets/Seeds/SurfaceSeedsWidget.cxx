// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSeedsWidget.h"

#include "BandsRow.h"
#include "ErrorNote.h"
#include "LiveUpdate.h"
#include "OtherSources.h"
#include "PathProbe.h"
#include "PickHistory.h"
#include "ResultNumbers.h"
#include "SeedOverlay.h"
#include "SeedPanel.h"
#include "SeedPicker.h"
#include "SeedRole.h"
#include "SeedTableModel.h"
#include "SeedTableView.h"
#include "ShownSurface.h"
#include "SurfaceProbe.h"
#include "VisibleWidth.h"

#include "pqApplicationCore.h"
#include "pqKeySequences.h"
#include "pqModalShortcut.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "pqShortcutDecorator.h"
#include "vtkMatrix4x4.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPointer>
#include <QVBoxLayout>

#include <cmath>
#include <optional>

using namespace seeds;

namespace
{

/** The widget that is picking; only one picks at a time. */
QPointer<SurfaceSeedsWidget> Picking;

}

struct SurfaceSeedsWidget::Internals
{
  Internals(vtkSMProxy* proxy, vtkSMPropertyGroup* group, vtkSMDoubleVectorProperty* property)
    : Role(SeedRole::fromHints(group->GetHints()))
    , Surface(proxy, group->GetProperty("Input"))
    , Probe(proxy, this->Surface)
    , Path(proxy, this->Surface, this->Role.segments)
    , Live(proxy, property)
    , Others(proxy, this->Role.others)
  {
  }

  SeedRole Role;
  ShownSurface Surface;
  SurfaceProbe Probe;
  PathProbe Path;
  SeedTableModel Model;
  SeedPanel* Panel = nullptr;
  ResultNumbers Result;
  /** In the widget of another property; null if there is no error, or the property has changed. */
  QPointer<ErrorNote> Error;
  /** Null if the filter makes no distances. */
  BandsRow* Bands = nullptr;
  LiveUpdate Live;
  bool IsLive = false;
  /** Where the pointer is in the view; none if it is not there, or does something else. */
  std::optional<QPointF> Pointer;
  OtherSources Others;
  PickHistory Picks;
  /** The shortcuts of P and Ctrl+P. Enabling or disabling one does the same to the other. */
  QList<QPointer<pqModalShortcut>> Keys;

  QPointer<pqRenderView> View;
  QPointer<SeedOverlay> Overlay;
  std::unique_ptr<SeedPicker> Picker;
};

SurfaceSeedsWidget::SurfaceSeedsWidget(
  vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : pqPropertyGroupWidget(proxy, group, parent)
{
  auto* property = vtkSMDoubleVectorProperty::SafeDownCast(group->GetProperty("Positions"));
  if (!property || !group->GetProperty("Input"))
  {
    qFatal("The property group of a SurfaceSeeds widget needs the functions Positions and Input.");
  }
  this->Internal = std::make_unique<Internals>(proxy, group, property);
  Internals& my = *this->Internal;
  my.Panel = new SeedPanel(&my.Model, my.Role, this);
  my.Panel->setObjectName("Panel");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(my.Panel);
  new VisibleWidth(my.Panel, this);
  if (!my.Role.distances.isEmpty())
  {
    my.Bands = new BandsRow(proxy, my.Role.distances.constData(), my.Panel);
    my.Bands->setObjectName("Bands");
    my.Panel->addRow(my.Bands);
    this->connect(my.Bands, &BandsRow::refused, my.Panel, &SeedPanel::complain);
  }
  // A drag is finished only when the button is released.
  this->setChangeAvailableAsChangeFinished(false);
  this->connectPanel();
  this->connectKeys();
  this->addPropertyLink(this, "positions", SIGNAL(positionsChanged()), property);
  this->showResult();
}

SurfaceSeedsWidget::~SurfaceSeedsWidget()
{
  this->detach();
  delete this->Internal->Error;
}

void SurfaceSeedsWidget::connectPanel()
{
  Internals& my = *this->Internal;
  this->connect(&my.Model, &SeedTableModel::edited, this,
    [this]
    {
      this->forgetLengths();
      Q_EMIT this->positionsChanged();
      Q_EMIT this->changeFinished();
    });
  this->connect(&my.Model, &QAbstractItemModel::dataChanged, this, &SurfaceSeedsWidget::showPoints);
  this->connect(&my.Model, &QAbstractItemModel::rowsRemoved, this, &SurfaceSeedsWidget::showPoints);
  for (const auto signal : { &QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved })
  {
    this->connect(&my.Model, signal, this, &SurfaceSeedsWidget::showUndo);
  }
  this->connect(&my.Model, &QAbstractItemModel::dataChanged, this, &SurfaceSeedsWidget::showUndo);
  const auto showOthers = [&my] { my.Panel->setOthers(my.Others.text()); };
  this->connect(&my.Others, &OtherSources::changed, this, showOthers);
  showOthers();
  this->connect(my.Panel, &SeedPanel::pickToggled, this, &SurfaceSeedsWidget::setPicking);
  this->connect(my.Panel, &SeedPanel::numbersToggled, this, &SurfaceSeedsWidget::showPoints);
  this->connect(my.Panel, &SeedPanel::addRequested, this,
    [this, &my]
    {
      this->add(my.Surface.center());
      my.Panel->table()->edit(my.Panel->table()->currentIndex());
    });
  this->connect(my.Panel->table(), &SeedTableView::chosenRowsChanged, this,
    [this]
    {
      this->takeKeys();
      this->showPoints();
    });
  this->connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::modifiedStateChanged, this, &SurfaceSeedsWidget::showLines);
  this->connect(my.Panel, &SeedPanel::lengthsToggled, this, &SurfaceSeedsWidget::showLabels);
  this->connect(
    my.Panel, &SeedPanel::distanceAtPointerToggled, this, &SurfaceSeedsWidget::showDistance);
  this->connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::dataUpdated, this,
    [this](pqPipelineSource* source)
    {
      if (source->getProxy() == this->proxy())
      {
        this->showResult();
      }
    });
}

void SurfaceSeedsWidget::connectKeys()
{
  Internals& my = *this->Internal;
  auto* decorator = new pqShortcutDecorator(this);
  const std::pair<const char*, SurfaceProbe::Snap> keys[] = {
    { "P", SurfaceProbe::Snap::ToSurface }, { "Ctrl+P", SurfaceProbe::Snap::ToMeshPoint }
  };
  for (const auto& [key, snap] : keys)
  {
    auto* shortcut = pqKeySequences::instance().addModalShortcut(QKeySequence(key), nullptr, this);
    decorator->addShortcut(shortcut);
    my.Keys.append(shortcut);
    this->connect(shortcut, &pqModalShortcut::activated, this,
      [&my, snap = snap]
      {
        if (my.Picker)
        {
          my.Picker->pickUnderPointer(snap);
        }
      });
  }
  my.Keys.front()->setEnabled(false);
  // A decorator's frame gets its colour by the object's name, which the panel sets later.
  this->setFrameShape(QFrame::NoFrame);
}

void SurfaceSeedsWidget::takeKeys()
{
  if (!this->isVisible())
  {
    return;
  }
  // Enabling the keys moves the focus to the view, so it is set back.
  QWidget* focus = QApplication::focusWidget();
  this->Internal->Keys.front()->setEnabled(true);
  if (focus && this->isAncestorOf(focus))
  {
    focus->setFocus();
  }
}

QList<QVariant> SurfaceSeedsWidget::positions() const
{
  QList<QVariant> positions;
  for (const double value : this->Internal->Model.values())
  {
    positions.append(value);
  }
  return positions;
}

void SurfaceSeedsWidget::setPositions(const QList<QVariant>& positions)
{
  QVector<double> values;
  for (const QVariant& position : positions)
  {
    values.append(position.toDouble());
  }
  this->Internal->Model.setValues(values);
}

void SurfaceSeedsWidget::setView(pqView* view)
{
  pqPropertyGroupWidget::setView(view);
  Internals& my = *this->Internal;
  auto* renderView = qobject_cast<pqRenderView*>(view);
  if (my.Bands)
  {
    my.Bands->setView(view);
  }
  my.Panel->setPickable(renderView);
  if (renderView != my.View)
  {
    this->detach();
    if (this->isVisible())
    {
      this->attachTo(renderView);
    }
  }
}

void SurfaceSeedsWidget::showEvent(QShowEvent* event)
{
  pqPropertyGroupWidget::showEvent(event);
  this->attachTo(qobject_cast<pqRenderView*>(this->view()));
  // The first group of a panel has the keys until the user clicks another group.
  if (this->parentWidget()->findChild<SurfaceSeedsWidget*>() == this)
  {
    this->takeKeys();
  }
}

void SurfaceSeedsWidget::hideEvent(QHideEvent* event)
{
  this->detach();
  this->Internal->Keys.front()->setEnabled(false);
  pqPropertyGroupWidget::hideEvent(event);
}

void SurfaceSeedsWidget::keyPressEvent(QKeyEvent* event)
{
  Internals& my = *this->Internal;
  if (event->key() == Qt::Key_Escape && my.Panel->isPicking())
  {
    my.Panel->setPicking(false);
    return;
  }
  pqPropertyGroupWidget::keyPressEvent(event);
}

void SurfaceSeedsWidget::attachTo(pqRenderView* view)
{
  Internals& my = *this->Internal;
  if (!view || my.Overlay || view->getProxy()->GetSession() != this->proxy()->GetSession())
  {
    return;
  }
  my.View = view;
  my.Overlay = new SeedOverlay(view, my.Role);
  my.Picker = std::make_unique<SeedPicker>(my.Probe, my.Path, view, my.Overlay);
  for (pqModalShortcut* key : my.Keys)
  {
    key->setContextWidget(view->widget());
  }
  this->connectPicker();
  this->showPoints();
}

void SurfaceSeedsWidget::detach()
{
  Internals& my = *this->Internal;
  my.Panel->setPicking(false);
  my.Picker.reset();
  delete my.Overlay;
  my.View = nullptr;
}

void SurfaceSeedsWidget::connectPicker()
{
  Internals& my = *this->Internal;
  SeedPicker* picker = my.Picker.get();
  this->connect(picker, &SeedPicker::picked, this, &SurfaceSeedsWidget::pick);
  this->connect(picker, &SeedPicker::inserted, this, &SurfaceSeedsWidget::insert);
  this->connect(picker, &SeedPicker::offered, my.Panel, &SeedPanel::setOffer);
  this->connect(picker, &SeedPicker::deleteRequested, my.Panel->table(), &SeedTableView::remove);
  this->connect(picker, &SeedPicker::undoRequested, this, &SurfaceSeedsWidget::undoPick);
  this->connect(
    picker, &SeedPicker::removed, this, [&my](int row) { my.Model.removeRows({ row }); });
  this->connect(picker, &SeedPicker::dragStarted, this, &SurfaceSeedsWidget::startDrag);
  this->connect(picker, &SeedPicker::dragged, this, &SurfaceSeedsWidget::drag);
  this->connect(picker, &SeedPicker::dragFinished, this, &SurfaceSeedsWidget::finishDrag);
  this->connect(picker, &SeedPicker::pointed, this,
    [this](const QPointF& place)
    {
      this->Internal->Pointer = place;
      this->showDistance();
    });
  this->connect(picker, &SeedPicker::pointedAway, this,
    [this]
    {
      this->Internal->Pointer.reset();
      this->showDistance();
    });
  this->connect(picker, &SeedPicker::refused, my.Panel, &SeedPanel::complain);
  this->connect(picker, &SeedPicker::escaped, this, [&my] { my.Panel->setPicking(false); });
}

void SurfaceSeedsWidget::setPicking(bool isOn)
{
  Internals& my = *this->Internal;
  if (isOn && Picking && Picking != this)
  {
    Picking->Internal->Panel->setPicking(false);
  }
  Picking = isOn ? this : nullptr;
  if (isOn)
  {
    this->takeKeys();
  }
  if (my.Picker)
  {
    my.Picker->setPicking(isOn);
  }
}

void SurfaceSeedsWidget::add(const Position& point)
{
  Internals& my = *this->Internal;
  my.Model.append({ point });
  my.Panel->table()->choose(my.Model.numberOfPoints() - 1);
}

void SurfaceSeedsWidget::pick(const Position& point)
{
  Internals& my = *this->Internal;
  const QVector<double> before = my.Model.values();
  this->add(point);
  this->notePick(before);
}

void SurfaceSeedsWidget::insert(int row, const Position& point)
{
  Internals& my = *this->Internal;
  const QVector<double> before = my.Model.values();
  my.Model.insert(row, point);
  my.Panel->table()->choose(row);
  this->notePick(before);
}

void SurfaceSeedsWidget::notePick(const QVector<double>& before)
{
  Internals& my = *this->Internal;
  my.Picks.add(before, my.Model.values());
  this->showUndo();
}

void SurfaceSeedsWidget::showUndo()
{
  Internals& my = *this->Internal;
  if (my.Picker)
  {
    my.Picker->setUndoable(my.Picks.canUndo(my.Model.values()));
  }
}

void SurfaceSeedsWidget::undoPick()
{
  Internals& my = *this->Internal;
  my.Model.replace(my.Picks.undo());
  this->showUndo();
}

void SurfaceSeedsWidget::startDrag(int row)
{
  Internals& my = *this->Internal;
  my.Panel->table()->choose(row);
  my.IsLive = my.Panel->isLive() && my.Live.isPossible();
  if (my.IsLive)
  {
    my.Live.begin();
  }
}

void SurfaceSeedsWidget::drag(int row, const Position& point)
{
  Internals& my = *this->Internal;
  // An undo during a drag can remove the row.
  if (row >= my.Model.numberOfPoints())
  {
    return;
  }
  my.Model.setPoint(row, point);
  if (my.IsLive)
  {
    my.Live.push(my.Model.values());
  }
  else
  {
    this->forgetLengths();
    Q_EMIT this->positionsChanged();
  }
}

void SurfaceSeedsWidget::finishDrag()
{
  Internals& my = *this->Internal;
  if (my.IsLive)
  {
    my.Live.finish();
  }
  else
  {
    Q_EMIT this->changeFinished();
  }
}

void SurfaceSeedsWidget::showPoints()
{
  Internals& my = *this->Internal;
  if (!my.Overlay || !my.View)
  {
    return;
  }
  const auto placement = my.Surface.placementIn(my.View);
  QVector<Position> points = my.Model.points();
  for (Position& point : points)
  {
    point = transformed(placement, point);
  }
  my.Overlay->setPoints(points, my.Surface.thickness());
  my.Overlay->setChosenRows(my.Panel->table()->chosenRows());
  my.Overlay->setNumbered(my.Panel->isNumbered());
  this->showLines();
  this->showLabels();
}

void SurfaceSeedsWidget::showResult()
{
  Internals& my = *this->Internal;
  my.Result = ResultNumbers::of(this->proxy(), this->propertyGroup());
  my.Panel->showResult(my.Result);
  this->showError();
  my.Panel->showLive(LiveUpdate::isWanted(my.Result.runTime));
  my.Model.setLengths(my.Result.lengths);
  my.Path.setCounts(my.Model.numberOfPoints(), my.Result.lengths.size());
  if (my.Bands)
  {
    my.Bands->showLargest(my.Result.value);
  }
  this->showLabels();
  this->showDistance();
}

void SurfaceSeedsWidget::showError()
{
  Internals& my = *this->Internal;
  delete my.Error;
  if (pqPropertyWidget* widget = ErrorNote::namedWidget(this, my.Result.error))
  {
    my.Error = new ErrorNote(widget, my.Result.error);
  }
  else
  {
    my.Panel->showError(my.Result.error);
  }
}

void SurfaceSeedsWidget::showDistance()
{
  Internals& my = *this->Internal;
  if (!my.Overlay || !my.View)
  {
    return;
  }
  std::optional<double> distance;
  if (my.Pointer && my.Panel->hasDistanceAtPointer())
  {
    const QByteArray array =
      vtkSMPropertyHelper(this->proxy(), my.Role.distances.constData()).GetAsString();
    distance = array.isEmpty() ? std::nullopt : my.Probe.valueAt(my.View, *my.Pointer, array);
  }
  const QString text = !distance ? QString()
    : std::isnan(*distance)      ? tr("no distance")
                                 : lengthText(*distance);
  my.Overlay->setNote(text, my.Pointer.value_or(QPointF()));
}

void SurfaceSeedsWidget::showLabels()
{
  Internals& my = *this->Internal;
  if (!my.Overlay || !my.View)
  {
    return;
  }
  QVector<Position> points;
  QStringList texts;
  if (my.Panel->hasLengthsInView() && my.Result.middles.size() == my.Result.lengths.size())
  {
    const auto placement = my.Surface.placementIn(my.View);
    for (int i = 0; i < my.Result.lengths.size(); ++i)
    {
      if (my.Result.lengths[i] >= 0.0)
      {
        points.append(transformed(placement, my.Result.middles[i]));
        texts.append(lengthText(my.Result.lengths[i]));
      }
    }
  }
  my.Overlay->setLabels(points, texts);
}

void SurfaceSeedsWidget::forgetLengths()
{
  Internals& my = *this->Internal;
  my.Result = {};
  my.Panel->showResult({});
  my.Model.setLengths({});
  this->showLabels();
}

void SurfaceSeedsWidget::showLines()
{
  Internals& my = *this->Internal;
  auto* source =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
      this->proxy());
  if (my.Overlay && source)
  {
    my.Overlay->setJoined(my.Role.isJoined && source->modifiedState() != pqProxy::UNMODIFIED);
  }
}
