// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSeedsWidget.h"

#include "BandsRow.h"
#include "ErrorNote.h"
#include "LiveUpdate.h"
#include "OtherSources.h"
#include "PathProbe.h"
#include "PickKeys.h"
#include "ResultNumbers.h"
#include "SeedEditor.h"
#include "SeedHint.h"
#include "SeedMenu.h"
#include "SeedOverlay.h"
#include "SeedPanel.h"
#include "SeedPicker.h"
#include "SeedRole.h"
#include "SeedTableModel.h"
#include "SeedTableView.h"
#include "ShownSurface.h"
#include "SurfaceProbe.h"
#include "ViewNumbers.h"
#include "VisibleWidth.h"

#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "vtkMatrix4x4.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMProxy.h"

#include <QKeyEvent>
#include <QLabel>
#include <QPointer>
#include <QVBoxLayout>

using namespace seeds;

namespace
{

/** The widget that is picking; only one picks at a time. */
QPointer<SurfaceSeedsWidget> Picking;

}

struct SurfaceSeedsWidget::Internals
{
  Internals(vtkSMProxy* proxy, vtkSMPropertyGroup* group)
    : Role(SeedRole::fromHints(group->GetHints()))
    , Surface(proxy, group->GetProperty("Input"))
    , Probe(proxy, this->Surface)
    , Path(proxy, this->Surface, this->Role.segments)
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
  /** The values of the table that Result is of. */
  QVector<double> ValuesOfResult;
  /** In the widget of another property; null if there is no error, or the property has changed. */
  QPointer<ErrorNote> Error;
  /** Null if the filter makes no distances. */
  BandsRow* Bands = nullptr;
  OtherSources Others;
  std::unique_ptr<SeedEditor> Editor;
  std::unique_ptr<ViewNumbers> Numbers;
  PickKeys* Keys = nullptr;

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
    // The group is another plugin's, so it must not end the program.
    const QString complaint =
      tr("The property group %1 of %2 can't be shown: the panel widget SurfaceSeeds needs a "
         "DoubleVectorProperty with function=\"Positions\" and an InputProperty with "
         "function=\"Input\" in it.")
        .arg(group->GetXMLLabel(), proxy->GetXMLName());
    qCritical("%s", qUtf8Printable(complaint));
    auto* label = new QLabel(complaint, this);
    label->setWordWrap(true);
    (new QVBoxLayout(this))->addWidget(label);
    return;
  }
  this->Internal = std::make_unique<Internals>(proxy, group);
  Internals& my = *this->Internal;
  my.Panel = new SeedPanel(&my.Model, my.Role, this);
  my.Panel->setObjectName("Panel");
  my.Editor = std::make_unique<SeedEditor>(
    proxy, property, group->GetProperty("Dragged"), my.Model, my.Panel, my.Surface);
  my.Numbers =
    std::make_unique<ViewNumbers>(proxy, my.Role.distances, my.Surface, my.Probe, my.Panel->menu());
  my.Keys = new PickKeys(this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(my.Panel);
  new VisibleWidth(my.Panel, this);
  if (!my.Role.distances.isEmpty())
  {
    my.Bands = new BandsRow(proxy, my.Role.distances.constData(), my.Panel);
    my.Bands->setObjectName("Bands");
    my.Panel->addRow(my.Bands);
    this->connect(my.Bands, &BandsRow::refused, my.Panel->hint(), &SeedHint::complain);
  }
  // A drag is finished only when the button is released.
  this->setChangeAvailableAsChangeFinished(false);
  this->connectPanel();
  this->addPropertyLink(this, "positions", SIGNAL(positionsChanged()), property);
  this->showResult();
}

