// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BandsRow.h"

#include "ColorBands.h"
#include "ParaViewVersions.h"
#include "PointText.h"
#include "ResultNumbers.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqDoubleLineEdit.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkCommand.h"
#include "vtkEventQtSlotConnect.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

namespace seeds
{

BandsRow::BandsRow(vtkSMProxy* filter, const char* arrayName, QWidget* parent)
  : QWidget(parent)
  , Filter(filter)
  , NameProperty(arrayName)
{
  this->Box = new QCheckBox(tr("Colour in bands of"), this);
  this->Box->setObjectName("Bands");
  this->Edit = new pqDoubleLineEdit(this);
  this->Edit->setObjectName("Spacing");
  for (QWidget* widget : { static_cast<QWidget*>(this->Box), static_cast<QWidget*>(this->Edit) })
  {
    widget->setToolTip(tr(
      "Give one colour to all distances between two multiples of this width. The width is in the "
      "unit of length of the data. This changes only the colour map, not the distances."));
  }
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->Box);
  row->addWidget(this->Edit, 1);

  this->WhenIdle.setSingleShot(true);
  this->WhenIdle.setInterval(0);
  this->connect(&this->WhenIdle, &QTimer::timeout, this, &BandsRow::writeMap);
  this->connect(this->Box, &QCheckBox::toggled, this, &BandsRow::toggle);
  this->connect(
    this->Edit, &pqLineEdit::textChangedAndEditingFinished, this, &BandsRow::takeSpacing);
  this->showLargest(0.0);
}

BandsRow::~BandsRow() = default;

void BandsRow::setView(pqView* view)
{
  this->View = view;
}

void BandsRow::showLargest(double largest)
{
  this->Largest = largest;
  this->setEnabled(largest > 0.0);
  if (this->Box->isChecked())
  {
    this->WhenIdle.start();
  }
  else if (largest > 0.0)
  {
    this->showSpacing(bands::roundSpacing(largest));
  }
}

void BandsRow::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  this->readMap();
}

pqDataRepresentation* BandsRow::shown() const
{
  auto* source =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
      this->Filter.Get());
  pqDataRepresentation* representation =
    source ? source->getOutputPort(0)->getRepresentation(this->View) : nullptr;
  const bool isColoured = representation &&
    this->arrayName() ==
      vtkSMPropertyHelper(representation->getProxy(), "ColorArrayName", true).GetAsString(4);
  return isColoured ? representation : nullptr;
}

QByteArray BandsRow::arrayName() const
{
  return vtkSMPropertyHelper(this->Filter, this->NameProperty.constData()).GetAsString();
}

vtkSMProxy* BandsRow::findMap() const
{
  const QByteArray array = this->arrayName();
  if (array.isEmpty())
  {
    return nullptr;
  }
  // A representation may have a map of its own.
  if (pqDataRepresentation* representation = this->shown())
  {
    return representation->getLookupTableProxy();
  }
  vtkNew<vtkSMTransferFunctionManager> maps;
  return maps->GetColorTransferFunction(array.constData(), this->Filter->GetSessionProxyManager());
}

void BandsRow::toggle(bool isOn)
{
  vtkSMProxy* map = this->findMap();
  if (!map)
  {
    return;
  }
  SCOPED_UNDO_SET(tr("Colour in bands"));
  if (isOn)
  {
    bands::set(map, this->Spacing, this->Largest);
    this->watch(map);
    if (pqDataRepresentation* representation = this->shown())
    {
      showLegend(representation->getProxy(), this->View->getProxy());
    }
  }
  else
  {
    this->MapEvents->Disconnect();
    bands::clear(map);
  }
  this->labelLegend(map);
  pqApplicationCore::instance()->render();
}

void BandsRow::labelLegend(vtkSMProxy* map) const
{
  vtkSMProxy* view = this->View ? this->View->getProxy() : nullptr;
  if (vtkSMProxy* legend = vtkSMTransferFunctionProxy::FindScalarBarRepresentation(map, view))
  {
    bands::label(legend, map);
  }
}

void BandsRow::watch(vtkSMProxy* map)
{
  this->MapEvents->Disconnect();
  this->MapEvents->Connect(map, vtkCommand::PropertyModifiedEvent, &this->WhenIdle, SLOT(start()));
}

void BandsRow::takeSpacing()
{
  const double spacing = this->Edit->text().toDouble();
  if (!(spacing > 0.0) || bands::numberOf(spacing, this->Largest) > bands::Most)
  {
    this->refuse(spacing);
    this->showSpacing(this->Spacing);
    return;
  }
  this->Spacing = spacing;
  if (this->Box->isChecked())
  {
    this->toggle(true);
  }
}

void BandsRow::refuse(double spacing)
{
  Q_EMIT this->refused(spacing > 0.0
      ? tr("Bands of %1 are too narrow for distances up to %2: give at least %3")
          .arg(exactText(spacing), lengthText(this->Largest),
            lengthText(bands::roundSpacing(this->Largest / 10.0)))
      : tr("The width of bands must be above 0, not %1").arg(exactText(spacing)));
}

void BandsRow::readMap()
{
  vtkSMProxy* map = this->Largest > 0.0 ? this->findMap() : nullptr;
  const double spacing = map ? bands::spacingOf(map) : 0.0;
  const QSignalBlocker blocker(this->Box);
  this->Box->setChecked(spacing > 0.0);
  if (spacing > 0.0)
  {
    this->showSpacing(spacing);
    this->watch(map);
  }
}

void BandsRow::writeMap()
{
  vtkSMProxy* map = this->findMap();
  if (!map || !this->Box->isChecked() || !(this->Largest > 0.0))
  {
    return;
  }
  if (bands::numberOf(this->Spacing, this->Largest) > bands::Most)
  {
    this->refuse(this->Spacing);
    this->Box->setChecked(false);
    return;
  }
  SCOPED_UNDO_EXCLUDE();
  if (bands::set(map, this->Spacing, this->Largest))
  {
    this->labelLegend(map);
    pqApplicationCore::instance()->render();
  }
}

void BandsRow::showSpacing(double spacing)
{
  this->Spacing = spacing;
  this->Edit->setTextAndResetCursor(exactText(spacing));
}

}
