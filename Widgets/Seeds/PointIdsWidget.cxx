// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointIdsWidget.h"

#include "pqScalarValueListPropertyWidget.h"
#include "vtkSMPropertyHelper.h"

#include <QVBoxLayout>

PointIdsWidget::PointIdsWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
  , List(new pqScalarValueListPropertyWidget(property, proxy, this))
{
  this->setShowLabel(false);
  this->List->setObjectName("ScalarValueList");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->List);
  // Before the link, so that the property gets the numbers that are shown.
  QObject::connect(this->List, &pqScalarValueListPropertyWidget::scalarsChanged, this,
    &PointIdsWidget::showAsNumbers);
  this->addPropertyLink(this->List, "scalars", SIGNAL(scalarsChanged()), property);
}

void PointIdsWidget::apply()
{
  pqPropertyWidget::apply();
  // ParaView's link leaves an id-type property as it is when the list becomes empty.
  if (this->List->scalars().isEmpty())
  {
    vtkSMPropertyHelper(this->property()).SetNumberOfElements(0);
  }
}

void PointIdsWidget::showAsNumbers()
{
  QVariantList ids = this->List->scalars();
  for (QVariant& id : ids)
  {
    // A row that was just added has no value yet.
    if (id.isValid())
    {
      id = id.toLongLong();
    }
  }
  this->List->setScalars(ids);
}