SurfaceSeedsWidget::~SurfaceSeedsWidget()
{
  if (this->Internal)
  {
    this->detach();
    delete this->Internal->Error;
  }
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
  const auto showOthers = [&my] { my.Panel->hint()->setOthers(my.Others.text()); };
  this->connect(&my.Others, &OtherSources::changed, this, showOthers);
  showOthers();
  this->connect(my.Panel, &SeedPanel::pickToggled, this, &SurfaceSeedsWidget::setPicking);
  this->connect(my.Panel->menu(), &SeedMenu::numbersToggled, this, &SurfaceSeedsWidget::showPoints);
  this->connect(my.Panel, &SeedPanel::addRequested, this,
    [this, &my]
    {
      my.Panel->table()->append({ my.Surface.center() });
      my.Panel->table()->edit(my.Panel->table()->currentIndex());
    });
  this->connect(my.Panel->table(), &SeedTableView::chosenRowsChanged, this,
    [this, &my]
    {
      my.Keys->take();
      this->showPoints();
    });
  this->connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::modifiedStateChanged, this, &SurfaceSeedsWidget::followState);
  this->connect(my.Editor.get(), &SeedEditor::moved, this,
    [this]
    {
      this->forgetLengths();
      Q_EMIT this->positionsChanged();
    });
  this->connect(my.Editor.get(), &SeedEditor::dropped, this, &SurfaceSeedsWidget::changeFinished);
  this->connect(my.Keys, &PickKeys::pressed, this,
    [&my](SurfaceProbe::Snap snap)
    {
      if (my.Picker)
      {
        my.Picker->pickUnderPointer(snap);
      }
    });
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
  if (!this->Internal)
  {
    return;
  }
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
  if (!this->Internal)
  {
    return;
  }
  this->attachTo(qobject_cast<pqRenderView*>(this->view()));
  // The first group of a panel has the keys until the user clicks another group.
  if (this->parentWidget()->findChild<SurfaceSeedsWidget*>() == this)
  {
    this->Internal->Keys->take();
  }
}

void SurfaceSeedsWidget::hideEvent(QHideEvent* event)
{
  if (this->Internal)
  {
    this->detach();
    this->Internal->Keys->giveUp();
  }
  pqPropertyGroupWidget::hideEvent(event);
}

void SurfaceSeedsWidget::keyPressEvent(QKeyEvent* event)
{
  if (this->Internal && event->key() == Qt::Key_Escape && this->Internal->Panel->isPicking())
  {
    this->Internal->Panel->setPicking(false);
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
  my.Keys->setView(view);
  my.Numbers->setView(view, my.Overlay);
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
  my.Editor->follow(picker, my.View, my.Overlay);
  this->connect(picker, &SeedPicker::offered, my.Panel->hint(), &SeedHint::setOffer);
  this->connect(picker, &SeedPicker::refused, my.Panel->hint(), &SeedHint::complain);
  this->connect(picker, &SeedPicker::pointed, my.Numbers.get(), &ViewNumbers::setPointer);
  this->connect(picker, &SeedPicker::pointedAway, my.Numbers.get(),
    [&my] { my.Numbers->setPointer(std::nullopt); });
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
    my.Keys->take();
  }
  if (my.Picker)
  {
    my.Picker->setPicking(isOn);
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
  my.Overlay->setNumbered(my.Panel->menu()->isNumbered());
  this->showLines();
  my.Numbers->writeLengths();
}

void SurfaceSeedsWidget::showResult()
{
  Internals& my = *this->Internal;
  my.Result = ResultNumbers::of(this->proxy(), this->propertyGroup());
  my.ValuesOfResult = my.Model.values();
  my.Panel->showResult(my.Result);
  this->showError();
  my.Panel->showLive(LiveUpdate::isWanted(my.Result.runTime));
  my.Model.setLengths(my.Result.lengths);
  my.Path.setCounts(my.Model.numberOfPoints(), my.Result.lengths.size());
  if (my.Bands)
  {
    my.Bands->showLargest(my.Result.value);
  }
  my.Numbers->setResult(my.Result);
  my.Numbers->writeDistance();
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

void SurfaceSeedsWidget::forgetLengths()
{
  Internals& my = *this->Internal;
  my.Result = {};
  my.Panel->showResult({});
  my.Model.setLengths({});
  my.Numbers->setResult({});
}

void SurfaceSeedsWidget::followState()
{
  this->showLines();
  // Apply runs nothing where all is as in the last run, as after a change that was taken back.
  Internals& my = *this->Internal;
  if (!this->isModified() && my.Model.values() == my.ValuesOfResult)
  {
    this->showResult();
  }
}

bool SurfaceSeedsWidget::isModified() const
{
  auto* source =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
      this->proxy());
  return !source || source->modifiedState() != pqProxy::UNMODIFIED;
}

void SurfaceSeedsWidget::showLines()
{
  Internals& my = *this->Internal;
  if (my.Overlay)
  {
    my.Overlay->setJoined(my.Role.isJoined && this->isModified());
  }
}
